"""Licences and sources of what DLLs have inside: python3 packaging/windows/notices.py FOLDER STATIC DUCC0.

STATIC is what static_libraries.sh and DUCC0 what packaging/ducc0/fetch.sh has made. Into FOLDER come licenses/ and SOURCES.txt.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1] / "wheels"))
from licenses import Origins

TRIPLE = "x86_64-w64-mingw32ucrt"
HEADERS = [Path("/usr/include") / name for name in ("eigen3/Eigen/Core", "nlohmann/json.hpp", "valijson/validator.hpp")]


def main() -> None:
    folder, *static = map(Path, sys.argv[1:])
    runtimes = [next(Path(f"/usr/lib/gcc/{TRIPLE}").glob("*/libstdc++.a")), Path(f"/usr/{TRIPLE}/lib/libmingw32.a")]
    origins = Origins([*HEADERS, *runtimes])
    texts = {name: text.encode() for name, text in origins.texts().items()}
    sources = origins.sources()
    for part in static:
        texts |= {f"{file.name}.txt": file.read_bytes() for file in sorted((part / "licenses").iterdir())}
        sources += (part / "sources.txt").read_text().splitlines()
    (folder / "licenses").mkdir(parents=True, exist_ok=True)
    for name, text in texts.items():
        (folder / "licenses" / name).write_bytes(text)
    (folder / "SOURCES.txt").write_text("\n".join(sources) + "\n")


if __name__ == "__main__":
    main()

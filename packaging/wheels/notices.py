"""Writes licences and sources of the contents of libraries for another platform: python3 packaging/wheels/notices.py
LIBRARY FOLDER PART...

LIBRARY is a DLL, or a shared object for arm64. PART are the folders made by static_libraries.sh, zeromq.sh and
packaging/ducc0/fetch.sh. FOLDER receives licenses/ and SOURCES.txt.
"""

from __future__ import annotations

import sys
from pathlib import Path

from inside import origins_of


def main() -> None:
    library, folder, *parts = map(Path, sys.argv[1:])
    origins = origins_of(library)
    texts = {name: text.encode() for name, text in origins.texts().items()}
    sources = origins.sources()
    for part in parts:
        texts |= {f"{file.name}.txt": file.read_bytes() for file in sorted((part / "licenses").iterdir())}
        sources += (part / "sources.txt").read_text().splitlines()
    (folder / "licenses").mkdir(parents=True, exist_ok=True)
    for name, text in texts.items():
        (folder / "licenses" / name).write_bytes(text)
    (folder / "SOURCES.txt").write_text("\n".join(sources) + "\n")


if __name__ == "__main__":
    main()

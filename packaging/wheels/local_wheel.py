"""contactd-local: the module that solves in the process of Python, with the libraries it needs inside."""

from __future__ import annotations

from pathlib import Path

from elf import links, newest_glibc, own_folders
from licenses import Origins
from wheel_file import Wheel

__all__ = ["local_wheel"]

HERE = Path(__file__).parent
#: What every Linux with Python has.
OF_THE_SYSTEM = {"libc.so.6", "libm.so.6", "ld-linux-x86-64.so.2"}
#: Archives and headers of Debian that are inside.
INSIDE = [Path("/usr/lib/x86_64-linux-gnu") / f"lib{name}.a" for name in ("fftw3", "sodium", "z")]
HEADERS = [Path("/usr/include") / name for name in ("eigen3/Eigen/Core", "nlohmann/json.hpp", "valijson/validator.hpp")]


def local_wheel(module: Path, static: Path, version: str, license_text: str) -> Wheel:
    """`static` is the folder of static_libraries.sh. Raises ValueError for a module that cannot be taken elsewhere."""
    asked = set(links(module)) - OF_THE_SYSTEM
    if asked or own_folders(module):
        raise ValueError(f"{module} needs {sorted(asked)} from {own_folders(module)}; its libraries must be inside")
    glibc = "_".join(map(str, newest_glibc(module)[:2]))
    compiler = Path("/usr/lib/gcc/x86_64-linux-gnu")
    origins = Origins([*INSIDE, *HEADERS, next(compiler.glob("*/libstdc++.a"))])
    built = {file.name: file.read_text() for file in sorted((static / "licenses").iterdir())}
    wheel = Wheel(
        "contactd-local", version, "The engine of contactd in the process of Python, for contactd.local()",
        "GPL-3.0-or-later", f"cp310-abi3-manylinux_{glibc}_x86_64", _readme(origins, static),
    )  # fmt: skip
    wheel.files["contactd_local.abi3.so"] = module.read_bytes()
    wheel.licenses = {"contactd.txt": license_text, **origins.texts(), **{f"{k}.txt": v for k, v in built.items()}}
    return wheel


def _readme(origins: Origins, static: Path) -> str:
    sources = [*origins.sources(), *(static / "sources.txt").read_text().splitlines()]
    return (HERE / "local.md").read_text() + "\n" + "\n".join(f"- {source}" for source in sources) + "\n"

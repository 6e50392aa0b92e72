"""What has all its libraries inside: that it needs no others, and the licences of what is inside."""

from __future__ import annotations

from pathlib import Path

from elf import links, own_folders
from licenses import Origins

__all__ = ["licenses_of", "origins_of", "refuse_links"]

#: What every Linux has.
OF_THE_SYSTEM = {"libc.so.6", "libm.so.6", "ld-linux-x86-64.so.2"}
#: Archives and headers of Debian that are inside.
INSIDE = [Path("/usr/lib/x86_64-linux-gnu") / f"lib{name}.a" for name in ("sodium", "z")]
HEADERS = [Path("/usr/include") / name for name in ("eigen3/Eigen/Core", "nlohmann/json.hpp", "valijson/validator.hpp")]


def refuse_links(module: Path) -> None:
    """Raises ValueError for a module that cannot be taken to another machine."""
    asked = set(links(module)) - OF_THE_SYSTEM
    if asked or own_folders(module):
        raise ValueError(f"{module} needs {sorted(asked)} from {own_folders(module)}; its libraries must be inside")


def origins_of() -> Origins:
    """Of what comes from Debian as it is."""
    compiler = Path("/usr/lib/gcc/x86_64-linux-gnu")
    return Origins([*INSIDE, *HEADERS, next(compiler.glob("*/libstdc++.a"))])


def licenses_of(static: Path) -> dict[str, str]:
    """name -> text of what a folder of static_libraries.sh, zeromq.sh or packaging/ducc0/fetch.sh brings along, and Debian's."""
    built = {f"{file.name}.txt": file.read_text() for file in sorted((static / "licenses").iterdir())}
    return {**origins_of().texts(), **built}

"""Checks that a binary contains all its libraries, and collects the licences of its contents."""

from __future__ import annotations

from pathlib import Path

from elf import links, machine_of, own_folders
from licenses import Origins

__all__ = ["is_of_windows", "licenses_of", "origins_of", "refuse_links"]

#: Libraries that every Linux has.
OF_THE_SYSTEM = {"libc.so.6", "libm.so.6", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}
#: Archives and headers of Debian inside the binaries.
INSIDE = [f"lib{name}.a" for name in ("sodium", "z")]
_WINDOWS = "x86_64-w64-mingw32ucrt"
HEADERS = [Path("/usr/include") / name for name in ("eigen3/Eigen/Core", "nlohmann/json.hpp")]


def refuse_links(module: Path) -> None:
    """Raises ValueError for a module that does not run on other machines."""
    asked = set(links(module)) - OF_THE_SYSTEM
    if asked or own_folders(module):
        raise ValueError(f"{module} needs {sorted(asked)} from {own_folders(module)}; its libraries must be inside")


def is_of_windows(module: Path) -> bool:
    return module.suffix in (".dll", ".pyd")


def origins_of(module: Path) -> Origins:
    """Returns the licences of unchanged packages of Debian."""
    if is_of_windows(module):
        runtime = next(Path("/usr/lib/gcc", _WINDOWS).glob("*/libstdc++.a"))
        return Origins([*HEADERS, runtime, Path("/usr", _WINDOWS, "lib", "libmingw32.a")])
    triple = f"{machine_of(module)}-linux-gnu"
    (runtime,) = [
        file for folder in ("gcc", "gcc-cross") for file in Path("/usr/lib", folder, triple).glob("*/libstdc++.a")
    ][:1]
    return Origins([*(Path("/usr/lib", triple, name) for name in INSIDE), *HEADERS, runtime])


def licenses_of(module: Path, static: Path) -> dict[str, str]:
    """Returns name -> text: the files in a folder of static_libraries.sh, zeromq.sh or packaging/ducc0/fetch.sh, and
    those of Debian."""
    built = {f"{file.name}.txt": file.read_text() for file in sorted((static / "licenses").iterdir())}
    return {**origins_of(module).texts(), **built}

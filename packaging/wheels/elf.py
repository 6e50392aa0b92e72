"""Reads which libraries programs and libraries need, and where they look for them."""

from __future__ import annotations

import platform
import re
import subprocess
from pathlib import Path

__all__ = ["is_elf", "links", "machine_of", "own_folders"]

#: Processors by their numbers in ELF.
_MACHINES = {62: "x86_64", 183: "aarch64"}


def _output(*command: str | Path) -> str:
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def is_elf(path: Path) -> bool:
    with path.open("rb") as file:
        return file.read(4) == b"\x7fELF"


def machine_of(path: Path) -> str:
    """Returns the processor of a binary: x86_64 or aarch64."""
    with path.open("rb") as file:
        return _MACHINES[int.from_bytes(file.read(20)[18:], "little")]


def links(path: Path) -> dict[str, Path]:
    """Returns all libraries that it needs, directly and indirectly, as name -> file, including the loader, which it
    names by a path.

    Raises FileNotFoundError for missing ones.
    """
    machine = machine_of(path)
    # The loader of another processor lists the libraries, like ldd for this one.
    lists = ["ldd"] if machine == platform.machine() else [f"qemu-{machine}", f"/lib/ld-linux-{machine}.so.1", "--list"]
    found = {}
    for line in _output(*lists, path).splitlines():
        name, _, target = (words.strip() for words in line.partition("=>"))
        file = re.sub(r" \(0x[0-9a-f]+\)$", "", target or name)
        if file == "not found":
            raise FileNotFoundError(f"{path} needs {name}, which is not here")
        if file.startswith("/"):
            found[Path(name.split(" ")[0]).name] = Path(file).resolve()
    return found


def own_folders(path: Path) -> list[str]:
    """Returns the folders in which the binary itself looks for libraries (RPATH and RUNPATH)."""
    found = re.findall(r"\((?:RPATH|RUNPATH)\).*\[(.*)\]", _output("readelf", "-dW", path))
    return [folder for folders in found for folder in folders.split(":")]

"""What is asked of programs and libraries: what they need, and where they look for it."""

from __future__ import annotations

import platform
import re
import subprocess
from pathlib import Path

__all__ = ["is_elf", "links", "machine_of", "own_folders"]

#: By the number that ELF has for them.
_MACHINES = {62: "x86_64", 183: "aarch64"}


def _output(*command: str | Path) -> str:
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def is_elf(path: Path) -> bool:
    with path.open("rb") as file:
        return file.read(4) == b"\x7fELF"


def machine_of(path: Path) -> str:
    """For which processor it is: x86_64 or aarch64."""
    with path.open("rb") as file:
        return _MACHINES[int.from_bytes(file.read(20)[18:], "little")]


def links(path: Path) -> dict[str, Path]:
    """All libraries that it needs, and those that these need: name -> file; with the loader, which it names by a path.

    Raises FileNotFoundError for what is not there.
    """
    machine = machine_of(path)
    # For another processor than this one its own loader lists them, as ldd has this one's do.
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
    """Where it says itself that its libraries are (RPATH and RUNPATH)."""
    found = re.findall(r"\((?:RPATH|RUNPATH)\).*\[(.*)\]", _output("readelf", "-dW", path))
    return [folder for folders in found for folder in folders.split(":")]

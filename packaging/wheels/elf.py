"""What is asked of programs and libraries: what they need, and where they look for it."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

__all__ = ["is_elf", "links", "own_folders"]


def _output(*command: str | Path) -> str:
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def is_elf(path: Path) -> bool:
    with path.open("rb") as file:
        return file.read(4) == b"\x7fELF"


def links(path: Path) -> dict[str, Path]:
    """All libraries that it needs, and those that these need: name -> file; with the loader, which it names by a path.

    Raises FileNotFoundError for what is not there.
    """
    found = {}
    for line in _output("ldd", path).splitlines():
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

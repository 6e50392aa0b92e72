"""Finds binaries of a release that contain the name of a folder of the build machine, and are thus not reproducible."""

from __future__ import annotations

import io
import subprocess
import tarfile
import zipfile
from collections.abc import Iterator, Sequence
from pathlib import Path

__all__ = ["binaries_in", "telling"]


def binaries_in(name: str, content: bytes) -> Iterator[tuple[str, bytes]]:
    """Yields name and content of every program and library for Linux or Windows in a file, and in archives within
    archives."""
    if content[:4] == b"\x7fELF" or content[:2] == b"MZ":
        yield name, content
    elif content[:4] == b"PK\x03\x04":
        with zipfile.ZipFile(io.BytesIO(content)) as opened:
            for member in opened.namelist():
                yield from binaries_in(f"{name}: {member}", opened.read(member))
    elif content[:2] == b"\x1f\x8b" or name.endswith(".deb"):
        if name.endswith(".deb"):
            content = subprocess.run(["dpkg-deb", "--fsys-tarfile", "/dev/stdin"], input=content, capture_output=True, check=True).stdout
        try:
            with tarfile.open(fileobj=io.BytesIO(content)) as packed:
                for entry in packed:
                    if file := packed.extractfile(entry) if entry.isreg() else None:
                        yield from binaries_in(f"{name}: {entry.name}", file.read())
        except tarfile.ReadError:  # one compressed file
            return


def telling(folder: Path, places: Sequence[str]) -> list[str]:
    """Returns a sentence for each binary of the folder that contains one of the places, each a prefix of paths."""
    return [
        f"{name} names {place}"
        for path in sorted(folder.iterdir())
        for name, content in binaries_in(path.name, path.read_bytes())
        for place in places
        if place.encode() in content
    ]

"""Makes contactd-local: the module that solves inside a Python process, containing its libraries."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from pathlib import Path

from elf import machine_of
from inside import is_of_windows, licenses_of, origins_of
from project import copied, say, wheel

__all__ = ["local_wheel"]

HERE = Path(__file__).parent


def local_wheel(module: Path, static: Sequence[Path], version: str, folder: Path) -> Path:
    """Makes the wheel in `folder`. Its name does not state the required glibc yet: ./dev calls auditwheel, which
    determines it and rejects a module that requires libraries of this machine. `static` are the folders of static_libraries.sh and
    ducc0's FFT."""
    sources, licenses = origins_of(module).sources(), {}
    for part in static:
        sources += (part / "sources.txt").read_text().splitlines()
        licenses |= licenses_of(module, part)
    with copied(HERE / "local") as project:
        say(project, version, sources, licenses)
        if not is_of_windows(module):
            shutil.copy(module, project / "contactd_local.abi3.so")
            return wheel(project, folder, f"linux-{machine_of(module)}")
        shutil.copy(module, project / "contactd_local.pyd")
        about = project / "pyproject.toml"
        about.write_text(about.read_text().replace(" AND ISC ", " AND ZPL-2.1 "))  # MinGW-w64's runtime, and no libsodium
        return wheel(project, folder, "win-amd64")

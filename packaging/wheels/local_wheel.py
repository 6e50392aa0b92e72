"""contactd-local: the module that solves in the process of Python, with the libraries it needs inside."""

from __future__ import annotations

import shutil
from pathlib import Path

from inside import licenses_of, origins_of
from project import copied, say, wheel

__all__ = ["local_wheel"]

HERE = Path(__file__).parent


def local_wheel(module: Path, static: Path, version: str, folder: Path) -> Path:
    """The wheel, in `folder`. Its name does not say yet which glibc it takes: ./dev has auditwheel find that out, which
    refuses what needs libraries of this machine. `static` is the folder of static_libraries.sh."""
    sources = [*origins_of().sources(), *(static / "sources.txt").read_text().splitlines()]
    with copied(HERE / "local") as project:
        say(project, version, sources, licenses_of(static))
        shutil.copy(module, project / "contactd_local.abi3.so")
        return wheel(project, folder)

"""Creates temporary folders, which are removed with the process that created them or by a later one."""

from __future__ import annotations

import contextlib
import os
import shutil
import stat
import tempfile
from pathlib import Path

try:
    import fcntl
except ImportError:  # where a process that ends takes its folder along, or nothing does
    fcntl = None  # type: ignore[assignment]

__all__ = ["TemporaryFolder"]

_PREFIX = "contactd-"
_OWNER = "owner"  #: A file locked by its process.


class TemporaryFolder:
    """Provides a folder in the system's temporary folder, or in `within`.

    Creating a folder removes those of killed processes, which are no longer locked.
    """

    def __init__(self, within: str | None = None) -> None:
        parent = Path(tempfile.gettempdir() if within is None else within)
        _sweep(parent)
        self.path = Path(tempfile.mkdtemp(prefix=_PREFIX, dir=parent))
        self._lock = -1
        if fcntl is not None:
            new = self.path / f"{_OWNER}.new"
            self._lock = os.open(new, os.O_RDWR | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600)
            fcntl.flock(self._lock, fcntl.LOCK_EX)
            new.rename(self.path / _OWNER)  # A folder without this file is never removed.

    def __fspath__(self) -> str:
        return os.fspath(self.path)

    def remove(self) -> None:
        """Removes the folder. A second call has no effect."""
        shutil.rmtree(self.path, ignore_errors=True)
        if self._lock >= 0:
            os.close(self._lock)
            self._lock = -1


def _sweep(parent: Path) -> None:
    if fcntl is None:
        return
    with contextlib.suppress(OSError):
        for path in [Path(entry.path) for entry in os.scandir(parent) if entry.name.startswith(_PREFIX)]:
            with contextlib.suppress(OSError):
                _sweep_one(path)


def _sweep_one(path: Path) -> None:
    """Removes a folder. Raises OSError if it belongs to another user, is in use, or is not of this kind."""
    status = path.lstat()
    if not stat.S_ISDIR(status.st_mode) or status.st_uid != os.getuid():
        return
    lock = os.open(path / _OWNER, os.O_RDWR | os.O_CLOEXEC | os.O_NOFOLLOW)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        shutil.rmtree(path, ignore_errors=True)
    finally:
        os.close(lock)

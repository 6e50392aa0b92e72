"""Lifeline, which stops a private daemon if the process that started it was killed."""

from __future__ import annotations

import os
import subprocess
import weakref
from pathlib import Path

__all__ = ["Lifeline"]

#: $1: the daemon's process ID, $2: a part of its command line, $3: a folder to remove, or nothing. Another process with
#: the same ID is left alone.
_WATCH = """
is_there() { grep -qsaF -e "$2" "/proc/$1/cmdline"; }
read -r _
is_there "$@" && kill -TERM "$1"
n=0
while is_there "$@" && [ $n -lt 600 ]; do sleep 0.1; n=$((n + 1)); done
is_there "$@" && kill -KILL "$1"
[ -z "$3" ] || rm -rf -- "$3"
"""


class Lifeline:
    """Represents a shell that waits for the end of a pipe held by this process, and then stops the daemon.

    The kernel closes the pipe however this process ends. (PR_SET_PDEATHSIG would stop the daemon with the thread that
    started it.) Forked processes close the pipe immediately, so they cannot keep the daemon alive.
    """

    def __init__(self, process: int, configuration: Path, folder: Path | None) -> None:
        reading, self._writing = os.pipe()
        try:
            self._watcher = subprocess.Popen(
                ["/bin/sh", "-c", _WATCH, "contactd-lifeline", str(process), str(configuration), str(folder or "")],
                stdin=reading, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd="/", start_new_session=True,
            )  # fmt: skip
        except BaseException:
            os.close(self._writing)
            raise
        finally:
            os.close(reading)
        self._owner = os.getpid()
        _ALL.add(self)

    def let_go(self) -> None:
        """Ends the shell, because the daemon is stopped otherwise. A second call, or a call in a forked process, has no
        effect.
        """
        if self._owner != os.getpid() or self._writing < 0:
            return
        self._watcher.kill()
        self._watcher.wait()
        self._close()

    def _close(self) -> None:
        if self._writing >= 0:
            os.close(self._writing)
        self._writing = -1


_ALL: weakref.WeakSet[Lifeline] = weakref.WeakSet()


def _leave_to_the_parent() -> None:
    for lifeline in list(_ALL):
        lifeline._close()


if hasattr(os, "register_at_fork"):  # not available on systems without fork
    os.register_at_fork(after_in_child=_leave_to_the_parent)

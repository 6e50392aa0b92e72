"""Lifeline, which ends a private daemon when the process that started it was killed, and could not end it itself."""

from __future__ import annotations

import os
import subprocess
import weakref
from pathlib import Path

__all__ = ["Lifeline"]

#: $1: the daemon's process, $2: what its command line holds, $3: a folder to be removed, or nothing. A process that has
#: the daemon's number by chance is not touched.
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
    """A shell that waits for the end of a pipe, which this process holds, and then ends the daemon.

    However this process ends, the kernel closes the pipe. (PR_SET_PDEATHSIG would end the daemon with the thread that
    started it.) Processes that are forked close it at once, so that they hold nothing up.
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
        """The daemon is ended otherwise. May be called twice; does nothing in a forked process."""
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


if hasattr(os, "register_at_fork"):  # not where nothing forks
    os.register_at_fork(after_in_child=_leave_to_the_parent)

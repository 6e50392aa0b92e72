"""The end of the process soon after a signal, whatever its threads do.

A command that is interrupted ends in order: it cancels what it asked for, and says what is kept. Two watches bound how long
that may take. A thread ends the process with the exit code of the signal. Where no thread of Python runs any more, as one of
them is inside a library that keeps the interpreter's lock, a shell kills the process.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time

from .codes import Code

__all__ = ["end_soon_after_signals"]

_IN_ORDER = 1.5  #: seconds from a signal
_CODES: dict[int, Code] = {signal.SIGINT: Code.INTERRUPTED, signal.SIGTERM: Code.TERMINATED, signal.SIGHUP: Code.HUNG_UP}

#: $1: the process. The interpreter writes the number of each signal that it handles into the pipe, without its lock; the end
#: of the process closes it. A process that has the same number by chance is not the parent of this one.
_WATCH = r"""
number=$(head -c 1 | od -An -tu1)
[ -n "$number" ] || exit 0
echo $number
sleep 1.85
grep -qs "^PPid:[[:space:]]*$1\$" /proc/$$/status && kill -KILL "$1"
"""


def end_soon_after_signals() -> None:
    """From now on SIGINT, SIGTERM and SIGHUP end this process within two seconds, unless they are ignored. Of the main thread."""
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    try:
        watch = subprocess.Popen(
            ["/bin/sh", "-c", _WATCH, "contactctl-watch", str(os.getpid())],
            stdin=reading, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, cwd="/", start_new_session=True,
        )  # fmt: skip
    except OSError:  # no more processes: the command goes on without
        os.close(writing)
        return
    finally:
        os.close(reading)
    watch.returncode = 0  # it outlives this process
    signal.set_wakeup_fd(writing, warn_on_full_buffer=False)
    threading.Thread(target=_end_after_signal, args=(watch,), daemon=True, name="ending").start()


def _end_after_signal(watch: subprocess.Popen[bytes]) -> None:
    assert watch.stdout is not None
    number = watch.stdout.readline().strip()
    if not number.isdigit():
        return
    time.sleep(_IN_ORDER)
    in_process = sys.modules.get("contactd.transport.in_process")
    if in_process is not None:
        in_process.remove_temporary_folders()
    os._exit(_CODES.get(int(number), Code.DEFECT))

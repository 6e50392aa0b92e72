"""Ends the process soon after a signal, whatever its threads do.

An interrupted command ends normally: it cancels its requests, and reports the stored results. Two timers limit the time
for this. A thread ends the process with the exit code of the signal. If no Python thread can run, because a library
holds the interpreter's lock, a shell kills the process.
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

_IN_ORDER = 1.5  #: Seconds after a signal.
_CODES: dict[int, Code] = {signal.SIGINT: Code.INTERRUPTED, signal.SIGTERM: Code.TERMINATED, signal.SIGHUP: Code.HUNG_UP}

#: $1: the process ID. The interpreter writes the number of each handled signal into the pipe, without its lock; the end
#: of the process closes it. Another process with the same ID is not the parent of this one.
_WATCH = r"""
number=$(head -c 1 | od -An -tu1)
[ -n "$number" ] || exit 0
echo $number
sleep 1.85
grep -qs "^PPid:[[:space:]]*$1\$" /proc/$$/status && kill -KILL "$1"
"""


def end_soon_after_signals() -> None:
    """Makes SIGINT, SIGTERM and SIGHUP end this process within two seconds, unless they are ignored. Call it in the
    main thread.
    """
    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    try:
        watch = subprocess.Popen(
            ["/bin/sh", "-c", _WATCH, "contactctl-watch", str(os.getpid())],
            stdin=reading, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, cwd="/", start_new_session=True,
        )  # fmt: skip
    except OSError:  # a new process is impossible, so the command continues without it
        os.close(writing)
        return
    finally:
        os.close(reading)
    watch.returncode = 0  # It outlives this process.
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

"""Tests that a signal ends a command soon, whatever its threads do: in order, with the exit code of the signal, or
finally by SIGKILL."""

import signal
import time
from pathlib import Path

import pytest

from support.slowness import SLOWER

#: Each prints "ready", and would run for hours.
WAITS_AT_ITS_END = """
import atexit, signal, time
atexit.register(time.sleep, 10_000)
def end(*_): raise SystemExit(3)
for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP): signal.signal(number, end)
print("ready", flush=True)
time.sleep(10_000)
"""
KEEPS_THE_LOCK = """
import re, signal, threading, time
signal.signal(signal.SIGTERM, lambda *_: None)
print("ready", flush=True)
threading.Thread(target=re.match, args=("(a|aa)+$", "a" * 90 + "b"), daemon=True).start()
time.sleep(10_000)
"""
BEFORE = "from contactctl.ending import end_soon_after_signals\nend_soon_after_signals()\n"
ENDLESS_CASES = """\
 3  MODULE
  203100
  022020
 0001201
   999  100  30  1  1e-9
 50000.  0.0005  0.0  0.0001
   0.3   0.3
   0.0   0.5   20000.
   0.28  0.28  82000.  82000.
    -3
   601  601  6.0  4.0  1.1
 0  MODULE
"""


def ended(ctl, program):
    """Returns the process after it reported that it is ready."""
    process = ctl.start_python(BEFORE + program)
    assert process.stdout.readline() == "ready\n"
    return process


@pytest.mark.parametrize(("sent", "code"), [(signal.SIGHUP, 129), (signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_what_waits_at_the_end_of_a_command_does_not_keep_it(ctl, sent, code):
    with ended(ctl, WAITS_AT_ITS_END) as process:
        process.send_signal(sent)
        assert process.wait(timeout=30 * SLOWER) == code


def test_a_library_that_keeps_the_lock_of_the_interpreter_does_not_keep_a_command(ctl):
    with ended(ctl, KEEPS_THE_LOCK) as process:
        time.sleep(0.2)  # the thread has begun
        process.send_signal(signal.SIGTERM)
        assert process.wait(timeout=30 * SLOWER) == -signal.SIGKILL


def test_a_command_that_ends_by_itself_takes_its_watch_along(ctl):
    with ended(ctl, "import os\nprint('ready', flush=True)\nprint(os.getpid())\n") as process:
        number = process.stdout.readline().strip()
        assert process.wait(timeout=30 * SLOWER) == 0
    until = time.monotonic() + 30 * SLOWER
    while watches(number):
        assert time.monotonic() < until
        time.sleep(0.05)


def watches(number):
    """Returns the processes that watch the one with this number."""
    ending = f"contactctl-watch\0{number}\0".encode()
    return [one for one in Path("/proc").glob("[0-9]*/cmdline") if command_line(one).endswith(ending)]


def command_line(file):
    """Returns an empty list for a process that has ended."""
    try:
        return file.read_bytes()
    except OSError:
        return b""


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGTERM])
def test_a_large_solve_without_a_daemon_ends_with_a_signal(ctl, sent):
    ctl.write("large.inp", ENDLESS_CASES)
    del ctl.environment["CONTACTD_ENDPOINT"]
    with ctl.start("contact", "run", "large.inp") as running:
        rows = ctl.folder / "large.out.rows"
        while not rows.exists():
            assert running.poll() is None, running.communicate()[1]
            time.sleep(0.05)
        time.sleep(0.5)
        running.send_signal(sent)
        assert running.wait(timeout=30 * SLOWER) in (130, 143)

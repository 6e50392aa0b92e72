"""Causes faults of daemons on purpose."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from .daemons import BIN, Daemons, TestDaemon

#: The long versions of these tests: CONTACTD_FAULTS=long, as ./dev faults sets it.
LONG_FAULTS = os.environ.get("CONTACTD_FAULTS") == "long"
#: A namespace in which ordinary users can mount, too.
NAMESPACE = ["unshare", "--user", "--map-root-user", "--mount"]

CLOCK = r"""
#define _GNU_SOURCE
#include <stdlib.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>
/* The wall clock is ten years behind as soon as the file named by CLOCK_SET_BACK is there. */
static time_t shift(void) {
    const char* file = getenv("CLOCK_SET_BACK");
    return file && access(file, F_OK) == 0 ? 10 * 365 * 86400L : 0;
}
int clock_gettime(clockid_t clock, struct timespec* now) {
    const int result = (int)syscall(SYS_clock_gettime, clock, now);
    if (result == 0 && clock == CLOCK_REALTIME) now->tv_sec -= shift();
    return result;
}
int gettimeofday(struct timeval* restrict now, void* restrict zone) {
    struct timespec precise;
    (void)zone;
    clock_gettime(CLOCK_REALTIME, &precise);
    now->tv_sec = precise.tv_sec;
    now->tv_usec = precise.tv_nsec / 1000;
    return 0;
}
time_t time(time_t* at) {
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    if (at) *at = now.tv_sec;
    return now.tv_sec;
}
"""


def script(folder: Path, *lines: str, name: str = "program") -> Path:
    path = folder / name
    path.write_text("\n".join(["#!/bin/sh", *lines, ""]))
    path.chmod(0o755)
    return path


def start_as(daemons: Daemons, *command: str | Path, name: str = "daemon", **config: object) -> TestDaemon:
    """A daemon started through a command that finally executes it."""
    program = script(daemons.folder, f'exec {shlex.join(map(str, command))} {BIN / "contactd"} "$@"', name="wrapper")
    try:
        return daemons.start(name, program=program, **config)
    finally:
        program.unlink()


def needs_namespaces() -> None:
    if subprocess.run([*NAMESPACE, "mount", "-t", "tmpfs", "none", "/mnt"], capture_output=True).returncode != 0:
        pytest.skip("this system lets nobody mount in a namespace of his own")


def start_with_mount(daemons: Daemons, *mount: str, **config: object) -> TestDaemon:
    """A daemon with a mounted store (`mount ... STORE`) that no other process sees."""
    needs_namespaces()
    store = daemons.folder / "daemon" / "store"
    store.mkdir(parents=True, exist_ok=True)
    line = f'{shlex.join(["mount", *mount, str(store)])} && exec "$@"'
    return start_as(daemons, *NAMESPACE, "sh", "-c", line, "sh", **config)


def mounted_store(daemon: TestDaemon) -> Path:
    """Returns the path of the store as the daemon sees it."""
    return Path(f"/proc/{daemon.pid}/root{daemon.store}")


def in_namespace(daemon: TestDaemon, *command: str) -> None:
    enter = ["nsenter", "--target", str(daemon.pid), "--user", "--mount", "--preserve-credentials"]
    subprocess.run([*enter, *command], check=True)


def clock_shim(folder: Path) -> Path:
    """Returns a library that sets back the clock of a program started with it."""
    source, library = folder / "clock.c", folder / "clock.so"
    source.write_text(CLOCK)
    subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-o", str(library), str(source)], check=True)
    source.unlink()
    return library


def python_with(environment: dict[str, str], *arguments: str) -> str:
    """Returns the output of a Python program in this environment."""
    everything = {**os.environ, **environment}
    return subprocess.run([sys.executable, *arguments], env=everything, check=True, capture_output=True, text=True).stdout

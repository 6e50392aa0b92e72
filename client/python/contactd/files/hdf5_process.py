"""Reads HDF5 files in a separate process, because a malicious file may hang or crash the HDF5 library, or make it
allocate all memory. The process receives the content of a file and returns a numpy archive without objects.
"""

from __future__ import annotations

import io
import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from importlib import import_module
from typing import Any

import numpy as np

from ..errors import ContactdError
from .whole import arrays_of

__all__ = ["SECONDS", "read_apart"]

SECONDS = 30.0  #: Time limit of reading (s), plus a second for each _BYTES_A_SECOND.
_BYTES_A_SECOND = 50_000_000
_MEMORY = 1 << 31  #: Memory limit of reading (bytes), in addition to eight times the content.
_PROGRAM = f"import sys; sys.path[:] = sys.argv[4:]; from {__name__} import _main; _main(*sys.argv[1:4])"
_REPORTED = "told"  #: Member of the answer that contains JSON.


def read_apart(read: Callable[[bytes], Any], content: bytes) -> Any:
    """Returns the result of `read`, a function of a module, for the content of a file: dictionaries, lists, numbers,
    texts and arrays.

    Raises ValueError with the message of an exception of `read`, or if it needs more time or memory than any file of
    contactd. Raises ContactdError if there is no Python program to run.
    """
    if not sys.executable:
        raise ContactdError("HDF5 files are read by a separate Python program, but sys.executable is not set")
    seconds = SECONDS + len(content) / _BYTES_A_SECOND
    command = [sys.executable, "-c", _PROGRAM, read.__module__, read.__qualname__, str(seconds), *sys.path]
    # Threads of linear algebra are not needed, but would reserve memory.
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    try:
        ended = subprocess.run(command, input=content, capture_output=True, timeout=seconds, env=environment)
    except subprocess.TimeoutExpired:
        raise ValueError(_too_long(seconds)) from None
    except OSError as error:
        raise ContactdError(f"HDF5 files are read by a separate Python program, which cannot be started: {error}") from None
    if ended.returncode < 0:
        if -ended.returncode in (signal.SIGXCPU, signal.SIGKILL):
            raise ValueError(_too_long(seconds))
        raise ValueError(f"the HDF5 library crashes while reading it, by the signal {signal.Signals(-ended.returncode).name}")
    if ended.returncode > 0:
        last = ended.stderr.decode("utf-8", "replace").strip().rpartition("\n")[2]
        raise ContactdError(f"The Python program that reads HDF5 files failed: {last[:300]}")
    return _unpacked(ended.stdout)


def _too_long(seconds: float) -> str:
    return f"reading it takes longer than {seconds:.0f} s, longer than any file of contactd"


def _unpacked(answer: bytes) -> Any:
    arrays = arrays_of(io.BytesIO(answer))
    reported = json.loads(arrays[_REPORTED].tobytes())
    if "refused" in reported:
        raise ValueError(reported["refused"])

    def value_of(item: Any) -> Any:
        if not isinstance(item, dict):
            return item
        if "array" in item:
            return arrays[item["array"]]
        if "list" in item:
            return [value_of(part) for part in item["list"]]
        return {name: value_of(part) for name, part in item["mapping"].items()}

    return value_of(reported["value"])


def _packed(value: Any) -> bytes:
    arrays: dict[str, np.ndarray[Any, Any]] = {}

    def reported_of(item: Any) -> Any:
        if isinstance(item, np.ndarray):
            name = f"array{len(arrays)}"
            arrays[name] = item
            return {"array": name}
        if isinstance(item, dict):
            return {"mapping": {name: reported_of(part) for name, part in item.items()}}
        return {"list": [reported_of(part) for part in item]} if isinstance(item, list) else item

    return _archive({"value": reported_of(value)}, arrays)


def _archive(reported: Any, arrays: dict[str, np.ndarray[Any, Any]]) -> bytes:
    if strange := {str(array.dtype) for array in arrays.values() if array.dtype.kind not in "fiub"}:
        raise ValueError(f"it contains arrays of {', '.join(sorted(strange))}; arrays of contactd contain numbers")
    file = io.BytesIO()
    members: dict[str, Any] = {_REPORTED: np.frombuffer(json.dumps(reported).encode(), np.uint8), **arrays}
    np.savez(file, **members)
    return file.getvalue()


def _main(module: str, function: str, seconds: str) -> None:
    """Runs in the separate process."""
    read = getattr(import_module(module), function)
    content = sys.stdin.buffer.read()
    _limit(float(seconds), _MEMORY + 8 * len(content))
    try:
        answer = _packed(read(content))
    except MemoryError:
        answer = _archive({"refused": "reading it takes more memory than any file of contactd"}, {})
    except Exception as error:  # h5py may raise any exception.
        answer = _archive({"refused": str(error) or type(error).__name__}, {})
    sys.stdout.buffer.write(answer)


def _limit(seconds: float, size: int) -> None:
    """Limits memory and processor time: the process could otherwise use all memory, or outlive its parent in an endless
    loop. Windows has no such limits; there the parent ends a slow process, and memory is not limited.
    """
    try:
        import resource
    except ModuleNotFoundError:
        return
    reserved = 0  # by libraries
    with suppress(OSError):  # Linux reports it in pages.
        with open("/proc/self/statm") as file:
            reserved = int(file.read().split()[0]) * resource.getpagesize()
    most = {resource.RLIMIT_CORE: 0, resource.RLIMIT_CPU: int(seconds) + 1, resource.RLIMIT_AS: reserved + size}
    for which, value in most.items():
        with suppress(OSError, ValueError):  # A lower limit may already apply.
            resource.setrlimit(which, (value, value))

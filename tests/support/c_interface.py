"""Calls the C interface by ctypes, in process: FMUs must return the same values to the last bit."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from support.daemons import BIN

LIBRARY = BIN.parent / "lib" / "libcontactd-local.so"
Call = Callable[..., list[float]]


@contextmanager
def _handle(new: str, free: str) -> Iterator[Call]:
    library = ctypes.CDLL(str(LIBRARY))
    library.contactd_last_error.restype = ctypes.c_char_p
    connection, handle = ctypes.c_void_p(), ctypes.c_void_p()
    assert library.contactd_open(b"local", ctypes.byref(connection)) == 0
    assert getattr(library, new)(connection, ctypes.byref(handle)) == 0

    def call(name: str, *inputs: float | bytes, out: str = "") -> list[float]:
        """Calls a function with outputs. `out` is d for a double, i for an integer, or [n] for an array of n doubles,
        whose length is passed."""
        of = {"d": ctypes.c_double, "i": ctypes.c_int32}
        count = int(out[1:-1]) if out.startswith("[") else 0
        places = [(ctypes.c_double * count)()] if count else [of[letter]() for letter in out]
        given = [ctypes.c_double(value) if isinstance(value, float) else value for value in inputs]
        results = [places[0], count] if count else map(ctypes.byref, places)
        code = getattr(library, "contactd_" + name)(handle, *given, *results)
        assert code == 0, library.contactd_last_error(handle)
        return list(places[0]) if count else [place.value for place in places]

    try:
        yield call
    finally:
        getattr(library, free)(handle)
        library.contactd_close(connection)


class Fields:
    """A contact or a wheel with fields by their paths."""

    def __init__(self, call: Call) -> None:
        self._call = call

    def set(self, fields: dict[str, float]) -> None:
        for path, value in fields.items():
            self._call("set", path.encode(), float(value))

    def clear(self, path: str) -> None:
        self._call("clear", path.encode())

    def set_word(self, path: str, word: str) -> None:
        self._call("set_word", path.encode(), word.encode())

    def get(self, path: str) -> float:
        return self._call("get", path.encode(), out="d")[0]

    def array(self, path: str) -> list[float]:
        count = int(self._call("length", path.encode(), out="i")[0])
        return self._call("get_array", path.encode(), out=f"[{count}]")


class Contact(Fields):
    def start(self) -> None:
        self._call("start")

    def step(self) -> None:
        self._call("step")


class Wheel(Fields):
    def solve(self) -> None:
        self._call("step_again")


@contextmanager
def contact() -> Iterator[Contact]:
    with _handle("contactd_new", "contactd_free") as call:
        yield Contact(call)


@contextmanager
def wheel() -> Iterator[Wheel]:
    with _handle("contactd_wheel_new", "contactd_wheel_free") as call:
        yield Wheel(call)

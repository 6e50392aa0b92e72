"""The C interface by ctypes, in process: what the FMUs must answer to the last bit."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager

from support.daemons import BIN

LIBRARY = BIN.parent / "lib" / "libcontactd-local.so"
BOTH = 2
Call = Callable[..., list[float]]


@contextmanager
def _handle(new: str, free: str, prefix: str) -> Iterator[Call]:
    library = ctypes.CDLL(str(LIBRARY))
    library.contactd_last_error.restype = ctypes.c_char_p
    connection, handle = ctypes.c_void_p(), ctypes.c_void_p()
    assert library.contactd_open(b"local", ctypes.byref(connection)) == 0
    assert getattr(library, new)(connection, ctypes.byref(handle)) == 0

    def call(name: str, *inputs: float | bytes, out: str = "") -> list[float]:
        """`out`: d for a double, i for an integer, 6 for six doubles in an array."""
        of = {"d": ctypes.c_double, "i": ctypes.c_int32, "6": ctypes.c_double * 6}
        places = [of[letter]() for letter in out]
        converted = [ctypes.c_double(value) if isinstance(value, float) else value for value in inputs]
        code = getattr(library, prefix + name)(handle, *converted, *map(ctypes.byref, places))
        assert code == 0, library.contactd_last_error(handle)
        return [value for place in places for value in (place if out == "6" else [place.value])]

    try:
        yield call
    finally:
        getattr(library, free)(handle)
        library.contactd_close(connection)


def contact() -> AbstractContextManager[Call]:
    return _handle("contactd_new", "contactd_free", "contactd_")


def wheel() -> AbstractContextManager[Call]:
    return _handle("contactd_wheel_new", "contactd_wheel_free", "contactd_wheel_")

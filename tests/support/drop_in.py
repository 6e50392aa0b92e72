"""Calls the functions of libcontactd-cntc from Python."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from support.daemons import BIN

__all__ = ["ALL", "DropIn"]

Floats = npt.NDArray[np.float64]

ALL = -1  #: stands for all contact problems
_SILENT = 2000  #: the flag of output
_ON_RAILS = 1
_NOT_CONVERGED = (-26, -27, -28, -29)  #: of cntc_calculate; the best approximation can be read


@cache
def _library() -> ctypes.CDLL:
    library = ctypes.CDLL(str(BIN.parent / "lib" / "libcontactd-cntc.so"))
    library.contactd_cntc_last_error.restype = ctypes.c_char_p
    _call("cntc_setglobalflags", 1, [_SILENT], [0], library=library)
    return library


def _call(function: str, *arguments: Any, library: ctypes.CDLL | None = None) -> None:
    pointers = [_pointer(argument) for argument in arguments]
    getattr(library or _library(), function)(*pointers)


def _pointer(argument: Any) -> Any:
    if isinstance(argument, np.ndarray):
        return argument.ctypes.data_as(ctypes.c_void_p)
    if isinstance(argument, bytes):
        return ctypes.c_char_p(argument)
    if isinstance(argument, ctypes._SimpleCData):
        return ctypes.byref(argument)
    if isinstance(argument, (list, tuple)):
        kind = ctypes.c_int if all(isinstance(one, int) for one in argument) else ctypes.c_double
        return (kind * len(argument))(*argument)
    return ctypes.byref(ctypes.c_int(argument) if isinstance(argument, int) else ctypes.c_double(argument))


class DropIn:
    """A result element, in mm and N on body 1: a basic contact, or a wheel on a rail."""

    def __init__(self, ire: int, module: int) -> None:
        self.ire, self.is_on_rails = ire, module == _ON_RAILS
        _call("cntc_initialize", ire, module, ctypes.c_int(), ctypes.c_int(), b"", 0)
        self.all = ALL if self.is_on_rails else 1

    def close(self) -> None:
        """Ends the result element."""
        _call("cntc_finalize", self.ire)

    @property
    def sentence(self) -> str:
        """Returns the message of the last error."""
        return str(_library().contactd_cntc_last_error(None).decode())

    def read(self, path: Path) -> int:
        """Sets the case of a file. Returns 0, or the code of a refusal."""
        error, name = ctypes.c_int(), str(path).encode()
        _call("cntc_readinpfile", self.ire, 1, name, len(name), error)
        return error.value

    def flag(self, code: int, value: int) -> None:
        """Sets a flag."""
        _call("cntc_setflags", self.ire, self.all, 1, [code], [value])

    def calculate(self) -> tuple[str, str]:
        """Solves. Returns the status of the case, and a message if there is no solution or a poor one."""
        error = ctypes.c_int()
        _call("cntc_calculate", self.ire, self.all, error)
        if error.value >= 0:
            return "solved", ""
        return "not converged" if error.value in _NOT_CONVERGED else "refused", self.sentence

    def stresses(self, icp: int) -> None:
        """Computes stresses below the surface."""
        _call("subs_calculate", self.ire, icp, ctypes.c_int())

    def reals(self, function: str, count: int, *arguments: int) -> Floats:
        """Returns `count` numbers, each from its own argument; `arguments` follow the number of the result element."""
        found = [ctypes.c_double() for _ in range(count)]
        _call(function, self.ire, *arguments, *found)
        return np.array([one.value for one in found])

    def list(self, function: str, count: int, *arguments: int) -> Floats:
        """Returns an array of `count` numbers."""
        found = np.zeros(count)
        _call(function, self.ire, *arguments, count, found)
        return found

    def integer(self, function: str, *arguments: int) -> int:
        """Returns an integer."""
        found = ctypes.c_int()
        _call(function, self.ire, *arguments, found)
        return found.value

    def division(self, icp: int, count: int) -> npt.NDArray[np.int32]:
        """Returns the state of each element."""
        found = np.zeros(count, np.int32)
        _call("cntc_getelementdivision", self.ire, icp, count, found)
        return found

    def field(self, code: int, icp: int, count: int) -> Floats:
        """Returns a number for each element, by the codes of cntc_getfielddata."""
        return self.list("cntc_getfielddata", count, icp, code)

    def columns(self, icp: int, block: int, columns: Sequence[int]) -> Floats:
        """Returns columns of a block of points below the surface, shape [columns, nz, ny, nx]."""
        size = [ctypes.c_int() for _ in range(3)]
        _call("subs_getblocksize", self.ire, icp, block, *size)
        nx, ny, nz = (one.value for one in size)
        found = np.zeros((len(columns), nz, ny, nx))
        _call("subs_getresults", self.ire, icp, block, nx * ny * nz, len(columns), list(columns), found)
        return found

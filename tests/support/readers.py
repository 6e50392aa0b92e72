"""Readers of files that do what HDF5 may do with a malicious file."""

from __future__ import annotations

import ctypes

import numpy as np


def tells_all(content: bytes) -> object:
    numbers = [1, 0.1, "text", None, [np.full(1, 3, np.uint8)]]
    return {"array": np.arange(6.0).reshape(2, 3), "mapping": numbers, "list": {"": content.decode()}}


def takes_memory(content: bytes) -> object:
    return np.ones(1 << 30)


def ends(content: bytes) -> object:
    return ctypes.string_at(0)


def gives_objects(content: bytes) -> object:
    return np.array([{}], dtype=object)


def cannot_start(content: bytes) -> object:
    raise AssertionError("it is looked for where it is not")


cannot_start.__module__ = "nowhere"

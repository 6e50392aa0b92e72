"""Lists the contents of an answer as named values: JSON fields, arrays by their bytes, and contents of files."""

from __future__ import annotations

import io
import json
from dataclasses import dataclass
from typing import Any

import h5py
import numpy as np

from .wire import Answer

#: Types of compared values: the text of a number, a JSON value, or an Array.
Contents = dict[str, Any]
_USER_BLOCK = 512  # digest of an IC file


class Number(str):
    """Keeps the original text, so that 1 and 1.0, 0.0 and -0.0 differ."""


@dataclass(frozen=True)
class Array:
    dtype: str
    shape: tuple[int, ...]
    data: bytes

    def numpy(self) -> np.ndarray[Any, Any]:
        return np.frombuffer(self.data, self.dtype).reshape(self.shape)


def contents(answer: Answer, names: dict[str, str]) -> Contents:
    """`names` maps words that differ between daemons, such as names of sessions, to replacements."""
    text = answer.text.decode()
    for name, word in names.items():
        text = text.replace(name, word)
    envelope = json.loads(text, parse_float=Number, parse_int=Number)
    found: Contents = {}
    _collect("", envelope, answer.frames, found)
    return found


def _collect(path: str, node: Any, frames: list[bytes], found: Contents) -> None:
    match node:
        case {"$array": {"frame": frame, "dtype": dtype, "shape": shape}}:
            array = Array(dtype, tuple(int(extent) for extent in shape), frames[int(frame) - 1])
            if path == "result.file":
                _collect_file(path, array.data, found)
            else:
                found[path] = array
        case dict():
            for key, value in node.items():
                _collect(f"{path}.{key}" if path else key, value, frames, found)
        case list() if node and all(isinstance(value, Number) for value in node):
            found[path] = Array("<f8", (len(node),), np.array(node, float).tobytes())
        case list():
            found[f"{path} (length)"] = len(node)
            for number, value in enumerate(node):
                _collect(f"{path}[{number}]", value, frames, found)
        case _:
            found[path] = node


def _collect_file(path: str, data: bytes, found: Contents) -> None:
    """Lists the contents of an IC file: its size and everything that HDF5 finds in it, in the order of the file."""
    found[f"{path} (size)"] = len(data)
    with h5py.File(io.BytesIO(data[_USER_BLOCK:]), "r") as file:

        def collect(name: str, item: Any) -> None:
            attributes = list(item.attrs)
            found[f"{path}/{name} (attributes)"] = attributes
            for attribute in attributes:
                found[f"{path}/{name}.{attribute}"] = _value(item.attrs[attribute])
            if isinstance(item, h5py.Dataset):
                found[f"{path}/{name}"] = _value(item[()])

        collect("", file)
        file.visititems(collect)


def _value(value: Any) -> Any:
    if isinstance(value, str):
        return value
    array = np.asarray(value)
    if array.dtype.kind == "O":
        return [str(text) for text in array.ravel()]
    return Array(array.dtype.str, array.shape, array.tobytes())

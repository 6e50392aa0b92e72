"""Converts Python and numpy values to the JSON and array frames of docs/protocol.md, and back."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..errors import ProtocolError, invalid
from ..values.params import whole
from .messages import Buffer

__all__ = ["Frames", "decode", "encode"]

# Types of received arrays: double precision and bytes, little-endian on every machine.
_DTYPES: dict[str, np.dtype[Any]] = {"<f8": np.dtype("<f8"), "|u1": np.dtype("u1")}

_JSON = frozenset({int, str, bool, type(None)})  # also finite floats


class Frames(list[bytes]):
    """Collects the array frames of a request. Arrays in the same memory, such as the table of many problems, share a
    frame."""

    def __init__(self) -> None:
        super().__init__()
        self._numbers: dict[Any, int] = {}

    def number_of(self, array: np.ndarray[Any, Any], field: str) -> int:
        """Returns the frame of `array`, which must outlive this object. Raises InvalidArgument naming `field`."""
        memory = array.__array_interface__["data"][0], array.dtype.str, array.shape, array.strides
        if memory not in self._numbers:
            self.append(_bytes_of(array, field))
            self._numbers[memory] = len(self)
        return self._numbers[memory]


def encode(value: Any, field: str, frames: Frames) -> Any:
    """Returns `value` as JSON. Arrays of any real dtype, byte order or memory layout are added to `frames`, and so are
    the bytes of a file.

    Numbers that are not finite are refused: JSON cannot represent them, and no contact problem needs them.
    """
    if isinstance(value, np.ndarray):
        return _encode_array(value, field, frames)
    if isinstance(value, bytes):
        frames.append(value)
        return {"$array": {"frame": len(frames), "dtype": "|u1", "shape": [len(value)]}}
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, (dict, Mapping)):  # Test for dict first: it is the usual case, and Mapping is slow.
        return {
            key: item if _is_json(item) else encode(item, f"{field}.{key}" if field else str(key), frames)
            for key, item in value.items()
        }
    if isinstance(value, (list, tuple)):
        return [item if _is_json(item) else encode(item, f"{field}[{i}]", frames) for i, item in enumerate(value)]
    if isinstance(value, float) and not math.isfinite(value):
        raise invalid(field, f"is {value}; it must be finite")
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    raise invalid(field, f"is a {type(value).__name__}, which JSON cannot represent")


def _is_json(value: Any) -> bool:
    """Returns whether a value is valid JSON as it is, like most parts of a request; then its path is not needed."""
    kind = type(value)
    return math.isfinite(value) if kind is float else kind in _JSON


def _encode_array(array: np.ndarray[Any, Any], field: str, frames: Frames) -> Any:
    array = np.asarray(whole(array, field))
    return {"$array": {"frame": frames.number_of(array, field), "dtype": "<f8", "shape": list(array.shape)}}


def _bytes_of(array: np.ndarray[Any, Any], field: str) -> bytes:
    if array.dtype.kind not in "fiub":
        raise invalid(field, f"has dtype {array.dtype}; it must contain real numbers", "ARRAY_INVALID")
    data = np.ascontiguousarray(array, dtype="<f8")
    finite = np.isfinite(data)
    if not finite.all():
        first = tuple(int(i) for i in np.argwhere(~finite)[0])
        raise invalid(field, f"contains {data[first]} at {list(first)}; every value must be finite", "ARRAY_INVALID")
    return data.tobytes()


def decode(value: Any, frames: Sequence[Buffer]) -> Any:
    """Inverts `encode` for answers: each reference to a frame becomes a read-only array on its bytes."""
    if isinstance(value, dict):
        if value.keys() == {"$array"}:
            return _decode_array(value["$array"], frames)
        return {key: decode(item, frames) for key, item in value.items()}
    if isinstance(value, list):
        return [decode(item, frames) for item in value]
    return value


def _decode_array(reference: Any, frames: Sequence[Buffer]) -> np.ndarray[Any, Any]:
    try:
        number, dtype, shape = reference["frame"], _DTYPES[reference["dtype"]], reference["shape"]
        if not all(type(n) is int and n >= 0 for n in [number, *shape]):
            raise ValueError
    except (KeyError, TypeError, ValueError):
        raise ProtocolError(f"The answer contains an array reference that cannot be read: {reference!r:.200}") from None
    if not 1 <= number <= len(frames):
        raise ProtocolError(f"The answer refers to array frame {number}, but it has {len(frames)} frames.")
    frame, needed = frames[number - 1], math.prod(shape) * dtype.itemsize
    if len(frame) != needed:
        raise ProtocolError(f"Array frame {number} has {len(frame)} bytes, but its shape {shape} requires {needed}.")
    array: np.ndarray[Any, Any] = np.frombuffer(frame, dtype=dtype).reshape(shape)
    return array

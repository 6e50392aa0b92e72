"""Saves problems and solutions in HDF5 files (needs h5py). Each value is a group; its arrays are datasets, and
everything else is attributes, so that other programs can read the files.
"""

from __future__ import annotations

import io
import os
from typing import Any

import numpy as np

from .._version import __version__
from ..errors import MissingExtra, SavedFileError
from ..refusals import public
from ..values.dictionaries import Saved, from_dict, to_dict
from .hdf5 import has_own_data, own_members
from .hdf5_process import read_apart
from .whole import MOST_BYTES, read_whole, write_whole

__all__ = ["load", "save"]

PathLike = str | os.PathLike[str]
_FORMAT = 1
_GROUP = "contactd_group"  #: Attribute: whether a group is a mapping or a sequence.
_LARGEST_GAIN = 1100  #: Largest compression ratio of gzip.
_MOST_IN_ATTRIBUTE = 256  #: Largest count of numbers in an attribute; HDF5 allows 64 KiB.


@public
def save(path: PathLike, value: Saved) -> None:
    """Writes a problem, a solution, a step, stresses, or a set-up, state or solution of a wheel on a rail to a file.

    The file is first written under another name, so it is never incomplete.
    """
    if not isinstance(value, Saved):
        raise TypeError(f"{value!r:.80} is a {type(value).__name__}; save() accepts problems, solutions and similar values")
    content = io.BytesIO()
    with _h5py().File(content, "w") as file:
        file.attrs["contactd_saved"] = _FORMAT
        file.attrs["contactd_version"] = __version__
        _write(file.create_group("value"), to_dict(value))
    write_whole(path, lambda file: file.write(content.getbuffer()))


@public
def load(path: PathLike) -> Any:
    """Returns the value that `save` has written.

    Raises SavedFileError if the file has none or is damaged, and OSError if it cannot be read.
    """
    _h5py()
    name, content = os.fspath(path), read_whole(path, MOST_BYTES)
    try:
        reported = read_apart(content_of, content)
    except ValueError as error:
        raise SavedFileError(f"{name}: {error}") from None
    try:
        return from_dict(_protect(reported))
    except ValueError as error:
        raise SavedFileError(f"{name} contains nothing that can be loaded: {error}") from None


def content_of(content: bytes) -> Any:
    """Returns the dictionary of the value in the content of a file. Raises ValueError for other content; a malicious
    file may make h5py raise any exception.
    """
    h5py = _h5py()
    try:
        with h5py.File(io.BytesIO(content), "r") as file:
            found = file.attrs.get("contactd_saved")
            is_here = isinstance(file.get("value", getlink=True), h5py.HardLink)
            if found == _FORMAT and is_here:
                return _read(file["value"], _LARGEST_GAIN * len(content))
    except (OSError, KeyError, ValueError, RuntimeError) as error:
        raise ValueError(f"it contains nothing that can be loaded: {error}") from None
    if found == _FORMAT:
        raise ValueError("its value is in another file, but files of save() contain everything")
    other = "of contactd's problems and solutions" if found is None else f"of format {_FORMAT} but {found}"
    raise ValueError(f"it is not a file {other}; read files of Client.export_ic with load_table")


def _h5py() -> Any:
    try:
        import h5py
    except ImportError:
        raise MissingExtra("A file of HDF5", "h5py", "hdf5", "python3-h5py") from None
    return h5py


def _write(group: Any, value: Any) -> None:
    """Writes a dictionary, or the items of a list by their numbers."""
    items = value.items() if isinstance(value, dict) else enumerate(value)
    group.attrs[_GROUP] = "mapping" if isinstance(value, dict) else "sequence"
    for key, item in items:
        name = str(key)
        array = item if isinstance(item, np.ndarray) else _as_array(item) if isinstance(item, list) else None
        if isinstance(item, dict) or (isinstance(item, list) and array is None):
            _write(group.create_group(name), item)
        elif array is not None and (isinstance(item, np.ndarray) or array.size > _MOST_IN_ATTRIBUTE):
            group.create_dataset(name, data=array, **({"compression": "gzip"} if array.size > 1000 else {}))
        elif array is not None:
            group.attrs[name] = array
        else:
            group.attrs[name] = _h5py().Empty("f8") if item is None else item


def _as_array(items: list[Any]) -> Any:
    """Returns a list of numbers (None becomes NaN), or of lists of numbers, as an array; None for everything else."""
    flat = [number for item in items for number in (item if isinstance(item, list) else [item])]
    if not flat or not all(number is None or type(number) in (int, float) for number in flat):
        return None
    try:
        holds_none = any(number is None for number in flat)
        return np.array(items, dtype=float if holds_none else None)
    except ValueError:
        return None  # lists of different lengths


def _read(group: Any, most_bytes: int) -> Any:
    """Reads a group. Refuses data in other files, and data larger than the file can contain."""
    h5py = _h5py()
    found = {name: _of_attribute(value) for name, value in group.attrs.items() if name != _GROUP}
    for name, member in own_members(h5py, group):
        if isinstance(member, h5py.Group):
            found[name] = _read(member, most_bytes)
        elif not has_own_data(h5py, member) or member.nbytes > most_bytes:
            raise ValueError(f"{name} stores its data in other files, or is larger than this file can contain")
        else:
            found[name] = member[()]
    if group.attrs[_GROUP] == "sequence":
        return [found[str(number)] for number in range(len(found))]
    return found


def _protect(reported: Any) -> Any:
    """Makes arrays read-only: a loaded value may be the history of several problems."""
    if isinstance(reported, np.ndarray):
        reported.flags.writeable = False
    for part in reported.values() if isinstance(reported, dict) else reported if isinstance(reported, list) else ():
        _protect(part)
    return reported


def _of_attribute(value: Any) -> Any:
    if isinstance(value, _h5py().Empty):
        return None
    if isinstance(value, np.ndarray):
        return _without_nan(value.tolist())
    return value.item() if isinstance(value, np.generic) else value


def _without_nan(item: Any) -> Any:
    if isinstance(item, list):
        return [_without_nan(part) for part in item]
    return None if item != item else item

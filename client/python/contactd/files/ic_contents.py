"""Contents of an IC file (needs h5py): attributes and datasets by their paths, as ic.import accepts them.

Files may come from untrusted sources, and HDF5 follows references in them: to other files, into filters, to sizes
beyond the file. Everything that contactd does not write is refused before any data is read. HDF5 runs in a separate
process, which it may hang.
"""

from __future__ import annotations

import hashlib
import io
import re
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..errors import TableFileError
from .hdf5 import has_own_data, need_h5py, own_members
from .hdf5_process import read_apart

__all__ = ["FileContents", "contents_of", "file_of"]

_USER_BLOCK = 512
_MAGIC = re.compile(rb"contactd ic table, format (\d{1,9})")
_OURS = b"contactd ic table, format 1, "
_DIGEST = b"sha256 of the bytes after this block: "
_FORMAT = 2

_PATH = re.compile(r"[A-Za-z0-9_]+(/[A-Za-z0-9_]+){0,3}")
_LONGEST_PATH = 100
_MOST_ATTRIBUTES, _MOST_DATASETS, _MOST_LINKS, _MOST_AXES = 1000, 20, 100, 5
_LONGEST_LIST, _MOST_TEXTS, _LONGEST_TEXT = 10_000, 200, 1000
_DEEPEST = 3

Value = float | int | str | list[float] | list[str]


@dataclass
class FileContents:
    """Attributes by their paths, such as "spec/body", and datasets of doubles."""

    attributes: dict[str, Value] = field(default_factory=dict)
    datasets: dict[str, np.ndarray[Any, np.dtype[np.float64]]] = field(default_factory=dict)

    def at(self, path: str) -> dict[str, Any]:
        """Returns the attributes of a group or a dataset by their names."""
        before = path + "/"
        rest = ((name.removeprefix(before), value) for name, value in self.attributes.items() if name.startswith(before))
        return {name: value for name, value in rest if "/" not in name}

    def has(self, path: str) -> bool:
        """Returns whether the group has an attribute."""
        return any(name.startswith(path + "/") for name in self.attributes)


def contents_of(content: bytes, name: str) -> FileContents:
    """Returns the contents of the bytes of a file; `name` is the name of the file in the message of a
    TableFileError.
    """
    need_h5py()
    _check_digest(name, content)
    try:
        return FileContents(**read_apart(contents_of_image, content[_USER_BLOCK:]))
    except ValueError as error:
        raise TableFileError(f"{name}: {error}") from None


def contents_of_image(image: bytes) -> dict[str, Any]:
    """Returns attributes and datasets of the part after the digest. Raises TableFileError; h5py may raise any
    exception.
    """
    h5py = need_h5py()
    try:
        with h5py.File(io.BytesIO(image), "r") as file:
            found = _Reader(h5py, len(image)).read(file)
    except TableFileError:
        raise
    except (OSError, KeyError, ValueError, TypeError, IndexError, RuntimeError, OverflowError) as error:
        raise TableFileError(f"this is not an IC file that this version can read: {error}") from None
    return {"attributes": found.attributes, "datasets": found.datasets}


def _check_digest(name: str, content: bytes) -> None:
    head = content[:_USER_BLOCK]
    magic = _MAGIC.match(head)
    if magic is not None and int(magic[1]) > 1:
        raise TableFileError(f"{name} was written by a newer version of contactd")
    _, mark, rest = head.partition(_DIGEST)
    if magic is None or not mark or len(content) <= _USER_BLOCK:
        raise TableFileError(f"{name} is not an IC file of contactd, or its beginning is lost")
    if hashlib.sha256(content[_USER_BLOCK:]).hexdigest().encode() != rest[:64]:
        raise TableFileError(f"{name} is damaged: it does not match its digest")


def file_of(contents: FileContents) -> bytes:
    """Returns a file with the same contents, written by contactd."""
    import h5py

    image = io.BytesIO()
    with h5py.File(image, "w") as file:
        for path, array in contents.datasets.items():
            file.create_dataset(path, data=array, dtype="<f8")
        for path, value in contents.attributes.items():
            parent, _, name = path.rpartition("/")
            at = file[parent] if parent in file else file.create_group(parent) if parent else file
            at.attrs.create(name, value, dtype=_type_of(value, h5py))
    head = _OURS + _DIGEST + hashlib.sha256(image.getvalue()).hexdigest().encode() + b"\n"
    return head.ljust(_USER_BLOCK, b"\0") + image.getvalue()


def _type_of(value: Value, h5py: Any) -> Any:
    first = value[0] if isinstance(value, list) else value
    if isinstance(first, str):
        return h5py.string_dtype()
    return "<i8" if isinstance(first, int) else "<f8"


class _Reader:
    """Reads a file. Objects with several links count each time they are read, so the total is bounded by the file
    size.
    """

    def __init__(self, h5py: Any, size: int) -> None:
        self._h5py = h5py
        self._size = self._left = size
        self._found = FileContents()

    def read(self, file: Any) -> FileContents:
        number = self._value(file.attrs.get_id("contactd_format"), "contactd_format") if "contactd_format" in file.attrs else None
        if number != _FORMAT:  # first, because another format may contain anything
            raise TableFileError(f"its format differs from {_FORMAT}, which this version reads")
        self._group(file, "", 0)
        return self._found

    def _group(self, group: Any, prefix: str, depth: int) -> None:
        self._attributes(group, prefix)
        if len(group) > _MOST_LINKS:
            raise TableFileError(f"{prefix or 'the file'} has more links than these files use")
        for name, member in own_members(self._h5py, group):
            path = prefix + name
            if not _PATH.fullmatch(path) or len(path) > _LONGEST_PATH:
                raise TableFileError(f"{path[:100]!r} is not a name in these files")
            self._take(len(name), path)
            if isinstance(member, self._h5py.Dataset):
                self._dataset(member, path)
            elif depth < _DEEPEST:
                self._group(member, path + "/", depth + 1)
            else:
                raise TableFileError(f"{path} is nested too deeply")

    def _dataset(self, dataset: Any, path: str) -> None:
        plist, low = dataset.id.get_create_plist(), dataset.id
        if len(self._found.datasets) == _MOST_DATASETS:
            raise TableFileError(f"{path} exceeds the largest number of datasets")
        if not has_own_data(self._h5py, dataset):
            raise TableFileError(f"{path} stores its data in other files")
        if plist.get_layout() != self._h5py.h5d.CONTIGUOUS or plist.get_nfilters() != 0:
            raise TableFileError(f"{path} is not stored contiguously; chunks, filters and external parts are not supported")
        if not low.get_type().equal(self._h5py.h5t.IEEE_F64LE):
            raise TableFileError(f"{path} does not contain doubles")
        shape = dataset.shape
        if not shape or len(shape) > _MOST_AXES or min(shape) < 1:
            raise TableFileError(f"{path} has a shape that these files do not use")
        size = 8
        for extent in shape:
            size *= extent
        offset = low.get_offset()
        if offset is None or low.get_storage_size() != size or offset + size > self._size:
            raise TableFileError(f"{path} was not written, or has a shape larger than the file")
        self._take(size, path)
        self._attributes(dataset, path + "/")
        self._found.datasets[path] = np.asarray(dataset[()], dtype=np.float64)

    def _attributes(self, at: Any, prefix: str) -> None:
        count = self._h5py.h5a.get_num_attrs(at.id)
        for index in range(count):
            attribute = self._h5py.h5a.open(at.id, index=index)
            path = prefix + attribute.name.decode("utf-8", "replace")
            if len(self._found.attributes) == _MOST_ATTRIBUTES or not _PATH.fullmatch(path) or len(path) > _LONGEST_PATH:
                raise TableFileError(f"{path[:100]!r} is not an attribute of these files, or exceeds their largest number")
            self._found.attributes[path] = self._value(attribute, path)

    def _value(self, attribute: Any, path: str) -> Value:
        shape, kind = attribute.shape, attribute.get_type()
        if attribute.get_space().get_simple_extent_type() == self._h5py.h5s.NULL or len(shape) > 1:
            raise TableFileError(f"{path} has no value, or a value with too many axes")
        count = shape[0] if shape else 1
        if not 1 <= count <= _LONGEST_LIST:
            raise TableFileError(f"{path} is a list that is empty or too long")
        self._take(8 * count, path)
        is_text = isinstance(kind, self._h5py.h5t.TypeStringID) and kind.is_variable_str()
        is_number = kind.equal(self._h5py.h5t.IEEE_F64LE) or (not shape and kind.equal(self._h5py.h5t.STD_I64LE))
        if not (is_text or is_number) or (is_text and count > _MOST_TEXTS):
            raise TableFileError(f"{path} is neither a number, a string, nor a supported list of them")
        values = np.empty(shape, dtype=kind.dtype)
        attribute.read(values)
        if not is_text:
            result: Value = values.tolist()
            return result
        texts = [self._text(value, path) for value in values.reshape(-1).tolist()]
        return texts if shape else texts[0]

    def _text(self, value: Any, path: str) -> str:
        if not isinstance(value, bytes | str):
            raise TableFileError(f"{path} is a string that was not written")
        text = value if isinstance(value, str) else value.decode("utf-8", "replace")
        if len(text) > _LONGEST_TEXT:
            raise TableFileError(f"{path} is a string that is too long")
        self._take(len(text), path)
        return text

    def _take(self, size: int, path: str) -> None:
        if size > self._left:
            raise TableFileError(f"{path} exceeds the size of the file")
        self._left -= size

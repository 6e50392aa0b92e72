"""Protects readers against HDF5 files that refer to other files, which files of contactd never do."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ..errors import MissingExtra

__all__ = ["has_own_data", "need_h5py", "own_members"]


def own_members(h5py: Any, group: Any) -> Iterator[tuple[str, Any]]:
    """Returns datasets and groups of a group. Raises ValueError for links to another place or file, and for other
    objects.
    """
    for name in group:
        if not isinstance(group.get(name, getlink=True), h5py.HardLink):
            raise ValueError(f"{name} is an external or soft link, which these files must not contain")
        if group.get(name, getclass=True) not in (h5py.Dataset, h5py.Group):
            raise ValueError(f"{name} is neither a dataset nor a group")
        yield name, group[name]


def has_own_data(h5py: Any, dataset: Any) -> bool:
    """Returns whether the data of a dataset are in the file itself."""
    how = dataset.id.get_create_plist()
    return bool(how.get_external_count() == 0 and how.get_layout() != h5py.h5d.VIRTUAL)


def need_h5py() -> Any:
    """Returns the package h5py. Raises MissingExtra if it is not installed."""
    try:
        import h5py
    except ImportError:
        raise MissingExtra("A table in a file of HDF5, unlike .npz and .txt,", "h5py", "hdf5", "python3-h5py") from None
    return h5py

"""The library of HDF5, and what it does for whoever reads a file of a stranger, and no file of contactd asks for: reading
other files."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ..errors import MissingExtra

__all__ = ["has_own_data", "need_h5py", "own_members"]


def own_members(h5py: Any, group: Any) -> Iterator[tuple[str, Any]]:
    """Datasets and groups of a group. Raises ValueError for a link to another place or another file, and for what is
    neither."""
    for name in group:
        if not isinstance(group.get(name, getlink=True), h5py.HardLink):
            raise ValueError(f"{name} is a link to somewhere else; these files have none")
        if group.get(name, getclass=True) not in (h5py.Dataset, h5py.Group):
            raise ValueError(f"{name} is neither a dataset nor a group")
        yield name, group[name]


def has_own_data(h5py: Any, dataset: Any) -> bool:
    """Whether its data lie in the file itself."""
    how = dataset.id.get_create_plist()
    return bool(how.get_external_count() == 0 and how.get_layout() != h5py.h5d.VIRTUAL)


def need_h5py() -> Any:
    """The package. Raises MissingExtra where it is missing."""
    try:
        import h5py
    except ImportError:
        raise MissingExtra("A table in a file of HDF5, unlike .npz and .txt,", "h5py", "hdf5", "python3-h5py") from None
    return h5py

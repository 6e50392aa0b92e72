"""Reads and writes table files by their extension (docs/ic-tables.md, Exchange):

========  ====================================  ========================================================== ``.npz``
IcTable or TableIcs                   numpy archive: the array, and its description as JSON ``.txt``  TableIcs (IcTable:
two such bodies)   text for the CONTACT program ``.h5``   IcTable, loading only (needs h5py)    contactd's IC file, as
returned by `Client.export_ic` ========  ====================================
==========================================================
"""

from __future__ import annotations

import io
import json
import math
import os
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import ProtocolError, TableFileError
from ..refusals import public
from ..values.answers import read
from ..values.contact_params import table_params
from ..values.generated.evidence import IcEvidence
from ..values.tables import IcSpec, IcTable, TableIcs, check_finite
from .whole import MOST_BYTES, arrays_of, read_whole, write_whole

__all__ = ["load_table", "save_table"]

PathLike = str | os.PathLike[str]
_ONE_ARRAY = b"\x93NUMPY"  #: First bytes of a .npy file of one array, which is not an archive.


@public
def save_table(path: PathLike, table: IcTable | TableIcs, *, G: float | None = None) -> None:
    """Writes `table` to a file `.npz` or `.txt`. For `.txt`, `G` is that of TableIcs.to_contact_text.

    The file is first written under another name, so it is never incomplete.
    """
    suffix = _suffix(path)
    if isinstance(table, IcTable) and table.frames is not None and suffix == ".txt":
        raise ValueError(
            f"{os.fspath(path)!r} would be a text of offsets along x and y, but a longitudinally uniform body has columns: use .npz"
        )
    if suffix == ".npz":
        return write_whole(path, lambda file: np.savez(file, **_members(table)))
    if suffix == ".txt":
        pair = table if isinstance(table, TableIcs) else TableIcs.from_table(table)
        text = pair.to_contact_text(G)
        return write_whole(path, lambda file: file.write(text.encode("ascii")))
    raise ValueError(
        f"{os.fspath(path)!r} would be an HDF5 file, which the daemon writes: save the bytes of "
        'Client.export_ic(material, grid, ics, "hdf5").'
    )


@public
def load_table(path: PathLike, *, G: float | None = None) -> IcTable | TableIcs:
    """Reads a file written by save_table or Client.export_ic. For `.txt`, `G` is that of TableIcs.from_contact_text.

    Raises TableFileError if the file has no table or is damaged, and OSError if it cannot be read.
    """
    suffix = _suffix(path)
    if suffix == ".txt":
        return TableIcs.from_contact_text(path, G)
    if suffix == ".npz":
        return _read_npz(path)
    from .ic_files import read_hdf5

    table = read_hdf5(path)
    _check(table.array, table.spec, os.fspath(path))
    return table


def _suffix(path: PathLike) -> str:
    suffix = Path(path).suffix.lower()
    if suffix not in (".npz", ".txt", ".h5"):
        raise ValueError(f"{os.fspath(path)!r} must end in .npz, .txt or .h5, which determines the format.")
    return suffix


def _members(table: IcTable | TableIcs) -> dict[str, Any]:
    if isinstance(table, TableIcs):
        pair = {"dx": table.dx, "dy": table.dy, "G": table.G}
        return {"array": table.array, "pair": json.dumps(pair)}
    spec = table_params(table.spec.material, table.spec.grid, table.spec.ics)
    evidence = asdict(table.evidence)
    members = {"array": table.array, "key": table.key, "spec": json.dumps(spec), "evidence": json.dumps(evidence)}
    return members if table.frames is None else {**members, "frames": table.frames}


def _read_npz(path: PathLike) -> IcTable | TableIcs:
    name = os.fspath(path)
    content = io.BytesIO(read_whole(path, MOST_BYTES))
    try:
        members = {} if content.getvalue().startswith(_ONE_ARRAY) else arrays_of(content)
    except Exception:  # zipfile and numpy may raise any exception for a damaged archive.
        raise TableFileError(f"{name} is not an archive of numpy, or is damaged; use a file of save_table") from None
    array = members.get("array")
    frames = members.get("frames")
    shape = "[3, 3, ny, nx]" if frames is None else "[3, 3, ny, ny, nx], with frames"
    if array is None or array.dtype.kind != "f" or array.ndim != 4 + (frames is not None) or array.shape[:2] != (3, 3):
        raise TableFileError(f'{name} contains no table; it must have an array "array" of shape {shape}')
    if "pair" in members:
        pair = _json(members, "pair", name)
        try:
            dx, dy, G = float(pair["dx"]), float(pair["dy"]), pair.get("G")
            G = None if G is None else float(G)
        except (KeyError, TypeError, ValueError, AttributeError):
            raise TableFileError(f'{name}: "pair" must contain dx and dy, and G or null') from None
        try:
            return TableIcs(array, dx, dy, G)
        except ValueError as error:
            raise TableFileError(f"{name}: {error}") from None
    try:
        spec = read(IcSpec, _json(members, "spec", name), "spec")
        evidence = read(IcEvidence, _json(members, "evidence", name), "evidence")
    except ProtocolError as error:
        raise TableFileError(f"{name}: {str(error).replace('answer', 'file')}") from None
    if array.shape[-2:] != spec.grid.shape or (frames is not None and array.shape[2] != spec.grid.ny):
        raise TableFileError(f"{name}: array has shape {list(array.shape)}; spec.grid requires {list(spec.grid.shape)}")
    if frames is not None and (frames.dtype.kind != "f" or frames.shape != (spec.grid.ny, 3) or not np.isfinite(frames).all()):
        raise TableFileError(f'{name}: "frames" must be finite and of shape [ny, 3], ny = {spec.grid.ny}')
    _check(array, spec, name)
    return IcTable(str(members.get("key", "")), "file", spec, array, evidence, frames)


def _check(array: np.ndarray[Any, Any], spec: IcSpec, name: str) -> None:
    """Raises TableFileError if a file contains values that are invalid in a table."""
    sizes = {"dx": spec.grid.dx, "dy": spec.grid.dy, "G": spec.material.G}
    for field, size in sizes.items():
        if not (math.isfinite(size) and size > 0):
            raise TableFileError(f"{name}: spec has {field} = {size}; it must be positive and finite")
    if not 0 <= spec.material.nu <= 0.5:
        raise TableFileError(f"{name}: spec has nu = {spec.material.nu}; it must lie in [0, 0.5]")
    try:
        check_finite(array)
    except ValueError as error:
        raise TableFileError(f"{name}: {error}") from None


def _json(members: dict[str, Any], member: str, name: str) -> Any:
    if member not in members:
        raise TableFileError(f'{name} lacks "{member}", JSON that describes the array')
    try:
        return json.loads(str(members[member]))
    except ValueError:
        raise TableFileError(f'{name}: "{member}" is not JSON') from None

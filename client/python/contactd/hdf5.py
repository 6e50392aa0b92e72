"""Reading contactd's IC files (docs/ic-tables.md). Needs h5py, which nothing else in this package does."""

from __future__ import annotations

import hashlib
import io
import os
from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from .errors import ContactdError, TableFileError
from .grid import Grid
from .ics import AnalyticIcs, FemIcs
from .materials import Layer, LayeredBody, Material, RigidBody
from .solution import ComponentError, IcErrors, IcEvidence, IcSpec, IcTable, LoadCase, SectionEvidence

__all__ = ["read_hdf5", "stored_extent"]

_USER_BLOCK = 512
_DIGEST = b"sha256 of the bytes after this block: "
_FORMAT = 2
_MOST_ELEMENTS = 4_000_000  #: of any grid


T = TypeVar("T")


def read_hdf5(path: str | os.PathLike[str]) -> IcTable:
    """The table of an IC file: in mm^3/N when it came from Client.export_ic, for dx = 1 and G = 1 from the store."""
    return _read(path, _table)


def stored_extent(path: str | os.PathLike[str]) -> tuple[int, int]:
    """(ny, nx) of what a file of the store holds: a table, a family of them, or the transform of a prism, which serves as
    many elements along x as any grid has. Raises TableFileError, also for what is no file of a store."""
    return _read(path, _stored_extent)


def _read(path: str | os.PathLike[str], read: Callable[[Any, str], T]) -> T:
    try:
        import h5py
    except ImportError:
        raise ContactdError(
            "Reading HDF5 files needs the package h5py: pip install h5py, or on Debian python3-h5py. "
            "Files .npz and .txt can be read without it."
        ) from None
    name, content = os.fspath(path), Path(path).read_bytes()
    _check_digest(name, content)
    try:
        with h5py.File(io.BytesIO(content[_USER_BLOCK:]), "r") as file:
            if _attributes(file).get("contactd_format") != _FORMAT:
                raise TableFileError(f"{name} has another format than {_FORMAT}, which this version reads")
            return read(file, name)
    except (OSError, KeyError, ValueError, TypeError, IndexError, RuntimeError) as error:
        if isinstance(error, TableFileError):
            raise
        raise TableFileError(f"{name} is no IC file that this version can read: {error}") from None


def _check_digest(name: str, content: bytes) -> None:
    _, mark, rest = content[:_USER_BLOCK].partition(_DIGEST)
    if not mark or len(content) <= _USER_BLOCK:
        raise TableFileError(f"{name} is no IC file of contactd, or its beginning is lost")
    if hashlib.sha256(content[_USER_BLOCK:]).hexdigest().encode() != rest[:64]:
        raise TableFileError(f"{name} is damaged: it does not match its digest")


def _table(file: Any, name: str) -> IcTable:
    spec, evidence = _attributes(file["spec"]), file["evidence"]
    if spec.get("any_nu"):
        raise TableFileError(f"{name} holds a family of tables; ask the daemon for the one of a material (export_ic)")
    is_prism = spec.get("body") == "prism"
    if is_prism and "influence_coefficients" not in file:
        raise TableFileError(f"{name} holds the transform of a prism; give it to a daemon (import_ic), which makes tables of it")
    array = np.asarray(file["influence_coefficients"], dtype=np.float64)
    if array.ndim != 4 + is_prism or array.shape[:2] != (3, 3):
        rows = "ny, ny, nx" if is_prism else "ny, nx"
        raise TableFileError(f"{name}: the table has shape {list(array.shape)}; it must be [3, 3, {rows}]")
    dx = spec.get("dx", 1.0)
    grid = Grid(array.shape[-1], array.shape[-2], dx, spec.get("dy", dx * spec["dy_over_dx"]))
    frames = _frames(file, grid, name) if is_prism else None
    kind: type[Any] = FemIcs if spec["source"] == "fem" else AnalyticIcs
    ics = kind(**{f.name: spec[f.name] for f in fields(kind) if f.name in spec and f.name != "any_nu"})
    layers = file["spec"].get("layers")
    material = Material(spec.get("G", 1.0), spec["nu"]) if layers is None else _layered(_attributes(layers))
    return IcTable("", "file", IcSpec(material, grid, ics), array, _evidence(evidence), frames)


def _stored_extent(file: Any, name: str) -> tuple[int, int]:
    spec = _attributes(file["spec"])
    if "dx" in spec:
        raise TableFileError(f"{name} is in mm^3/N, as ic.export writes it; a store's files are for dx = 1 and G = 1")
    if spec.get("body") != "prism":
        ny, nx = file["influence_coefficients"].shape[2:]
        return ny, nx
    transform, columns = np.asarray(file["transform"], dtype=np.float64), len(file["frames"])
    pairs = 3 * columns * (3 * columns + 1) // 2
    if columns < 1 or transform.ndim != 2 or transform.shape[1] != pairs or not np.isfinite(transform).all():
        raise TableFileError(f"{name} holds no transform of {columns} columns: of {pairs} finite numbers for each wavenumber")
    return columns, _MOST_ELEMENTS // columns


def _frames(file: Any, grid: Grid, name: str) -> Any:
    """Of a prism's columns; in the file their places are over the width of a column."""
    frames = np.asarray(file["frames"], dtype=np.float64)
    if frames.shape != (grid.ny, 3):
        raise TableFileError(f"{name}: the frames have shape {list(frames.shape)}; they must be [ny, 3], ny = {grid.ny}")
    return frames * [grid.dy, grid.dy, 1.0]


def _layered(said: dict[str, Any]) -> LayeredBody:
    layers = [Layer(*numbers) for numbers in zip(said["thickness"], said["G"], said["nu"], strict=True)]
    return LayeredBody(layers, Material(said["base_G"], said["base_nu"]) if "base_G" in said else RigidBody())


def _evidence(group: Any) -> IcEvidence:
    said = _attributes(group)
    is_built = said["elements"] > 0  # the file has a place for all the rest, too, of a table that was not
    stages = ("assembly", "setup", "solve", "total") if is_built else ()
    cases = [_attributes(group[f"load_case_{n}"]) for n in range(sum(k.startswith("load_case_") for k in group))]
    mesh = _attributes(group["mesh"]) if "mesh" in group else None
    return IcEvidence(
        source=said["source"],
        version=said["version"],
        elements=said["elements"],
        dofs=said["dofs"],
        processes=said["processes"] if is_built else 0,
        seconds={stage: said[f"{stage}_seconds"] for stage in stages},
        load_cases=tuple(
            LoadCase(
                load="xyz"[case["load_axis"]],
                iterations=case["iterations"],
                residual=case["residual"],
                converged=bool(case["converged"]),
                seconds=case["seconds"],
                update=case.get("update"),
            )
            for case in cases
        ),
        errors=_errors(said),
        errors_estimated=bool(said["errors_estimated"]),
        warnings=tuple(said.get("warnings", ())),
        solver=said.get("solver"),
        mesh=None if mesh is None else FemIcs(**{f.name: mesh[f.name] for f in fields(FemIcs) if f.name in mesh}),
        family_nu=tuple(said.get("family_nu", ())),
        interpolation_error=said.get("interpolation_error"),
        modelling_error=said.get("modelling_error"),
        section=_section(said),
    )


def _section(said: dict[str, Any]) -> SectionEvidence | None:
    if "section_order" not in said:
        return None
    order, error = said["section_order"], said["section_error"]
    return SectionEvidence(order=order, error=error, **{f.name: said[f.name] for f in fields(SectionEvidence) if f.name in said})


def _errors(said: dict[str, Any]) -> IcErrors | None:
    if "error_zz_origin" not in said:
        return None
    xx, yy, zz = (ComponentError(said[f"error_{c}_origin"], said[f"error_{c}_largest"]) for c in ("xx", "yy", "zz"))
    return IcErrors(xx, yy, zz, said["scaled_error_xy"], said["scaled_error_xz"])


def _attributes(at: Any) -> dict[str, Any]:
    """Attributes as plain values of Python; lists as lists."""
    return {name: value.tolist() if hasattr(value, "tolist") else value for name, value in at.attrs.items()}

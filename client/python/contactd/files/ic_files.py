"""Reads tables of contactd's IC files (docs/ic-tables.md). Needs h5py."""

from __future__ import annotations

import itertools
import os
from collections.abc import Callable
from dataclasses import fields
from typing import Any, TypeVar

import numpy as np

from ..errors import TableFileError
from ..values.generated.evidence import ComponentError, IcErrors, IcEvidence, LoadCase, SectionEvidence
from ..values.generated.fem_ics import FemIcs
from ..values.generated.grid import Grid
from ..values.generated.ics import AnalyticIcs
from ..values.generated.materials import Layer, LayeredBody, Material, RigidBody
from ..values.tables import IcSpec, IcTable
from .hdf5 import need_h5py
from .ic_contents import FileContents, contents_of
from .whole import MOST_BYTES, read_whole

__all__ = ["import_params", "imported_contents", "read_hdf5", "stored_extent"]

_IMPORTED = "This table was imported from a file"
_MOST_ELEMENTS = 4_000_000  #: Largest number of elements of a grid.


T = TypeVar("T")


def read_hdf5(path: str | os.PathLike[str]) -> IcTable:
    """Returns the table of an IC file: in mm^3/N from Client.export_ic; for dx = 1 and G = 1 from the store."""
    return _read(path, _table)


def stored_extent(path: str | os.PathLike[str]) -> tuple[int, int]:
    """Returns (ny, nx) of a file of the store: a table, a family of tables, or the transform of a longitudinally
    uniform body, which applies to any number of elements along x. Raises TableFileError, also for files of other
    formats.
    """
    return _read(path, _stored_extent)


def import_params(content: bytes) -> dict[str, Any]:
    """Returns the parameters of ic.import for the content of a file. Raises TableFileError."""
    contents = contents_of(content, "the file")
    datasets: dict[str, Any] = dict(contents.datasets)
    if "transform" in datasets:
        datasets.pop("influence_coefficients", None)  # computed from the transform
    return {"attributes": contents.attributes, "datasets": datasets}


def imported_contents(path: str | os.PathLike[str]) -> FileContents:
    """Returns the contents of a file of another store, marked as imported in its evidence. Raises TableFileError."""
    contents = contents_of(read_whole(path, MOST_BYTES), os.fspath(path))
    warnings = contents.attributes.get("evidence/warnings", [])
    if not isinstance(warnings, list):
        raise TableFileError(f"{os.fspath(path)}: evidence/warnings is not a list")
    kept = [str(warning) for warning in warnings if not str(warning).startswith(_IMPORTED)]
    sentence = f"{_IMPORTED}. Its numbers have not been verified."
    contents.attributes |= {"evidence/imported": 1, "evidence/warnings": [*kept, sentence]}
    return contents


def _read(path: str | os.PathLike[str], read: Callable[[FileContents, str], T]) -> T:
    need_h5py()  # Report a missing package before a missing file.
    name = os.fspath(path)
    contents = contents_of(read_whole(path, MOST_BYTES), name)
    try:
        return read(contents, name)
    except (KeyError, ValueError, TypeError, IndexError) as error:
        if isinstance(error, TableFileError):
            raise
        raise TableFileError(f"{name} is not an IC file that this version can read: {error}") from None


def _table(file: FileContents, name: str) -> IcTable:
    spec = file.at("spec")
    if spec.get("any_nu"):
        raise TableFileError(f"{name} contains a family of tables; request the table of one material from the daemon (export_ic)")
    is_uniform = spec.get("body") == "longitudinally_uniform"
    if is_uniform and "influence_coefficients" not in file.datasets:
        raise TableFileError(
            f"{name} contains the transform of a longitudinally uniform body; import it into a daemon (import_ic), which computes tables from it"
        )
    array = file.datasets["influence_coefficients"]
    if array.ndim != 4 + is_uniform or array.shape[:2] != (3, 3):
        rows = "ny, ny, nx" if is_uniform else "ny, nx"
        raise TableFileError(f"{name}: the table has shape {list(array.shape)}; it must be [3, 3, {rows}]")
    dx = spec.get("dx", 1.0)
    grid = Grid(array.shape[-1], array.shape[-2], dx, spec.get("dy", dx * spec["dy_over_dx"]))
    frames = _frames(file, grid, name) if is_uniform else None
    kind: type[Any] = FemIcs if spec["source"] == "fem" else AnalyticIcs
    ics = kind(**{f.name: spec[f.name] for f in fields(kind) if f.name in spec and f.name != "any_nu"})
    is_layered = file.has("spec/layers")
    material = _layered(file.at("spec/layers")) if is_layered else Material(spec.get("G", 1.0), spec["nu"])
    return IcTable("", "file", IcSpec(material, grid, ics), array, _evidence(file), frames)


def _stored_extent(file: FileContents, name: str) -> tuple[int, int]:
    spec = file.at("spec")
    if "dx" in spec:
        raise TableFileError(f"{name} is in mm^3/N, as written by ic.export, but files of a store are for dx = 1 and G = 1")
    if spec.get("body") != "longitudinally_uniform":
        ny, nx = file.datasets["influence_coefficients"].shape[2:]
        return ny, nx
    transform, columns = file.datasets["transform"], len(file.datasets["frames"])
    pairs = 3 * columns * (3 * columns + 1) // 2
    if columns < 1 or transform.ndim != 2 or transform.shape[1] != pairs or not np.isfinite(transform).all():
        raise TableFileError(f"{name} contains no transform of {columns} columns, with {pairs} finite numbers for each wavenumber")
    return columns, _MOST_ELEMENTS // columns


def _frames(file: FileContents, grid: Grid, name: str) -> Any:
    """Reads the frames of the columns of a longitudinally uniform body. In the file, positions are divided by the
    column width.
    """
    frames = file.datasets["frames"]
    if frames.shape != (grid.ny, 3):
        raise TableFileError(f"{name}: the frames have shape {list(frames.shape)}; they must be [ny, 3], ny = {grid.ny}")
    return frames * [grid.dy, grid.dy, 1.0]


def _layered(given: dict[str, Any]) -> LayeredBody:
    layers = [Layer(*numbers) for numbers in zip(given["thickness"], given["G"], given["nu"], strict=True)]
    return LayeredBody(layers, Material(given["base_G"], given["base_nu"]) if "base_G" in given else RigidBody())


def _evidence(file: FileContents) -> IcEvidence:
    given = file.at("evidence")
    is_built = given["elements"] > 0  # The file also has fields for the evidence of other tables.
    stages = ("assembly", "setup", "solve", "total") if is_built else ()
    places = (f"evidence/load_case_{n}" for n in range(len(file.attributes)))
    cases = [file.at(place) for place in itertools.takewhile(file.has, places)]
    mesh = file.at("evidence/mesh") if file.has("evidence/mesh") else None
    return IcEvidence(
        source=given["source"],
        version=given["version"],
        elements=given["elements"],
        dofs=given["dofs"],
        processes=given["processes"] if is_built else 0,
        seconds={stage: given[f"{stage}_seconds"] for stage in stages},
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
        errors=_errors(given),
        errors_estimated=bool(given["errors_estimated"]),
        warnings=tuple(given.get("warnings", ())),
        solver=given.get("solver"),
        mesh=None if mesh is None else FemIcs(**{f.name: mesh[f.name] for f in fields(FemIcs) if f.name in mesh}),
        family_nu=tuple(given.get("family_nu", ())),
        interpolation_error=given.get("interpolation_error"),
        modelling_error=given.get("modelling_error"),
        section=_section(given),
        imported=bool(given.get("imported", 0)),
    )


def _section(given: dict[str, Any]) -> SectionEvidence | None:
    if "section_order" not in given:
        return None
    order, error = given["section_order"], given["section_error"]
    return SectionEvidence(order=order, error=error, **{f.name: given[f.name] for f in fields(SectionEvidence) if f.name in given})


def _errors(given: dict[str, Any]) -> IcErrors | None:
    if "error_zz_origin" not in given:
        return None
    xx, yy, zz = (ComponentError(given[f"error_{c}_origin"], given[f"error_{c}_largest"]) for c in ("xx", "yy", "zz"))
    return IcErrors(xx, yy, zz, given["scaled_error_xy"], given["scaled_error_xz"])

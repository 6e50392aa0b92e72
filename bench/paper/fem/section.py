"""Defines section 3 for the modules common to all sections."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import Any

from ..section import Measure, Section, Table
from . import diagrams, figures, mesh_picture
from .cases import PARTS, Spec, effort
from .findings import find
from .measure import measure_with
from .recommended import RANGE_COLUMNS, ranges
from .rows import COLUMNS, PART_COLUMNS, row


def efforts(specs: Sequence[Spec]) -> list[float]:
    return [effort(spec) for spec in specs]


def summary(result: dict[str, Any]) -> str:
    if "update" in result:
        return f"{result['dofs']:7} dofs, {result['update']['iterations']} and {result['residual']['iterations']} iterations"
    if "faces" in result:
        return f"{result['elements']} elements"
    if "zz" in result:
        return f"differs by {max(one['contactd_difference'] for one in result.values()):.1e}"
    error = next(iter(result["errors"].values()))["zz"]["origin"]
    return f"{result['dofs']:7} dofs, {result['cpu_seconds']:6.1f} s CPU, origin {100 * error:+7.3f} %"


def solver(programs: Path) -> AbstractContextManager[Measure]:
    return nullcontext(measure_with(programs))


SECTION = Section(
    name="fem",
    number=3,
    parts=PARTS,
    columns=COLUMNS,
    row=row,
    pictures={
        "meshes": mesh_picture.meshes,
        "fig5": figures.fig5, "fig6": figures.fig6, "fig7": figures.fig7, "fig8": figures.fig8,
        "orders": figures.orders, "mesh2_grids": figures.mesh2_grids,
        "accuracy": diagrams.accuracy, "adaptive": diagrams.adaptive,
    },
    find=find,
    efforts=efforts,
    summary=summary,
    solver=solver,
    part_columns=PART_COLUMNS,
    tables={"table3": Table("table3-ranges", RANGE_COLUMNS, ranges)},
)  # fmt: skip

"""Defines the section on cross-sections for the modules common to all sections."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..section import Section
from . import figures
from .cases import PARTS, Spec, effort
from .findings import find
from .measure import solver
from .rows import COLUMNS, PART_COLUMNS, row


def efforts(specs: Sequence[Spec]) -> list[float]:
    return [effort(spec) for spec in specs]


def summary(result: dict[str, Any]) -> str:
    if "p0" in result:
        return f"p0 {result['p0']:.4f}, exactly {result['p0_exact']:.4f}; half angle {result['half_angle']:.2f} degrees"
    if "ic_largest" in result:
        return f"coefficients off by {result['ic_largest']:.1e}, largest pressure by {result['p0_error']:+.1e}"
    if "dofs" in result:
        return f"{result['dofs']} unknowns, {result['seconds']:.0f} s, differs by {result['found']:.1e}"
    if "pmax" in result:
        return f"pmax {result['pmax']:.0f} N/mm², approach {1000 * result['approach']:.1f} µm"
    return f"error stated {result['stated']:.1e}, found {result['found']:.1e}"


SECTION = Section(
    name="sections",
    number=None,
    parts=PARTS,
    columns=COLUMNS,
    row=row,
    pictures={
        "edges": figures.edges,
        "throat": figures.throat,
        "tables": figures.tables,
        "persson": figures.persson,
        "solid": figures.solid,
    },
    find=find,
    efforts=efforts,
    summary=summary,
    solver=solver,
    part_columns=PART_COLUMNS,
)

"""Cross-sections for the machinery that all sections share."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..section import Section
from . import figures
from .cases import PARTS, Spec, effort
from .findings import find
from .measure import solver
from .rows import COLUMNS, row


def efforts(specs: Sequence[Spec]) -> list[float]:
    return [effort(spec) for spec in specs]


def summary(result: dict[str, Any]) -> str:
    if "pmax" in result:
        return f"pmax {result['pmax']:.0f} N/mm², approach {1000 * result['approach']:.1f} µm"
    return f"error stated {result['stated']:.1e}, found {result['found']:.1e}"


SECTION = Section(
    name="sections",
    number=None,
    parts=PARTS,
    columns=COLUMNS,
    row=row,
    pictures={"edges": figures.edges, "throat": figures.throat, "tables": figures.tables},
    find=find,
    efforts=efforts,
    summary=summary,
    solver=solver,
)

"""Section 3 for the machinery that all sections share."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import Any

from ..section import Measure, Section, Table
from . import diagrams, figures
from .cases import PARTS, Spec, effort
from .findings import find
from .measure import Builder
from .recommended import RANGE_COLUMNS, ranges
from .rows import COLUMNS, row


def efforts(specs: Sequence[Spec]) -> list[float]:
    return [effort(spec) for spec in specs]


def summary(result: dict[str, Any]) -> str:
    error = next(iter(result["errors"].values()))["zz"]["origin"]
    return f"{result['dofs']:7} dofs, {result['cpu_seconds']:6.1f} s CPU, origin {100 * error:+7.3f} %"


def solver(programs: Path) -> AbstractContextManager[Measure]:
    return nullcontext(Builder(programs / "contactd-ic").measure)


SECTION = Section(
    name="fem",
    number=3,
    parts=PARTS,
    columns=COLUMNS,
    row=row,
    pictures={
        "fig5": figures.fig5, "fig6": figures.fig6, "fig7": figures.fig7, "fig8": figures.fig8,
        "accuracy": diagrams.accuracy, "adaptive": diagrams.adaptive,
    },
    find=find,
    efforts=efforts,
    summary=summary,
    solver=solver,
    tables={"table3": Table("table3-ranges", RANGE_COLUMNS, ranges)},
)  # fmt: skip

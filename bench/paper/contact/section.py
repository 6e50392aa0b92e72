"""Defines section 4 for the modules common to all sections."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from ..fem.cases import effort
from ..section import Section
from . import figures
from .cases import PARTS
from .findings import find
from .measure import solver
from .problem import FX, FZ, Spec
from .rows import COLUMNS, row


def efforts(specs: Sequence[Spec]) -> list[float]:
    """Estimates the seconds of each request, including a table for the first request that needs it."""
    built: set[str] = set()
    result = []
    for spec in specs:
        seconds = 0.1 + 2e-5 * spec["n"] ** 2
        for ics in (spec["ics"], spec.get("tangential", {})):
            table = json.dumps(ics, sort_keys=True)
            if "preset" in ics and table not in built:
                built.add(table)
                seconds += effort({"ics": ics})
        result.append(seconds)
    return result


def summary(result: dict[str, Any]) -> str:
    errors = (f"{name} {100 * (result[name] / exact - 1):+7.3f} %" for name, exact in (("Fz", FZ), ("Fx", FX)))
    return ", ".join(errors)


SECTION = Section(
    name="contact",
    number=4,
    parts=PARTS,
    columns=COLUMNS,
    row=row,
    pictures={
        "fig9": figures.fig9, "fig10": figures.fig10, "fig11": figures.fig11,
        "bilinear": figures.bilinear, "fig12": figures.fig12, "fig13": figures.fig13, "fig14": figures.fig14,
    },
    find=find,
    efforts=efforts,
    summary=summary,
    solver=solver,
)  # fmt: skip

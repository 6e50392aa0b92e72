"""Makes one row of a CSV file of section 4. Errors are relative and signed; the paper shows their magnitudes."""

from __future__ import annotations

from typing import Any

from ..rows import Row
from .cases import Case
from .problem import AREA, FX, FZ, PMAX, WINDOW

REFERENCES = {"Fz": FZ, "pmax": PMAX, "area": AREA, "Fx": FX}
_COUNTS = ["adhesion", "slip", "iterations_normal", "iterations_tangential"]
_TABLE = ["dofs", "origin_zz"]  # columns of the table; 0 in closed form
COLUMNS = [
    "curve", "parameter", "value", "n", "L", "L_over_h",
    *REFERENCES, *(f"error_{name}" for name in REFERENCES), *_COUNTS, *_TABLE,
]  # fmt: skip


def row(case: Case, result: dict[str, Any]) -> Row:
    return {
        "curve": case.curve,
        "parameter": case.parameter,
        "value": case.value,
        "n": case.n,
        "L": case.L,
        "L_over_h": case.L * case.n / WINDOW,
        **{name: result[name] for name in REFERENCES},
        **{f"error_{name}": result[name] / exact - 1 for name, exact in REFERENCES.items()},
        **{name: result[name] for name in [*_COUNTS, *_TABLE]},
    }

"""Makes one row of a CSV file, with empty cells for values that a part does not have."""

from __future__ import annotations

from typing import Any

from ..rows import Row
from .cases import Case

PLACE = ["curve", "parameter", "value"]
RESULTS = ["pmax", "approach", "Fx", "Fy", "stated", "found", "finest", "seconds"]
COLUMNS = [*PLACE, *RESULTS]
#: These parts have other columns.
PART_RESULTS = {
    "tables": ["stated", "reciprocity", "found", "finest_asked", "finest", "seconds", "preset"],
    "persson": ["p0", "p0_exact", "half_angle", "angles", "pressures"],  # lists are texts separated by blanks
    "groove": ["pmax", "approach"],
    "propagation": ["unknowns", "ic_origin", "ic_largest", "p0_error", "extent_error", "approach_error", "finest_error"],
    "solid": [
        *("found", "stated", "elements", "dofs", "loads", "iterations"),
        *("seconds", "assembly_seconds", "setup_seconds", "solve_seconds"),
        *("many_dofs", "many_loads", "transform_seconds", "transform_error"),
    ],
}
PART_COLUMNS = {part: [*PLACE, *results] for part, results in PART_RESULTS.items()}


def row(case: Case, result: dict[str, Any]) -> Row:
    return {
        "curve": case.curve,
        "parameter": case.parameter,
        "value": case.value,
        **{name: result[name] for name in PART_RESULTS.get(case.part, RESULTS) if name in result},
    }

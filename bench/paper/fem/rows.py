"""Makes one row of a CSV file of section 3."""

from __future__ import annotations

from typing import Any

from ..rows import Row
from .cases import Case

PLACE = ["curve", "parameter", "value"]
COLUMNS = [
    *PLACE, "L", "h", "table", "elements", "dofs", "solver",
    "iterations_z", "iterations_x", "iterations_y",
    "origin_zz", "origin_xx", "origin_yy", "largest_zz", "largest_xx", "largest_yy", "scaled_xy", "scaled_xz",
    "cpu_seconds", "wall_seconds", "memory_mib",
]  # fmt: skip
#: A solve is reported twice: at the end by the paper's stopping criterion, on the update, and at a true residual of
#: 1e-8.
_STOPS = [f"{stop}_{name}" for stop in ("update", "residual")
          for name in ("iterations", "seconds", "residual", "origin_error")]  # fmt: skip
#: These parts are not tables.
RESULTS = {
    "incomplete": ["elements", "dofs", "unknowns", "nonzeros", "setup_seconds", *_STOPS],
    "table1": ["paper_difference", "contactd_difference", "largest"],
    "meshes": ["elements", "vertices", "positions", "faces"],
}
PART_COLUMNS = {
    "incomplete": [*PLACE, "L", "h", *RESULTS["incomplete"]],
    **{part: [*PLACE, *RESULTS[part]] for part in ("table1", "meshes")},
}


def row(case: Case, result: dict[str, Any]) -> Row:
    place = {"curve": case.curve, "parameter": case.parameter, "value": case.value}
    if case.part == "incomplete":
        stops = {f"{stop}_{name}": value for stop in ("update", "residual") for name, value in result[stop].items()}
        flat = {**result, **stops}
        return {**place, "L": case.value, "h": case.h, **{name: flat[name] for name in RESULTS["incomplete"]}}
    if case.part in RESULTS:
        return {**place, **(result[case.curve] if case.part == "table1" else result)}
    return {**place, **_table_row(case, result)}


def _table_row(case: Case, result: dict[str, Any]) -> Row:
    mesh = result["mesh"] or case.spec["ics"]  # the mesh chosen for an accuracy
    errors = result["errors"][str(case.table)]
    relative = {
        f"{kind}_{name}": errors[name][kind] for kind in ("origin", "largest") for name in ("zz", "xx", "yy")
    }  # fmt: skip
    return {
        "L": mesh["L_over_h"] * case.h,
        "h": case.h,
        "table": case.table,
        **{name: result[name] for name in ("elements", "dofs", "solver")},
        **{f"iterations_{load}": count for load, count in result["iterations"].items()},
        **relative,
        **{name: errors[name] for name in ("scaled_xy", "scaled_xz")},
        "cpu_seconds": result["cpu_seconds"],
        "wall_seconds": result["seconds"]["total"],
        "memory_mib": result["memory_mib"],
    }

"""One row of a CSV file of section 3."""

from __future__ import annotations

from typing import Any

from ..rows import Row
from .cases import Case

COLUMNS = [
    "curve", "parameter", "value", "L", "h", "table", "elements", "dofs", "solver",
    "iterations_z", "iterations_x", "iterations_y",
    "origin_zz", "origin_xx", "origin_yy", "largest_zz", "largest_xx", "largest_yy", "scaled_xy", "scaled_xz",
    "cpu_seconds", "wall_seconds", "memory_mib",
]  # fmt: skip


def row(case: Case, result: dict[str, Any]) -> Row:
    mesh = result["mesh"] or case.spec["ics"]  # an accuracy chooses its mesh
    errors = result["errors"][str(case.table)]
    relative = {
        f"{kind}_{name}": errors[name][kind] for kind in ("origin", "largest") for name in ("zz", "xx", "yy")
    }  # fmt: skip
    return {
        "curve": case.curve,
        "parameter": case.parameter,
        "value": case.value,
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

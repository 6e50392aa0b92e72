"""Computes Table 3 from our numbers: the values that keep the error at the origin below 1 %."""

from __future__ import annotations

from collections.abc import Sequence

from ..rows import Row, select
from .cases import SCANNED_L_OVER_H, SCANS

TARGET = 0.01
RANGE_COLUMNS = ["mesh", "parameter", "L_over_h", "paper", "scanned", "within", "outside"]
#: Recommendations of Table 3. The paper prints the signs for f the other way round.
PAPER = {
    "L_over_h": {"hex": "L/h >= 80", "prism": "L/h >= 80"},
    "l_over_h": {"hex": "1 <= l/h <= 1.25", "prism": "1 <= l/h <= 1.25"},
    "h_over_hs": {"hex": "h/hs >= 4", "prism": "h/hs >= 4"},
    "f": {"hex": "1 <= f <= 1.5", "prism": "1.5 <= f <= 2"},
}


def within_target(row: Row) -> bool:
    return abs(float(row["origin_zz"])) < TARGET


def _range(mesh: str, parameter: str, L_over_h: object, rows: Sequence[Row]) -> Row:
    def listed(points: Sequence[Row]) -> str:
        return " ".join(f"{row['value']:g}" for row in points)

    return {
        "mesh": mesh,
        "parameter": parameter,
        "L_over_h": L_over_h,
        "paper": PAPER[parameter][mesh],
        "scanned": listed(rows),
        "within": listed([row for row in rows if within_target(row)]),
        "outside": listed([row for row in rows if not within_target(row)]),
    }


def ranges(rows: Sequence[Row]) -> list[Row]:
    """Returns a row for each mesh and parameter; the other parameters are those of the paper's optimal test."""
    result = []
    for mesh in ("hex", "prism"):
        result.append(_range(mesh, "L_over_h", "scanned", select(rows, curve=mesh)))
        for parameter in SCANS[mesh]:
            for L_over_h in SCANNED_L_OVER_H:
                points = select(rows, curve=f"{mesh}, L/h = {L_over_h}", parameter=parameter)
                result.append(_range(mesh, parameter, L_over_h, points))
    return result

"""Checks the bilinear load in sections 4.1.4 and 4.2 of the paper. Functions are as in findings.py."""

from __future__ import annotations

from ..finding import Found, Rows, at, percent
from ..rows import Row, select
from .cases import CHOSEN_L
from .finding import NAMES, error, falls, falls_then_rises, reversal, signed

CONSTANT = {"mesh1": "fig10", "mesh2": "fig11"}  # parts with the constant load


def _curves(rows: Rows, mesh: str) -> dict[str, list[Row]]:
    return {name: select(rows["bilinear"], curve=f"{mesh} {name}") for name in NAMES}


def bilinear(rows: Rows) -> Found:
    """Returns the largest differences between the two loads on the fine grids over all L, and on 10 x 10."""
    curves = {mesh: _curves(rows, mesh) for mesh in CHOSEN_L}

    def apart(mesh: str, names: list[str], quantity: str) -> float:
        return max(
            abs(error(row, quantity) - error(at(rows[CONSTANT[mesh]], name, row["L"]), quantity))
            for name in names for row in curves[mesh][name]
        )  # fmt: skip

    fine = {f"bilinear_{mesh}_{quantity}": apart(mesh, NAMES[:2], quantity)
            for mesh in CHOSEN_L for quantity in ("Fz", "Fx", "pmax")}  # fmt: skip
    coarse = {mesh: curves[mesh][NAMES[-1]][-1] for mesh in CHOSEN_L}
    values = {
        **{name: percent(value) for name, value in fine.items()},
        **{f"bilinear_10_{mesh}": signed(error(row, "Fz")) for mesh, row in coarse.items()},
        **{f"constant_10_{mesh}": signed(error(at(rows[CONSTANT[mesh]], NAMES[-1], row["L"]), "Fz"))
           for mesh, row in coarse.items()},
        **{f"bilinear_turn_{mesh}": reversal(curves[mesh][NAMES[0]], "pmax") for mesh in CHOSEN_L},
        "bilinear_points": f"{len(rows['bilinear'])}",
    }  # fmt: skip
    verdicts = {
        "bilinear_similar": max(fine.values()) < 2e-3,
        "bilinear_shapes": all(falls(points, "Fz") for points in curves["mesh1"].values())
        and all(falls_then_rises(points, "Fz") or error(points[-1], "Fz") < 0 for points in curves["mesh2"].values()),
        "fx_bilinear": all(falls(points, "Fx") for points in curves["mesh1"].values())
        and all(falls_then_rises(points, "Fx") for points in curves["mesh2"].values()),
    }
    return values, verdicts

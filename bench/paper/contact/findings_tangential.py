"""Checks section 4.2 of the paper, the tangential problem. Functions are as in findings.py."""

from __future__ import annotations

import math

import numpy as np

from ..finding import Found, Rows
from ..rows import select
from .cases import CHOSEN_L, COMPARED_GRIDS, FINEST, GRIDS
from .finding import NAMES, error, falls, falls_then_rises, listed, on, signed, size
from .problem import CATTANEO_FX, FX, MU, WINDOW

#: Section 4.2: the shift is the one for this Fx over mu Fz, at which Cattaneo's adhesion area has half the radius.
SHARE_OF_BOUND = 7 / 8


def reference(rows: Rows) -> Found:
    """Returns Richardson's extrapolation, F(h) = F(0) + c h^2, through pairs of grids with h and h/2."""
    force = {int(row["n"]): float(row["Fx"]) for row in rows["limit"]}
    pairs = [(n, 2 * n) for n in sorted(force) if 2 * n in force]
    limits = [force[fine] + (force[fine] - force[coarse]) / 3 for coarse, fine in pairs]
    exponents = [
        math.log2((force[n] - force[2 * n]) / (force[2 * n] - force[4 * n])) for n in sorted(force) if 4 * n in force
    ]  # fmt: skip
    adhesion = on(rows["fig14"], "analytic", FINEST)["adhesion"] * (WINDOW / FINEST) ** 2
    values = {
        "limit_pairs": ", ".join(f"{coarse} and {fine}: {limit:.6f}" for (coarse, fine), limit in zip(pairs, limits)),
        "limit_exponents": ", ".join(f"{exponent:.1f}" for exponent in exponents),
        "limit": f"{limits[-1]:.5f}",
        "limit_difference": f"{abs(limits[-1] / FX - 1):.0e}",
        "limit_forces": ", ".join(f"{force[n]:.6f} ({n})" for n in sorted(force)),
        "adhesion_radius": f"{math.sqrt(adhesion / math.pi):.3f}",
        "planar": f"{on(rows['sources'], 'analytic, no xy', FINEST)['Fx']:.4f}",
        "cattaneo": f"{CATTANEO_FX:.4f}",
    }
    return values, {"limit_agrees": round(limits[-1], 4) == FX}


def share_of_bound(rows: Rows) -> Found:
    """Returns Fx over mu Fz, with closed-form coefficients."""
    points = [on(rows["fig14"], "analytic", n) for n in reversed(COMPARED_GRIDS)]
    shares = [float(row["Fx"] / (MU * row["Fz"])) for row in points]
    planar = on(rows["sources"], "analytic, no xy", FINEST)
    values = {
        "share_list": ", ".join(f"{share:.4f}" for share in shares),
        "share": f"{shares[-1]:.4f}",
        "share_off": signed(shares[-1] / SHARE_OF_BOUND - 1),
        "share_planar_off": signed(planar["Fx"] / (MU * planar["Fz"]) / SHARE_OF_BOUND - 1),
    }
    return values, {"share_of_bound": abs(shares[-1] / SHARE_OF_BOUND - 1) < 2e-3}


def against_L(rows: Rows) -> Found:
    curves = {mesh: {name: select(rows["fig13"], curve=f"{mesh} {name}") for name in NAMES} for mesh in CHOSEN_L}
    function = {name: select(rows["fig13"], curve=f"mesh1 {name}, fem") for name in NAMES}
    last = [points[-1] for points in curves["mesh1"].values()]
    exact = {n: error(on(rows["fig14"], "analytic", n), "Fx") for n in GRIDS}
    added = [error(points[-1], "Fx") - exact[points[-1]["n"]] for points in function.values()]
    fine, _, coarse = curves["mesh1"].values()
    values = {
        "fx_1024": listed(last, "Fx"),
        "fx_reading": ", ".join(
            signed(error(a[-1], "Fx") - error(b[-1], "Fx")) for a, b in zip(curves["mesh1"].values(), function.values())
        ),
        "fx_exact": ", ".join(signed(value) for value in exact.values()),
        "fx_added": ", ".join(signed(value) for value in added),
        "fx_mesh2_160": listed(curves["mesh2"]["160x160"], "Fx"),
    }
    verdicts = {
        "fx_mesh1_falls": all(falls(points, "Fx") for points in [*curves["mesh1"].values(), *function.values()]),
        "fx_coarse_smaller": any(size(a, "Fx") < size(b, "Fx") for a, b in zip(coarse, fine)),
        "fx_accumulates": min(abs(a - b) for a, b in zip(added, added[1:])) > 0.5 * min(map(abs, added)),
        "fx_mesh2_turns": all(falls_then_rises(points, "Fx") for points in curves["mesh2"].values()),
    }
    return values, verdicts


def analytic(rows: Rows) -> Found:
    points = [on(rows["fig14"], "analytic", n) for n in reversed(COMPARED_GRIDS)]
    slope = np.polyfit(np.log([row["n"] for row in points]), np.log([size(row, "Fx") for row in points]), 1)[0]
    values = {"fx_analytic": listed(points, "Fx"), "fx_slope": f"{-slope:.1f}"}
    return values, {"fx_linear": 0.8 < -slope < 1.2 and falls(points, "Fx")}

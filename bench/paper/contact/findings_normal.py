"""Checks section 4.1 of the paper, the normal problem. Functions are as in findings.py."""

from __future__ import annotations

import math

import numpy as np

from ..finding import Found, Rows, at, percent
from ..rows import Row, select
from .cases import CHOSEN_L, FINEST, LENGTHS
from .finding import NAMES, error, falls, falls_then_rises, listed, reversal, size
from .problem import AREA, WINDOW


def analytic(rows: Rows) -> Found:
    points = sorted(rows["fig9"], key=lambda row: row["n"])
    orders = np.polyfit(np.log([row["n"] for row in points]), np.log([size(row, "pmax") for row in points]), 1)
    first, last, h = points[0], points[-1], WINDOW / FINEST
    values = {
        "fz_10": percent(error(first, "Fz")),
        "fz_160": f"{size(last, 'Fz'):.1e}",
        "pmax_list": listed(points, "pmax"),
        "pmax_order": f"{-orders[0]:.1f}",
        "area_list": listed(points, "area"),
        "area_elements": f"{(last['area'] - AREA) / h**2:.0f}",
        "area_border": f"{2 * math.sqrt(math.pi * AREA) / h:.0f}",
    }
    verdicts = {
        "fz_small": size(first, "Fz") < 0.01 and falls(points, "Fz"),
        "pmax_linear": -orders[0] < 1.5,
        "area_largest": all(size(row, "area") > max(size(row, "Fz"), size(row, "pmax")) for row in points),
        "fz_below_1e6": size(last, "Fz") < 1e-6,
    }
    return values, verdicts


def _curves(rows: Rows, part: str, suffix: str = "") -> dict[str, list[Row]]:
    return {name: select(rows[part], curve=name + suffix) for name in NAMES}


def mesh1(rows: Rows) -> Found:
    read = _curves(rows, "fig10")
    function = _curves(rows, "fig10", ", fem")
    fine, middle, coarse = (read[name] for name in NAMES)
    at_1024 = [at(read[name], name, 1024) for name in NAMES]
    values = {
        "mesh1_fz": listed(at_1024, "Fz"),
        "mesh1_fz_8": listed([points[0] for points in read.values()], "Fz"),
        "mesh1_pmax": listed(at_1024, "pmax"),
        "mesh1_pmax_fem": listed([points[-1] for points in function.values()], "pmax"),
        **{f"mesh1_turn_{name.split('x')[0]}": reversal(read[name], "pmax") for name in NAMES},
        "mesh1_area_8": listed([points[0] for points in read.values()], "area"),
        "mesh1_area_1024": listed(at_1024, "area"),
        "mesh1_origin_8": percent(fine[0]["origin_zz"]),
        "mesh1_ratio_8": f"{fine[0]['L_over_h']:.0f}",
        "mesh1_fz_160_8": percent(error(fine[0], "Fz")),
        "mesh1_fx_160_8": percent(error(fine[0], "Fx")),
    }
    verdicts = {
        "mesh1_falls": all(falls(points, "Fz") for points in [*read.values(), *function.values()]),
        "mesh1_fine_similar": all(
            abs(size(a, "Fz") - size(b, "Fz")) < abs(size(c, "Fz") - size(a, "Fz"))
            and max(size(a, "Fz"), size(b, "Fz")) < size(c, "Fz")
            for a, b, c in zip(fine[3:], middle[3:], coarse[3:])
        ),
        "mesh1_pmax_turns": all(falls_then_rises(points, "pmax") for points in (middle, coarse)),
        "mesh1_pmax_1024": falls(at_1024[::-1], "pmax"),
        "mesh1_pmax_1024_fem": falls([points[-1] for points in reversed(list(function.values()))], "pmax"),
        "mesh1_area_finest": all(
            size(a, "area") <= min(size(b, "area"), size(c, "area")) for a, b, c in zip(fine, middle, coarse)
        ),
        "mesh1_area_settles": all(size(points[-1], "area") <= size(points[0], "area") for points in read.values()),
        "target_suffices": size(fine[0], "Fz") < 0.01,
    }
    return values, verdicts


def larger_blocks(rows: Rows) -> Found:
    """Returns results on Mesh1 with L beyond the paper's, and the L with the smallest error."""
    quantities = ("Fz", "pmax", "area", "Fx")
    curves = {name + way: [*select(rows["fig10"], curve=name + way), *select(rows["larger"], curve=name + way)]
              for name in NAMES for way in ("", ", fem")}  # fmt: skip

    def best(name: str, quantity: str) -> float:
        return float(min(curves[name], key=lambda row: size(row, quantity))["L"])

    beyond = {name: points[LENGTHS.index(1024) :] for name, points in curves.items()}
    smallest = {(name, quantity): best(name, quantity) for name in curves for quantity in quantities}
    fine, fine_function = NAMES[0], NAMES[0] + ", fem"
    values = {
        "largest_L": f"{curves[fine][-1]['L']:.0f}",
        **{f"beyond_{quantity}": listed(beyond[fine], quantity) for quantity in quantities},
        **{f"beyond_{quantity}_fem": listed(beyond[fine_function], quantity) for quantity in quantities},
        **{f"best_{quantity}": ", ".join(f"{smallest[name, quantity]:.0f}" for name in NAMES)
           for quantity in quantities},
    }  # fmt: skip
    verdicts = {
        "larger_is_better": all(L == curves[name][-1]["L"] for (name, _), L in smallest.items() if name in NAMES),
        "larger_is_better_fem": all(
            L == curves[name][-1]["L"]
            for (name, quantity), L in smallest.items() if name not in NAMES and quantity in ("Fz", "Fx")
        ),
        "pmax_rises_beyond": all(size(b, "pmax") > size(a, "pmax") for a, b in zip(beyond[fine], beyond[fine][1:])),
    }  # fmt: skip
    return values, verdicts


def mesh2(rows: Rows) -> Found:
    read = _curves(rows, "fig11")
    fine, middle, coarse = (read[name] for name in NAMES)
    apart = {a["L"]: abs(error(a, "Fz") - error(b, "Fz")) for a, b in zip(fine, middle)}
    compared = [row for row in fine if row["L"] <= CHOSEN_L["mesh2"]]
    values = {
        "mesh2_fz_160": listed(fine, "Fz"),
        "mesh2_fz_10": listed(coarse, "Fz"),
        "mesh2_fz_40": listed(middle, "Fz"),
        "mesh2_apart": percent(max(apart[row["L"]] / size(row, "Fz") for row in compared)),
        "mesh2_apart_beyond": percent(max(apart.values())),
        **{f"mesh2_turn_{name.split('x')[0]}": reversal(read[name], "pmax") for name in NAMES},
        "mesh2_turn_fz": reversal(fine, "Fz"),
        "mesh2_area_128": listed([at(points, name, 128) for name, points in read.items()], "area"),
        "mesh2_largest_ratio": f"{fine[-1]['L_over_h']:.0f}",
        "mesh2_largest_dofs": f"{fine[-1]['dofs']:.0f}",
        "mesh2_points": f"{sum(map(len, read.values()))}",
    }
    verdicts = {
        "mesh2_turns": all(falls_then_rises(points, "Fz") or error(points[-1], "Fz") < 0 for points in read.values()),
        "mesh2_fine_smaller": all(
            max(size(a, "Fz"), size(b, "Fz")) < size(c, "Fz")
            for a, b, c in zip(fine, middle, coarse)
            if c["L"] <= CHOSEN_L["mesh2"]
        ),
        "mesh2_fine_same": all(apart[row["L"]] < 0.05 * size(row, "Fz") for row in compared),
        "mesh2_pmax_turns": all(falls_then_rises(points, "pmax") for points in read.values()),
        "mesh2_area_finer": all(
            size(a, "area") <= size(b, "area") <= size(c, "area") for a, b, c in zip(fine, middle, coarse)
        ),
        "mesh2_lacks": any(len(points) < len(LENGTHS) for points in (fine, middle)),
    }
    return values, verdicts

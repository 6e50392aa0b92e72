"""Checks section 4.1.5 of the paper, figures 12 and 14. Functions are as in findings.py."""

from __future__ import annotations

from ..finding import Found, Rows, percent
from ..rows import Row
from .cases import COMPARED_GRIDS
from .finding import between, error, listed, on, signed, size

_CURVES = {
    "an": "analytic", "an_bi": "analytic, Bi", "m1": "mesh1, PC", "m1_bi": "mesh1, Bi", "m1_fem": "mesh1, PC, fem",
    "m2": "mesh2, PC", "m2_bi": "mesh2, Bi", "m2_fem": "mesh2, PC, fem",
}  # fmt: skip
_QUANTITIES = ("Fz", "pmax", "area", "Fx")


def _curve(rows: Rows, name: str) -> list[Row]:
    """Returns the rows from coarse to fine."""
    return [on(rows["fig12"], _CURVES[name], n) for n in reversed(COMPARED_GRIDS)]


def finest_grid(rows: Rows) -> Found:
    """Compares errors on 160 x 160 with those in the paper, which may have sampled its displacements in either way."""
    found = {name: _curve(rows, name)[-1] for name in _CURVES}

    def paper_says(value: float, mesh: str, quantity: str, digit: float) -> bool:
        return between(value, error(found[mesh], quantity), error(found[f"{mesh}_fem"], quantity), digit)

    def loads_alike(quantity: str) -> bool:
        return all(
            abs(error(found[mesh], quantity) - error(found[f"{mesh}_bi"], quantity)) < 1e-3 for mesh in ("m1", "m2")
        )

    values = {f"{name}_{q}": signed(error(row, q)) for name, row in found.items() for q in _QUANTITIES}
    verdicts = {
        "loads_alike": loads_alike("Fz"),
        "fx_loads_alike": loads_alike("Fx"),
        "mesh1_about_01": paper_says(1e-3, "m1", "Fz", 1e-4),
        "mesh2_about_08": paper_says(8e-3, "m2", "Fz", 1e-3),
        "mesh1_about_003": paper_says(3e-4, "m1", "Fx", 1e-4),
        "mesh2_about_017": paper_says(1.7e-3, "m2", "Fx", 1e-4),
        "pmax_finest_smaller": all(
            size(found[f"m1{kind}"], "pmax") < size(found[f"m2{kind}"], "pmax") for kind in ("", "_bi", "_fem")
        ),
        "analytic_best": all(
            size(found["an"], "Fz") < size(row, "Fz") for name, row in found.items() if name[0] == "m"
        ),
        "area_mesh1_best": size(found["m1_bi"], "area") < size(found["an"], "area"),
        "engineering": size(found["m2"], "Fx") < 0.01,
        "area_bilinear_best": size(found["m2_bi"], "area") < size(found["an"], "area"),
    }
    return values, verdicts


def all_grids(rows: Rows) -> Found:
    curves = {name: _curve(rows, name) for name in _CURVES}

    def mesh1_smaller(quantity: str) -> bool:
        """Holds on every grid, for both ways of reading the comparison."""
        pairs = [pair for kind in ("", "_bi", "_fem") for pair in zip(curves[f"m1{kind}"], curves[f"m2{kind}"])]
        return all(size(one, quantity) < size(two, quantity) for one, two in pairs)

    apart = [abs(error(a, "pmax") - error(b, "pmax")) for a, b in zip(curves["an"], curves["m1"])]
    values = {
        "pmax_like_most": percent(max(apart)),
        "area_grids_an": listed(curves["an"], "area"),
        "area_grids_m2_bi": listed(curves["m2_bi"], "area"),
        **{f"pmax_grids_{name}": listed(curves[name], "pmax") for name in ("m1", "m2")},
    }
    verdicts = {
        "mesh1_smaller": mesh1_smaller("Fz"),
        "pmax_mesh1_smaller": mesh1_smaller("pmax"),
        "fx_mesh1_smaller": mesh1_smaller("Fx"),
        "pmax_like_analytic": max(apart) < 2e-3,
    }
    return values, verdicts

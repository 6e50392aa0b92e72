"""Checks section 3.2 of the paper with our numbers. Functions are as in findings.py."""

from __future__ import annotations

import math

import numpy as np

from ..finding import Found, Rows, at, number, percent
from ..rows import select
from .finding import NEGLIGIBLE, TARGET, first_within, origin, ratio_text


def elements_and_origin(rows: Rows) -> Found:
    linear, quadratic = select(rows["fig5"], curve="linear"), select(rows["fig5"], curve="quadratic")
    test3 = select(rows["fig6"], curve="test3")
    e512, e1024 = at(quadratic, "quadratic", 512), at(quadratic, "quadratic", 1024)
    t1024 = at(test3, "test3", 1024)
    near, far = at(rows["checks"], "test3, half_space", 8), at(rows["checks"], "test3, half_space", 1024)
    errors = [origin(row) for row in quadratic]
    first = first_within(quadratic)
    values = {
        "linear_best": percent(min(map(origin, linear))),
        "linear_last": percent(origin(linear[-1])),
        "quadratic_last": percent(origin(e1024)),
        "quadratic_512": percent(origin(e512)),
        "quadratic_512_largest": percent(e512["largest_zz"]),
        "quadratic_1024_largest": percent(e1024["largest_zz"]),
        "quadratic_first": ratio_text(first),
        "test3_1024": percent(origin(t1024)),
        "test3_1024_largest": percent(t1024["largest_zz"]),
        "test3_64_largest": percent(at(test3, "test3", 64)["largest_zz"]),
        "test3_64": percent(origin(at(test3, "test3", 64))),
        "least_ratio": number(min(row["largest_zz"] / origin(row) for row in test3)),
        "far_origin": percent(origin(near)),
        "far_largest": percent(near["largest_zz"]),
        "far_largest_xx": percent(near["largest_xx"]),
        "far_change": percent(abs(near["largest_zz"] - far["largest_zz"])),
    }
    verdicts = {
        "linear_fails": min(map(origin, linear)) > TARGET,
        "quadratic_converges": first is not None and all(b < a for a, b in zip(errors, errors[1:])),
        "stable_from_512": abs(origin(e512) - origin(e1024)) < NEGLIGIBLE,
        "table_stable_from_512": abs(e512["largest_zz"] - e1024["largest_zz"]) < NEGLIGIBLE,
        "origin_is_worst": all(row["largest_zz"] <= 1.001 * origin(row) for row in test3),
        "origin_is_worst_far": near["largest_zz"] <= 1.001 * origin(near),
    }
    return values, verdicts


def truncation(rows: Rows) -> Found:
    """The error is that of the mesh plus c h/L, where c follows from doubling L."""
    points = [row for row in select(rows["fig6"], curve="test3") if row["L"] >= 32]
    factors = [
        2 * (a["origin_zz"] - b["origin_zz"]) * a["L"] / a["h"] for a, b in zip(points, points[1:])
    ]  # fmt: skip
    last = points[-1]
    share = factors[-1] * last["h"] / last["L"]
    values = {
        "truncation_least": f"{min(map(abs, factors)):.3f}",
        "truncation_most": f"{max(map(abs, factors)):.3f}",
        "mesh_error": percent(last["origin_zz"] - share),
        "truncation_1024": percent(share),
        "truncation_80": percent(float(np.mean(factors)) / 80),
    }
    return values, {"two_parts": max(factors) - min(factors) < 0.1 * abs(np.mean(factors))}


def tests_of_mesh1(rows: Rows) -> Found:
    one, two, three = (at(rows[part], curve, 1024) for part, curve in
                       (("fig5", "quadratic"), ("fig6", "test2"), ("fig6", "test3")))  # fmt: skip
    pairs = [(at(rows["fig6"], "test2", L), at(rows["fig6"], "test3", L)) for L in (64, 128, 256, 512, 1024)]
    values = {
        "test2_1024": percent(origin(two)),
        "test2_elements": f"{two['elements']:.0f}",
        "test3_elements": f"{three['elements']:.0f}",
        "test1_elements": f"{one['elements']:.0f}",
        "test2_cpu": number(two["cpu_seconds"]),
        "test3_cpu": number(three["cpu_seconds"]),
        "test1_cpu": number(one["cpu_seconds"]),
        "test1_1024": percent(origin(one)),
    }
    verdicts = {
        "test3_finer": all(origin(b) < origin(a) and b["elements"] > a["elements"] for a, b in pairs),
        "test3_like_test1": origin(three) < 1.1 * origin(one) and three["cpu_seconds"] < one["cpu_seconds"],
    }
    return values, verdicts


def cost(rows: Rows) -> Found:
    test3 = [at(rows["fig6"], "test3", L) for L in (128, 256, 512, 1024)]
    update = [at(rows["checks"], "test3, update", L) for L in (128, 256, 512, 1024)]
    growth = test3[-1]["elements"] / test3[0]["elements"]
    steps = [b["elements"] - a["elements"] for a, b in zip(test3, test3[1:])]
    # Equal meshes of several grids are one computation. The number of operations is proportional to unknowns times
    # iterations, because the rows of the matrix have a constant length. Processor time also depends on other work of
    # the machine.
    points = {row["dofs"]: row for row in [*select(rows["fig6"], curve="test3"), *rows["fig7"]]}

    def exponent_of(costs: list[float]) -> float:
        return float(np.polyfit(np.log(list(points)), np.log(costs), 1)[0])

    exponent = exponent_of([row["dofs"] * row["iterations_z"] for row in points.values()])
    iterations = [row["iterations_z"] for row in test3]
    difference = max(abs(a["origin_zz"] - b["origin_zz"]) for a, b in zip(test3, update))
    values = {
        "elements_128": f"{test3[0]['elements']:.0f}",
        "elements_1024": f"{test3[-1]['elements']:.0f}",
        "elements_growth": number(growth),
        "elements_steps": ", ".join(f"{step:.0f}" for step in steps),
        "cpu_growth": number(test3[-1]["cpu_seconds"] / test3[0]["cpu_seconds"]),
        "iterations": ", ".join(f"{count:.0f}" for count in iterations),
        "iterations_update": ", ".join(f"{row['iterations_z']:.0f}" for row in update),
        "update_difference": f"{difference:.1e}",
        "exponent": f"{exponent:.2f}",
        "cpu_exponent": f"{exponent_of([row['cpu_seconds'] for row in points.values()]):.2f}",
        "least_dofs": f"{min(points):.0f}",
        "most_dofs": f"{max(points):.0f}",
    }
    verdicts = {
        "elements_linear": growth > 4,
        "iterations_mild": max(iterations) <= 1.3 * min(iterations),
        "within_bound": exponent <= 7 / 6,
        "update_suffices": difference < NEGLIGIBLE,
    }
    return values, verdicts


def finer_grids(rows: Rows) -> Found:
    curves = {name: select(rows["fig7"], curve=name) for name in ("20x20", "40x40", "80x80")}
    everything = [*rows["fig7"], *rows["fig6"]]
    from_80 = [row for row in rows["fig7"] if row["L"] / row["h"] >= 79]
    at_40 = [origin(row) for row in everything if math.isclose(row["L"] / row["h"], 40, rel_tol=1e-3)]
    same_L = [at(points, name, 512) for name, points in curves.items()]
    values = {
        "error_at_40": percent(max(at_40)),
        "error_at_80": percent(max(origin(row) for row in from_80)),
        "grids_512": ", ".join(percent(origin(row)) for row in same_L),
    }
    verdicts = {
        "target_from_80": all(origin(row) < TARGET for row in from_80),
        "finer_is_better": all(origin(b) < origin(a) for a, b in zip(same_L, same_L[1:])),
    }
    return values, verdicts

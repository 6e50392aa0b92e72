"""Sections 3.3 and 3.4 of the paper with our numbers. Functions as in findings.py."""

from __future__ import annotations

from collections.abc import Callable

from ..finding import Found, Rows, at, number, percent
from ..rows import Row, select
from . import tables
from .finding import NEGLIGIBLE, TARGET, first_within, origin, ratio_text, signed


def mesh2(rows: Rows) -> Found:
    fig8 = rows["fig8"]
    lengths = (128, 256, 512, 1024)
    outward = [at(fig8, "test2", L) for L in lengths]
    across = [at(fig8, "test2, across", L) for L in lengths]
    direct = [at(rows["checks"], "mesh2 test2, direct", L) for L in lengths]
    mesh1 = [at(rows["fig6"], "test2", L) for L in lengths]
    tests = {test: at(fig8, test, 512) for test in ("test1", "test2", "test3")}
    solvers = max(abs(a["origin_zz"] - b["origin_zz"]) for a, b in zip(outward, direct))
    diagonals = max(abs(a["origin_zz"] - b["origin_zz"]) for a, b in zip(outward, across))
    firsts = {name: first_within(select(fig8, curve=name)) for name in ("test1", "test2", "test3", "test2, across")}
    # Without the finite block's own error, and for the same l/h, h/hs and f.
    far = select(rows["adaptive"], parameter="f", value=1.2)
    by_hand = {mesh: next(row for row in far if row["curve"] == f"{mesh}, half_space") for mesh in ("hex", "prism")}
    values = {
        **{f"mesh2_{test}": percent(origin(row)) for test, row in tests.items()},
        **{f"mesh2_{test}_elements": f"{row['elements']:.0f}" for test, row in tests.items()},
        **{f"mesh2_{test}_cpu": number(row["cpu_seconds"]) for test, row in tests.items()},
        "mesh2_outward": signed(outward),
        "mesh2_across": signed(across),
        "mesh1_test2": signed(mesh1),
        "solvers_difference": f"{solvers:.1e}",
        "diagonals_difference": percent(diagonals),
        "mesh2_iterations": ", ".join(f"{row['iterations_z']:.0f}" for row in outward),
        "mesh2_firsts": ratio_text(*firsts.values()),
        "mesh2_outward_1024": percent(origin(outward[-1])),
        "mesh2_across_1024": percent(origin(across[-1])),
        "mesh1_test2_1024": percent(origin(mesh1[-1])),
        "mesh1_by_hand": percent(by_hand["hex"]["largest_zz"]),
        "mesh2_by_hand": percent(by_hand["prism"]["largest_zz"]),
    }
    errors = [origin(row) for row in outward]
    verdicts = {
        "mesh2_test3_smallest": origin(tests["test3"]) < min(origin(tests["test1"]), origin(tests["test2"])),
        "mesh2_test3_dearest": tests["test3"]["cpu_seconds"]
        > max(tests["test1"]["cpu_seconds"], tests["test2"]["cpu_seconds"]),
        "mesh2_test12": 0.5 < origin(tests["test1"]) / origin(tests["test2"]) < 2
        and tests["test2"]["cpu_seconds"] < tests["test1"]["cpu_seconds"],
        "mesh2_irregular": any(b > a for a, b in zip(errors, errors[1:])),
        "mesh2_worse": origin(outward[-1]) > 1.1 * origin(mesh1[-1]),
        "mesh1_better": by_hand["hex"]["largest_zz"] < by_hand["prism"]["largest_zz"],
        "mesh2_ill_conditioned": solvers > 0.1 * abs(outward[-1]["origin_zz"]),
        "mesh2_stable_from_160": abs(outward[0]["origin_zz"] - outward[-1]["origin_zz"]) < NEGLIGIBLE,
        "mesh1_stable_from_640": abs(mesh1[2]["origin_zz"] - mesh1[3]["origin_zz"]) < NEGLIGIBLE,
    }
    return values, verdicts


def table3(rows: Rows) -> Found:
    scans = rows["table3"]

    def inside(mesh: str, parameter: str, holds: Callable[[float], bool]) -> list[Row]:
        return [row for row in scans if row["curve"].startswith(f"{mesh},") and row["parameter"] == parameter
                and holds(row["value"])]  # fmt: skip

    recommended = [
        *(row for mesh in ("hex", "prism") for row in select(scans, curve=mesh) if row["value"] >= 79),
        *(row for mesh in ("hex", "prism") for row in inside(mesh, "l_over_h", lambda size: 1 <= size <= 1.25)),
        *(row for mesh in ("hex", "prism") for row in inside(mesh, "h_over_hs", lambda r: r >= 4)),
        *inside("hex", "f", lambda f: f <= 1.5),
        *inside("prism", "f", lambda f: 1.5 <= f <= 2),
    ]

    def coarse(L_over_h: int) -> dict[str, Row]:
        points = select(scans, curve=f"hex, L/h = {L_over_h}")
        return {
            "f2": select(points, parameter="f", value=2)[0],
            "f25": select(points, parameter="f", value=2.5)[0],
            "l": select(points, parameter="l_over_h", value=0.5)[0],
        }

    near, wide = coarse(80), coarse(640)
    values = {
        "ranges_table": tables.ranges_table(scans),
        "recommended_worst": percent(max(map(origin, recommended))),
        **{f"coarse_{name}_80": percent(origin(row)) for name, row in near.items()},
        **{f"coarse_{name}_640": percent(origin(row)) for name, row in wide.items()},
    }
    verdicts = {
        "table3_ranges": all(origin(row) < TARGET for row in recommended),
        "coarse_unsatisfactory": any(origin(row) > TARGET for row in near.values()),
    }
    return values, verdicts


def other_conclusions(rows: Rows) -> Found:
    checks = rows["checks"]
    three = at(rows["fig6"], "test3", 1024)
    bilinear = at(checks, "test3, bilinear", 1024)
    prism, prism_bilinear = at(rows["fig8"], "test2", 128), at(checks, "mesh2 test2, bilinear", 128)
    fem = at(checks, "test2, half_space, fem", 64)
    vertices, nodes = (at(checks, f"test2, half_space, {name}", 64) for name in ("linear", "linear_nodes"))
    values = {
        "xx_1024": percent(three["origin_xx"]),
        "xx_1024_largest": percent(three["largest_xx"]),
        "xy_1024": percent(three["scaled_xy"]),
        "bilinear_1024": percent(origin(bilinear)),
        "bilinear_xx_1024": percent(bilinear["origin_xx"]),
        "bilinear_1024_largest": percent(bilinear["largest_zz"]),
        "prism_128": percent(origin(prism)),
        "prism_bilinear_128": percent(origin(prism_bilinear)),
        "sampled_fem": percent(fem["largest_zz"]),
        "sampled_vertices": percent(vertices["largest_zz"]),
        "sampled_nodes": percent(nodes["largest_zz"]),
        "sampled_fem_xy": percent(fem["scaled_xy"]),
        "sampled_vertices_xy": percent(vertices["scaled_xy"]),
        "sampled_nodes_xy": percent(nodes["scaled_xy"]),
    }
    verdicts = {
        "other_components": max(abs(three["origin_xx"]), abs(three["origin_yy"]), three["scaled_xy"]) < TARGET,
        "bilinear_similar": max(origin(bilinear), abs(bilinear["origin_xx"]), origin(prism_bilinear)) < TARGET,
        "linear_interpolation_harmless": vertices["largest_zz"] < 2 * fem["largest_zz"],
    }
    return values, verdicts

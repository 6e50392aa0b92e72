"""Checks section 3.3 of the paper with our numbers. Functions are as in findings.py."""

from __future__ import annotations

from ..finding import Found, Rows, at, number, percent
from ..rows import select
from .finding import NEGLIGIBLE, first_within, origin, ratio_text, signed


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
    # Excludes the error of the finite block, at the same l/h, h/hs and f.
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

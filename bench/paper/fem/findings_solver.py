"""Checks the solver of section 3.2 of the paper, and its Table 1. Functions are as in findings.py."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..finding import Found, Rows, at, markdown, percent
from ..rows import Row, select
from .cases import COMPONENTS, FACTORISATIONS, PLAIN
from .finding import TARGET

LENGTHS = (128, 256, 512, 1024)
#: The paper's iterations of CG with ILU for TEST 3 at these L.
PAPER_ITERATIONS = (76, 78, 82, 85)


def _counts(points: list[Row], stop: str) -> str:
    return ", ".join(f"{row[f'{stop}_iterations']:.0f}" for row in points)


def _operations(unknowns: Sequence[float], iterations: Sequence[float]) -> list[float]:
    """The cost is proportional to these, because the rows of the matrix have a constant length."""
    return [n * count for n, count in zip(unknowns, iterations, strict=True)]


def _exponent(unknowns: Sequence[float], costs: Sequence[float]) -> float:
    return float(np.polyfit(np.log(unknowns), np.log(costs), 1)[0])


def _exponent_of(points: Sequence[Row]) -> float:
    unknowns = [row["unknowns"] for row in points]
    return _exponent(unknowns, _operations(unknowns, [row["update_iterations"] for row in points]))


def incomplete(rows: Rows) -> Found:
    curves = {
        name: [at(points, name, L) for L in LENGTHS]
        for name in FACTORISATIONS if (points := select(rows["incomplete"], curve=name))
    }  # fmt: skip
    updates = {name: [row["update_iterations"] for row in points] for name, points in curves.items()}
    every = [row for points in curves.values() for row in points]
    sizes = [row["unknowns"] for row in curves[PLAIN]]
    paper = _exponent(sizes, _operations(sizes, PAPER_ITERATIONS))
    body = [
        [name, _counts(points, "update"), f"{_exponent_of(points):.2f}",
         f"{max(row['update_residual'] for row in points):.0e}", _counts(points, "residual")]
        for name, points in curves.items()
    ]  # fmt: skip
    body.insert(0, ["**the paper**", ", ".join(map(str, PAPER_ITERATIONS)), f"{paper:.2f}", "", ""])
    head = ["factorisation and numbering", "update of 1e-6", "exponent", "true residual then", "true residual of 1e-8"]
    plain = select(rows["incomplete"], curve=PLAIN)
    operations = _exponent_of(plain)
    seconds = [row["setup_seconds"] + row["update_seconds"] for row in plain]
    changes = [abs(row["update_origin_error"] - row["residual_origin_error"]) for row in every]
    values = {
        "ilu_table": markdown(head, body),
        "ilu_paper_exponent": f"{paper:.2f}",
        "ilu_least": ", ".join(f"{min(counts):.0f}" for counts in zip(*updates.values())),
        "ilu_most": ", ".join(f"{max(counts):.0f}" for counts in zip(*updates.values())),
        "ilu_residuals": f"{min(r['update_residual'] for r in every):.0e} to {max(r['update_residual'] for r in every):.0e}",
        "ilu_change": f"{max(changes):.1e}",
        "ilu_exponent": f"{operations:.2f}",
        "ilu_cpu_exponent": f"{_exponent([r['unknowns'] for r in plain], seconds):.2f}",
        "ilu_unknowns": f"{min(row['unknowns'] for row in plain):.0f} to {max(row['unknowns'] for row in plain):.0f}",
    }
    verdicts = {
        "ilu_mild": all(max(counts) <= 1.3 * min(counts) for counts in updates.values()),
        "ilu_counts": any(
            all(abs(count / paper - 1) < 0.05 for count, paper in zip(counts, PAPER_ITERATIONS))
            for counts in updates.values()
        ),
        "ilu_within_bound": operations <= 7 / 6,
        "ilu_update_suffices": max(changes) < TARGET / 10,
    }
    return values, verdicts


def table1(rows: Rows) -> Found:
    found = {name: select(rows["table1"], curve=name)[0] for name in COMPONENTS}
    near = at(rows["checks"], "test3, half_space", 8)
    paper, contactd = (max(row[f"{kind}_difference"] for row in found.values()) for kind in ("paper", "contactd"))
    relative = max(near[f"largest_{name}"] for name in ("xx", "yy", "zz"))
    mixed = max(near["scaled_xy"], near["scaled_xz"])
    values = {
        "table1_paper": f"{paper:.0e}",
        "table1_contactd": f"{contactd:.0e}",
        "table1_least": percent(min(row["largest"] for row in found.values())),
        "table1_relative": percent(relative),
        "table1_mixed": percent(mixed),
    }
    rounding = 1e-6
    return values, {
        "table1_paper": paper < rounding,
        "table1_contactd": contactd < rounding and max(relative, mixed) < TARGET,
    }

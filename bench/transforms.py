"""Runs the same benchmarks with the transforms of ducc0 and of FFTW, alternating both programs: ./dev bench
--transforms.

./dev bench --page writes them to docs/performance.md.
"""

from __future__ import annotations

import os
import re
import statistics
from collections import defaultdict
from collections.abc import Callable
from pathlib import Path
from typing import Any

Runner = Callable[[Path, bool, dict[str, str]], list[dict[str, Any]]]

#: The rows of each program and their names in the table; {} are the groups of the pattern.
ROWS = {
    "bench_core": [(r"A_p/n:(\d+)", "product, n = {}"), (r"NORM/n:(\d+)", "normal contact, n = {}")],
    "bench_rolling": [(r"steady_cold/n:(\d+)", "steady rolling, n = {}")],
    "bench_contact": [(r"(shift_problem|transient_step)/n:(\d+)", "{}, n = {}")],
    "bench_wheel_rail": [(r"full/y:(\d+)", "wheel on rail, y = {} mm")],
}
ROUNDS = 3


def named(program: str, row: str) -> str | None:
    """Returns the row's name in the table, or None for a row that the table omits."""
    for pattern, name in ROWS[program]:
        if match := re.fullmatch(rf"{program}\.{pattern}", row):
            return name.format(*(group.replace("_", " ") for group in match.groups()))
    return None


def measure(of_ducc0: Path, of_fftw: Path, quick: bool, run: Runner) -> dict[str, tuple[float, float]]:
    """Runs the programs of both folders alternately. Returns the median of the seconds with ducc0, and that of the
    ratios, for each row of the table."""
    taken: dict[str, dict[str, list[float]]] = defaultdict(lambda: defaultdict(list))
    for program in ROWS:
        for _ in range(ROUNDS):
            for name, folder in (("ducc0", of_ducc0), ("fftw", of_fftw)):
                for row in run(folder / program, quick, dict(os.environ)):
                    if not row.get("error_occurred") and (label := named(program, row["name"])):
                        taken[label][name].append(row["seconds"])
    return {
        label: (
            statistics.median(of["ducc0"]),
            statistics.median(b / a for a, b in zip(of["ducc0"], of["fftw"], strict=True)),
        )
        for label, of in taken.items()
    }


def report(of_ducc0: Path, of_fftw: Path, quick: bool, run: Runner) -> None:
    """Prints the table."""
    print("| row | ducc0, us | FFTW / ducc0 |\n|---|---|---|")
    for label, (seconds, ratio) in measure(of_ducc0, of_fftw, quick, run).items():
        print(f"| {label} | {seconds * 1e6:.3g} | {ratio:.2f} |")

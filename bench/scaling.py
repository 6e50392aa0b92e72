"""Measures the cost of each model against the number of elements and writes docs/performance.csv, with commit and
machine, and its picture, docs/performance.png."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import pages

DOCS = Path(__file__).resolve().parent.parent / "docs"
#: Rows of bench_scaling and their names in the picture: a scalar product and simplified models, then solvers.
SIMPLE = {
    "product": "one product $A_{zz}\\,p$",
    "simplified/hertz": "hertz",
    "simplified/fastsim": "fastsim",
    "simplified/fastrip": "fastrip",
    "simplified/polach": "polach",
    "simplified/kpec": "fastsim, pressures by kpec",
}
SOLVERS = {
    "normal": "normal contact",
    "shift": "shift",
    "steady_rolling": "steady rolling",
    "dissimilar": "dissimilar bodies, rolling",
    "layered": "layered bodies, rolling",
    "conformal": "conformal, a wheel on a rail",
}
#: Longest duration of a row (s), including its preparation. After a longer row, the model gets no more elements.
LONGEST = 60
Row = dict[str, Any]


def rows_of(program: Path, run: Callable[..., list[Row]]) -> list[Row]:
    """Returns the rows of all models, from few elements to many, and prints each as it ends."""
    listed = subprocess.run([program, "--benchmark_list_tests"], check=True, capture_output=True, text=True).stdout.split()
    rows: list[Row] = []
    for model in SIMPLE | SOLVERS:
        for name in (name for name in listed if name.startswith(f"{model}/n:")):
            start = time.monotonic()
            try:
                rows += run(program, only=f"^{name}$", timeout=LONGEST)
            except subprocess.TimeoutExpired:
                print(f"  {name}: stopped after {LONGEST} s", file=sys.stderr, flush=True)
                break
            print(f"  {name}: {time.monotonic() - start:.1f} s", file=sys.stderr, flush=True)
    return rows


def table_of(rows: list[Row]) -> list[Row]:
    """Returns one line per row: model, elements, processor time of a solve and of an element (us), products A p."""
    lines = []
    for row in rows:
        if row.get("error_occurred"):
            raise SystemExit(f"{row['name']}: {row['error_message']}")
        elements = int(row["elements"])
        microseconds = row["cpu_time"] * {"ns": 1e-3, "us": 1, "ms": 1e3}[row["time_unit"]]
        lines.append({
            "model": row["name"].split(".")[-1].split("/n:")[0],
            "elements": elements,
            "us": f"{microseconds:.4g}",
            "us_per_element": f"{microseconds / elements:.4g}",
            "products": f"{row['A_p']:.4g}" if "A_p" in row else "",
            "iterations": int(row["solver_iterations"]) if "solver_iterations" in row else "",
        })
    return lines


def draw(lines: list[Row], picture: Path) -> None:
    figure, panels = plt.subplots(1, 3, figsize=(14, 4.8), layout="constrained")
    titles = ["Cost per element: simplified models", "Cost per element: solvers", "Cost of solvers in products"]
    for axes, models, title in zip(panels, (SIMPLE, SOLVERS, SOLVERS), titles, strict=True):
        column = "products" if axes is panels[2] else "us_per_element"
        for model, words in models.items():
            points = [line for line in lines if line["model"] == model and line[column] != ""]
            if points:
                values = [float(line[column]) for line in points]
                axes.plot([line["elements"] for line in points], values, "o-", ms=3.5, label=words)
        axes.set(xscale="log", yscale="log", xlabel="elements", title=title, ylabel="processor time per element (µs)")
        axes.grid(alpha=0.3, which="both")
        axes.legend(fontsize=8)
    panels[2].set(ylabel="cost / one product $A_{zz}\\,p$ on the same grid")
    figure.savefig(picture, dpi=110)


def write(rows: list[Row], docs: Path = DOCS, now: dict[str, str] | None = None) -> None:
    """Writes both files. `now` is the provenance of the rows, by default that of the present commit."""
    lines = table_of(rows)
    now = now or pages.provenance()
    pages.write(docs / "performance.csv", [{**line, **now} for line in lines])
    draw(lines, docs / "performance.png")
    print(f"written: {docs / 'performance.csv'}, {docs / 'performance.png'}")


def plot(program: Path, run: Callable[..., list[Row]]) -> int:
    """Runs all rows and writes the table and the picture. An interrupt ends it and leaves both unchanged."""
    for number in (signal.SIGINT, signal.SIGTERM):  # in the background of a script SIGINT would be ignored
        signal.signal(number, signal.default_int_handler)
    print("cost against the number of elements: about three minutes and up to 2 GB of memory", file=sys.stderr, flush=True)
    try:
        write(rows_of(program, run))
        pages.write_pages()
    except KeyboardInterrupt:
        print("interrupted; docs/performance.csv and docs/performance.png are unchanged", file=sys.stderr)
        return 130
    return 0

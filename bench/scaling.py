"""Measures the cost for each grid size and writes docs/performance.csv and its picture, docs/performance.png."""

from __future__ import annotations

import csv
import re
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

DOCS = Path(__file__).resolve().parent.parent / "docs"
#: Row of bench_scaling, its name in the picture, its colour, and its targets in products A p (n and limit).
CURVES = [
    ("A_p", "one product $A_{zz}\\,p$", "#222222", []),
    ("NORM", "NORM, cold", "#1f6fb4", [(40, 25), (160, 25), (320, 25)]),
    ("TangCG", "TangCG, cold", "#d1701f", [(40, 90), (160, 160)]),
    ("steady_rolling", "steady rolling, cold", "#2b8a4b", [(25, 200), (50, 200)]),
]
SIZES = [16, 25, 40, 64, 100, 160, 256, 400, 640]


def table_of(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Returns one line per row: the solver, n, processor nanoseconds per element, products A p, iterations."""
    product = {}
    lines = []
    for row in rows:
        if row.get("error_occurred"):
            raise SystemExit(f"{row['name']}: {row['error_message']}")
        solver, n = re.fullmatch(r"bench_scaling\.(\w+)/n:(\d+)", row["name"]).groups()
        n = int(n)
        if solver == "A_p":
            product[n] = row["cpu_time"] * {"ns": 1, "us": 1e3, "ms": 1e6}[row["time_unit"]] / n**2
        products = row.get("A_p", 1.0)
        lines.append({
            "solver": solver,
            "n": n,
            "ns_per_element": f"{products * product[n]:.4g}",
            "products": f"{products:.4g}",
            "iterations": int(row.get("solver_iterations", 0)),
        })
    return lines


def draw(lines: list[dict[str, Any]], picture: Path) -> None:
    figure, (time, units) = plt.subplots(1, 2, figsize=(10.5, 4.4), layout="constrained")
    for solver, words, colour, limits in CURVES:
        points = [line for line in lines if line["solver"] == solver]
        sizes = [line["n"] for line in points]
        time.plot(sizes, [float(line["ns_per_element"]) / 1e3 for line in points], "o-", color=colour, ms=3.5, label=words)
        if solver == "A_p":
            continue
        units.plot(sizes, [float(line["products"]) for line in points], "o-", color=colour, ms=3.5, label=words)
        units.plot(*zip(*limits), "v", color=colour, ms=8, mfc="none")
    units.plot([], [], "v", color="#666666", ms=8, mfc="none", label="limit of the aims")
    time.set(yscale="log", ylabel="processor time per element (µs)", title="Cost per element")
    units.set(yscale="log", ylabel="cost / one product $A_{zz}\\,p$ on the same grid", title="Cost in products")
    time.set_ylim(5e-3, 30)
    units.set_ylim(10, 700)
    time.set_yticks([0.01, 0.1, 1, 10], ["0.01", "0.1", "1", "10"])
    units.set_yticks([10, 20, 50, 100, 200, 500], ["10", "20", "50", "100", "200", "500"])
    for axes in (time, units):
        axes.set(xscale="log", xlabel="$n$, elements along each side of the grid")
        axes.set_xticks(SIZES, [str(n) for n in SIZES])
        axes.minorticks_off()
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8, loc="upper left", ncols=2)
    figure.savefig(picture, dpi=130)


def write(rows: list[dict[str, Any]]) -> None:
    lines = table_of(rows)
    with open(DOCS / "performance.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, list(lines[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(lines)
    draw(lines, DOCS / "performance.png")
    print(f"written: {DOCS / 'performance.csv'}, {DOCS / 'performance.png'}")

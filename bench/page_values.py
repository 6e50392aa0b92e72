"""Measures all values of docs/benchmarks.csv in one run on one commit, and writes the pages: ./dev bench --page."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from fnmatch import fnmatchcase
from functools import partial
from pathlib import Path
from typing import Any

import in_process
import many_solves
import many_steps
import pages
import scaling
import service
import session_steps
import transforms
import vehicle_steps
from contactd import Client, LocalDaemon

Row = dict[str, Any]
#: A value and its key, the row and the quantity.
Value = tuple[str, float]
Ratio = Callable[[Row, dict[str, Row]], "tuple[float, str] | None"]


def of_benchmarks(rows: list[Row], ratio: Ratio) -> Iterator[Value]:
    """Yields the counters of each row of ./dev bench, its times, its ratio to its baseline, and ratios of its times."""
    by_name = {row["name"]: row for row in rows if not row.get("error_occurred")}
    for name, row in by_name.items():
        found = {quantity: value for quantity, value in row.items() if isinstance(value, (int, float))}
        found.setdefault("us", 1e6 * row["seconds"])
        found["ms"] = found["us"] / 1e3
        if over := ratio(row, by_name):
            found["over"] = over[0]
        if "p99_us" in found:
            found |= {"p99_ms": found["p99_us"] / 1e3, "p99_over_median": found["p99_us"] / found["us"]}
        full = by_name.get(name.replace("_to_1e4", ""))
        if full and full is not row:
            found["over_full"] = found["us"] / full["us"]
        for quantity, value in found.items():
            yield f"{name} {quantity}", value


def of_latency(rows: list[Row]) -> Iterator[Value]:
    for row in rows:
        kind = "shift" if row["friction"] else "normal"
        name = f"service.{row['endpoint']}/{row['n']}/{kind}{'/spinning' if row['spin'] else ''}"
        for quantity, part in (("solve", "solve"), ("added", "overhead"), ("echo", "echo"), ("over_echo", "over_echo")):
            yield f"{name} {quantity}", row[part]["median"]


def of_throughput(name: str, rate: Row) -> Iterator[Value]:
    quantities = {"one": "one", "two": "two", "ratio": "median_ratio", "processors": "processors_used_by_two"}
    for quantity, key in quantities.items():
        yield f"throughput.{name}/{rate['n']} {quantity}", rate[key]


def of_many(steps: Row, solves: list[Row]) -> Iterator[Value]:
    for row in steps["rows"]:
        for quantity in ("together", "one_by_one", "solves", "beyond"):
            yield f"many_steps.{row['workers']} {quantity}", 1e3 * row[quantity]
    yield "many_steps.2 over_one_worker", steps["two_over_one"]
    for row in solves:
        for quantity in ("many", "single"):
            yield f"many_solves.{row['workers']} {quantity}", 1e6 * row[quantity]


def of_calls(rows: list[Row]) -> Iterator[Value]:
    for row in rows:
        for quantity, factor in (("here", 1e3), ("daemon", 1e3), ("ratio", 1)):
            yield f"in_process.{row['name']} {quantity}", factor * row[quantity]


def of_sessions(endpoint: str, rows: dict[str, dict[str, float]]) -> Iterator[Value]:
    for method, row in rows.items():
        for quantity, value in row.items():
            factor = 1 if quantity == "iterations" else 1e6
            yield f"session_steps.{endpoint}/{method.removeprefix('... ')} {quantity}", factor * value


def by_daemons(programs: Path, quick: bool) -> Iterator[Value]:
    """Yields the values that Python programs measure with daemons of their own."""
    rounds, daemon = (50 if quick else 500), programs / "contactd"
    for spin in service.SPINS:
        yield from of_latency(service.latency(programs, 4 * rounds, spin))
    for name, kind, n in (("steps", service.Steps, 25), ("shift", service.Solves, 25), ("shift", service.Solves, 160)):
        yield from of_throughput(name, service.throughput(programs, kind, n, 0.5 if quick else 2.0))
    yield from of_many(many_steps.measure(daemon, rounds), many_solves.measure(daemon, rounds // 5))
    yield from of_calls(in_process.measure(programs, rounds, 0.25))
    for name, given in (("ipc", {}), ("tcp", {"endpoint": "tcp://127.0.0.1:*"})):
        with LocalDaemon(daemon, config={"log": {"level": "warn"}, **given}) as running:
            yield from of_sessions(name, session_steps.run(running.endpoint, 25, 300, 0.05, 0.1))
    config = {"workers": 2, "log": {"level": "error"}}
    with LocalDaemon(daemon, config=config) as running, Client(running.endpoint) as client:
        for model in ("fastsim", "full"):
            seconds = vehicle_steps.by_python(client, model, rounds)
            for quantity, part in (("ms", 0.5), ("p99_ms", 0.99)):
                yield f"vehicle_steps.{model} {quantity}", 1e3 * session_steps.quantile(seconds, part)


def of_transforms(found: dict[str, tuple[float, float]]) -> Iterator[Value]:
    for label, (seconds, ratio) in found.items():
        yield f"transforms.{label} us", 1e6 * seconds
        yield f"transforms.{label} fftw_over_ducc0", ratio


def rows_of_file(measured: dict[str, float], wanted: list[str], now: dict[str, str]) -> pages.Rows:
    """Returns the rows of docs/benchmarks.csv: the wanted keys, in their order. Exits if one was not measured."""
    if missing := [key for key in wanted if not any(fnmatchcase(name, key) for name in measured)]:
        raise SystemExit("These values of the templates were not measured: " + "; ".join(missing))
    keys = dict.fromkeys(name for key in wanted for name in measured if fnmatchcase(name, key))
    parts = {key: key.rpartition(" ") for key in keys}
    return [
        {"row": row, "quantity": quantity, "value": pages.digits(measured[key]), **now}
        for key, (row, _, quantity) in parts.items()
    ]


def write(
    programs: Path, quick: bool, rows: list[Row], run: Callable[..., list[Row]], ratio: Ratio, root: Path = pages.ROOT
) -> None:
    """Measures what ./dev bench does not, with its rows given, and writes all files and pages at the end."""
    now = pages.provenance()
    measured = dict(of_benchmarks(rows, ratio))
    of_fftw = programs.parents[1] / "production-fftw" / "bin"
    measured |= dict(of_transforms(transforms.measure(programs, of_fftw, quick, run)))
    measured |= dict(by_daemons(programs, quick))
    found = rows_of_file(measured, pages.needed(root), now)
    curves = scaling.rows_of(programs / "bench_scaling", partial(run, quick=True, environment=dict(os.environ)))
    pages.write(root / "docs" / "benchmarks.csv", found)
    scaling.write(curves, root / "docs", now)
    pages.write_pages(root)
    print(f"written: {root / 'docs' / 'benchmarks.csv'}")

"""Runs every benchmark and prints one table: times, and ratios to a baseline measured in the same run.

Times depend on the machine and its load. Compare the ratios.

    ./dev bench [--quick] [--only PROGRAM ...] [--json FILE]
    ./dev bench --service overhead of the daemon for a solve and for the steps of many sessions, and solves per second
                          with one worker and two
    ./dev bench --plot    cost of each model against the number of elements: docs/performance.csv and
                          docs/performance.png (three minutes, 2 GB of memory)
    ./dev bench --page    all of these: docs/benchmarks.csv, docs/performance.csv, and the pages that show them
                          (bench/page_values.py)
    ./dev bench --transforms [--quick]  times with FFTW's transforms over those with ducc0's, alternating both programs
"""

from __future__ import annotations

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path
from typing import Any

import page_values
import pages
import scaling
import service
import transforms
from contactd import LocalDaemon

PROGRAMS = [
    "bench_core",
    "bench_rolling",
    "bench_contact",
    "bench_strips",
    "bench_simplified",
    "bench_friction",
    "bench_wheel_rail",
    "bench_conformal",
    "bench_vehicle",
    "bench_embedding",
    "bench_cntc",
    "bench_fem",
    "bench_request",
]
#: Rows whose name matches the first pattern are divided by the row with the second name (groups filled in).
BASELINES = [
    (r"(bench_(?:core|rolling|contact))\.\w+/n:(\d+).*", "{0}.A_p/n:{1}", "A*p"),
    (r"bench_simplified\.\w+/n:(\d+)", "bench_core.A_p/n:{0}", "A*p"),
    (r"bench_wheel_rail\.(?!full).*/y:(\d+)", "bench_wheel_rail.full/y:{0}", "steps of full"),
    (r"bench_embedding\.\w+/fastsim:(\d)", "bench_embedding.solver/fastsim:{0}", "solvers"),
    (r"bench_fem\.build/([\w-]+)/\w+.*", "bench_fem.build/{0}/total", "of the build"),
    (r"bench_fem\.table/\w+.*", "bench_fem.table/paper", "the paper's way"),
    (r"bench_request\.\w+.*", "bench_request.zeromq_echo", "ZeroMQ echos"),
]
#: Ratios that rows measure themselves, alternating with the named baseline.
OF_THE_ROW = {
    "over_plane": "plane contact there",
    "over_product": "A*p of a patch",
    "over_solve": "plain solves of its patches",
    "ratio": "half-spaces",
    "of_elastic": "elastic bodies",
}
TO_SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


def run(
    program: Path, quick: bool, environment: dict[str, str], only: str = "", timeout: float | None = None
) -> list[dict[str, Any]]:
    """Returns the rows of one Google Benchmark program, without the suffixes that it adds to names: all rows, or those
    whose name matches `only`. Raises subprocess.TimeoutExpired after `timeout` seconds."""
    if not only:
        print(f"running {program.name} ...", file=sys.stderr, flush=True)
    with tempfile.NamedTemporaryFile(suffix=".json") as result:
        command = [str(program), f"--benchmark_out={result.name}", "--benchmark_out_format=json"]
        command.append(f"--benchmark_min_time={'0.05s' if quick else '0.5s'}")
        command += [f"--benchmark_filter={only}"] if only else []
        subprocess.run(
            command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment, timeout=timeout
        )
        rows = json.load(open(result.name))["benchmarks"]
    for row in rows:
        row["name"] = f"{program.name}." + re.sub(r"/(real_time|manual_time|iterations:\d+)", "", row["name"])
        row["seconds"] = row["real_time"] * TO_SECONDS[row["time_unit"]]
    return rows


def ratio(row: dict[str, Any], by_name: dict[str, dict[str, Any]]) -> tuple[float, str] | None:
    """Returns the row's time over that of its baseline, and a description of the baseline."""
    if "over_plain" in row:  # measured by the row itself, alternating with the baseline
        return row["over_plain"], "steps by contactd.h" if row["name"].startswith("bench_cntc") else "solves without"
    for counter, words in OF_THE_ROW.items():
        if counter in row:
            return row[counter], words
    for pattern, baseline, words in BASELINES:
        if match := re.fullmatch(pattern, row["name"]):
            if "A_p" in row:  # measured by the row itself, in the same run
                return row["A_p"], words
            base = by_name.get(baseline.format(*match.groups()))
            return (row["seconds"] / base["seconds"], words) if base else None
    return None


def time_text(seconds: float) -> str:
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:8.2f} {unit}"
    return f"{seconds * 1e9:8.2f} ns"


def print_table(rows: list[dict[str, Any]]) -> None:
    by_name = {row["name"]: row for row in rows}
    width = max(len(row["name"]) for row in rows)
    print(f"{'benchmark':{width}}  {'time':>11}  {'ratio':>9}  to")
    print("-" * (width + 40))
    for row in rows:
        if row.get("error_occurred"):
            print(f"{row['name']:{width}}  {row['error_message']}")
            continue
        line = f"{row['name']:{width}}  {time_text(row['seconds']):>11}"
        if found := ratio(row, by_name):
            line += f"  {found[0]:9.3g}  {found[1]}"
        if "peak_MiB" in row:
            line += f" ({row['dofs']:.0f} dofs, errors {row['error_zz']:.1e} {row['error_xx']:.1e}, {row['peak_MiB']:.0f} MiB)"
        if "products_a_point" in row:
            line += f" ({row['products_a_point']:.0f} products a point)"
        if "solver_iterations" in row:
            line += f" ({row['solver_iterations']:.0f} iterations)"
        print(line)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=Path, required=True, help="folder with the programs")
    parser.add_argument("--quick", action="store_true", help="shorter runs, more noise")
    parser.add_argument("--only", nargs="+", choices=PROGRAMS, metavar="PROGRAM", help=f"from {', '.join(PROGRAMS)}")
    parser.add_argument("--service", action="store_true", help="latency and throughput of the daemon instead")
    parser.add_argument("--plot", action="store_true", help="cost against the number of elements, for docs/performance.md")
    parser.add_argument("--transforms", action="store_true", help="compare the transforms of FFTW and ducc0")
    parser.add_argument("--page", action="store_true", help="measure all values of the pages, and write the pages")
    parser.add_argument("--json", type=Path, help="also write the rows to this file")
    arguments = parser.parse_args()

    if arguments.page and (arguments.only or pages.provenance()["commit"].endswith("-dirty")):
        parser.error("--page measures all rows of one commit: commit your changes first, and omit --only")
    if arguments.service:
        service.report(arguments.bin, arguments.quick, arguments.json)
        return 0
    environment = dict(os.environ)
    if arguments.plot:
        return scaling.plot(arguments.bin / "bench_scaling", partial(run, quick=True, environment=environment))
    if arguments.transforms:
        transforms.report(arguments.bin, arguments.bin.parents[1] / "production-fftw" / "bin", arguments.quick, run)
        return 0
    rows = []
    for name in arguments.only or PROGRAMS:
        if name in ("bench_request", "bench_vehicle"):
            with LocalDaemon(arguments.bin / "contactd", config={"log": {"level": "warn"}}) as daemon:
                environment["CONTACTD_ENDPOINT"] = daemon.endpoint
                rows += run(arguments.bin / name, arguments.quick, environment)
        else:
            rows += run(arguments.bin / name, arguments.quick, environment)
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=1))
    print_table(rows)
    if arguments.page:
        page_values.write(arguments.bin, arguments.quick, rows, run, ratio)
    return any(row.get("error_occurred") for row in rows)


if __name__ == "__main__":
    sys.exit(main())

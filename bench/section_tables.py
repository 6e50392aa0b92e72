"""Measures the cost of tables of a section: a head of 60E1 with 80 strips of 0.5 mm, three directions, 200 offsets.

It measures builds to 1e-2, 1e-3 and 1e-4 with one process and with two, the start of a builder that meshes nothing,
and the same table from the daemon's memory and from its store. All variants alternate. The result is the minimum over
the rounds, because a busy machine disturbs most of them.

    python3 bench/section_tables.py [--rounds 3] [--accuracy 1e-2 1e-3]    (PATH or CONTACTD_BIN names contactd)
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import tempfile
import time
from collections import defaultdict
from pathlib import Path
from typing import Any

from contactd import FemIcs, Grid, LocalDaemon, Material

STRIPS, OFFSETS, WIDTH = 80, 200, 0.5  # mm
SECTION = {"rail_60e1": {"from": 2}}
STEEL = Material(G=82000, nu=0.28)
BLOCK = {"source": "fem", "order": 1, "f": 2, "L_over_h": 20, "solver": "direct"}
Row = tuple[float, float]  # wall and processor time (s)


def spec(ics: dict[str, Any], nx: int, ny: int) -> dict[str, Any]:
    grid = {"nx": nx, "ny": ny, "dx": WIDTH, "dy": WIDTH}
    return {"material": {"G": STEEL.G, "nu": STEEL.nu}, "grid": grid, "ics": ics}


def build(program: Path, request: dict[str, Any], processes: int) -> Row:
    """Measures one run of the builder, including the start of the program."""
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    environment |= {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    launcher = ["mpirun", "--oversubscribe", "-np", str(processes)] if processes > 1 else []
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "spec.json")
        file.write_text(json.dumps(request))
        before, start = processor_seconds(), time.perf_counter()
        command = [*launcher, str(program), str(file), "--output", f"{folder}/table.h5"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=environment)
        return time.perf_counter() - start, processor_seconds() - before


def processor_seconds() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def answered(binaries: Path, accuracy: float, rounds: int) -> dict[str, Row]:
    """Returns the minimum time of ic.get, from request to array in Python, without the daemon's processor time."""
    grid = Grid.centred(OFFSETS, STRIPS, OFFSETS * WIDTH, STRIPS * WIDTH)
    ics = FemIcs(body="longitudinally_uniform", section=SECTION, accuracy=accuracy)
    least: dict[str, Row] = {}
    with tempfile.TemporaryDirectory() as store:
        for _ in range(2 * rounds):  # faster than builds
            with LocalDaemon(binaries / "contactd", config={"store": {"folder": store}}) as daemon, daemon.client() as client:
                client.health()
                for _ in range(3):
                    start = time.perf_counter()
                    table = client.get_ic(STEEL, grid, ics)
                    seconds = time.perf_counter() - start
                    least[table.origin] = min(least.get(table.origin, (seconds, 0.0)), (seconds, 0.0))
    return least


def measure(binaries: Path, accuracies: list[float], rounds: int) -> dict[str, Row]:
    rows: defaultdict[str, list[Row]] = defaultdict(list)
    for _ in range(rounds):
        rows["start"].append(build(binaries / "contactd-ic", spec(BLOCK, 5, 4), 1))
        for accuracy in accuracies:
            uniform = {"source": "fem", "body": "longitudinally_uniform", "section": SECTION, "accuracy": accuracy}
            for processes in (1, 2):
                row = build(binaries / "contactd-ic", spec(uniform, OFFSETS, STRIPS), processes)
                rows[f"{accuracy:g}, {processes} process{'es' * (processes > 1)}"].append(row)
    least = {name: (min(wall for wall, _ in found), min(used for _, used in found)) for name, found in rows.items()}
    return least | {f"from {origin}": row for origin, row in answered(binaries, accuracies[0], rounds).items()}


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--accuracy", type=float, nargs="+", default=[1e-2, 1e-3, 1e-4])
    arguments = parser.parse_args()
    binaries = Path(os.environ.get("CONTACTD_BIN", "build/production/bin"))
    print("60E1 head, 80 strips x 3 directions x 200 offsets; least of", arguments.rounds)
    print(f"{'':24}{'wall s':>10}{'processor s':>14}")
    for name, (wall, used) in measure(binaries, arguments.accuracy, arguments.rounds).items():
        print(f"{name:24}{wall:10.3f}" + (f"{used:14.3f}" if used > 0 else ""))


if __name__ == "__main__":
    main()

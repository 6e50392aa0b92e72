"""Compares the cost of a call of contactd.local() in process and through its private daemon. Both alternate, with the
same client and the same problems, with forces only and with all arrays. Each ratio is that of the two calls of one
round.

    python3 bench/in_process.py [--rounds 500]     (CONTACTD_BIN names the programs, contactd_local lies beside them; part of
                                                    ./dev bench --service)
"""

from __future__ import annotations

import argparse
import os
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import contactd
from contactd import Client, ContactProblem, Friction, Grid, Material, Paraboloid, Rolling
from session_steps import quantile

FULL = ContactProblem(
    grid=Grid.centred(25, 25, 14, 14),
    upper=Material(G=82000, nu=0.28),
    gap=Paraboloid(Rx=460, Ry=300),
    Fn=50e3,
    friction=Friction(mu=0.3, rolling=Rolling(xi=1e-3)),
)
PROBLEMS = {
    "hertz": FULL.replace(model="hertz", friction=None),
    "fastsim": FULL.replace(model="fastsim"),
    "full": FULL,
}


def ways(client: Client) -> dict[str, Callable[[int], Any]]:
    """Returns the measured calls of a client by name. Each takes the number of the round."""
    found: dict[str, Callable[[int], Any]] = {}
    for name, problem in PROBLEMS.items():
        found[f"{name}, forces"] = lambda _, problem=problem: client.solve(problem, fields=[]).Fn
        found[f"{name}, arrays"] = lambda _, problem=problem: client.solve(problem).Fn
    session = client.session(FULL)
    found["full, warm step"] = lambda n: session.step(xi=1e-3 * (1 + 0.05 * (n % 2))).Fx
    return found


def timed(call: Callable[[int], Any], number: int) -> tuple[Any, float]:
    start = time.perf_counter()
    answer = call(number)
    return answer, time.perf_counter() - start


def measure(programs: Path, rounds: int, part: float = 0.5) -> list[dict[str, Any]]:
    """Returns the seconds in process and through a daemon, and the median of their ratios."""
    sys.path.insert(0, str(programs.parent / "lib" / "python"))
    rows = []
    with contactd.local(in_process=True) as here, contactd.local(programs / "contactd") as there:
        theirs = ways(there)
        for name, call in ways(here).items():
            own, other = [], []
            for number in range(rounds):
                (answer, first), (expected, second) = timed(call, number), timed(theirs[name], number)
                assert answer == expected, name
                own.append(first)
                other.append(second)
            ratio = statistics.median(a / b for a, b in zip(own, other))
            rows.append({"name": name, "here": quantile(own, part), "daemon": quantile(other, part), "ratio": ratio})
    return rows


def show(rows: list[dict[str, Any]]) -> None:
    print(f"{'contactd.local(), 25 x 25 (ms)':36} {'in process':>10} {'daemon':>8} {'ratio':>6} {'less':>7}")
    for row in rows:
        less = row["daemon"] - row["here"]
        print(f"{row['name']:36} {1e3 * row['here']:10.3f} {1e3 * row['daemon']:8.3f} {row['ratio']:6.2f} {1e3 * less:7.3f}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=500, help="calls of each kind (default %(default)s)")
    parser.add_argument("--quantile", type=float, default=0.5, help="quantile of the times; use 0.1 on a busy machine (default 0.5)")
    options = parser.parse_args()
    show(measure(Path(os.environ.get("CONTACTD_BIN", "build/production/bin")).absolute(), options.rounds, options.quantile))


if __name__ == "__main__":
    main()

"""Compares the cost of a problem in one contact.solve_many with that of the same problem in a separate contact.solve.

It runs 500 solves by the simplified model `hertz`, without arrays, over ipc, including encoding and reading of the
JSON. One worker and two alternate. The program uses ZeroMQ directly, to exclude the cost of client libraries.

    python3 bench/many_solves.py [--rounds 50]     (PATH or CONTACTD_BIN names contactd; part of ./dev bench --service)
"""

from __future__ import annotations

import argparse
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import zmq

from contactd import LocalDaemon
from daemon_program import daemon_program
from session_steps import Asker, problem, quantile

PROBLEMS = 500


def problems() -> list[dict[str, Any]]:
    """Returns problems with different loads, and without spin, which the closed form does not support."""
    friction = {"mu": 0.3, "rolling": {"xi": 0.002, "eta": 0.001}}
    common = {**problem(25), "friction": friction, "model": "hertz", "fields": []}
    return [{**common, "Fn": 50e3 * (1 + 1e-4 * i)} for i in range(PROBLEMS)]


class Trial:
    """Starts a daemon with this number of workers."""

    def __init__(self, stack: ExitStack, program: Path | str, workers: int) -> None:
        daemon = stack.enter_context(LocalDaemon(program, config={"workers": workers, "log": {"level": "warn"}}))
        context = zmq.Context[zmq.Socket[bytes]]()
        stack.callback(context.destroy, linger=0)
        self.asker = Asker(context, daemon.endpoint)
        self.problems = problems()
        self.seconds: dict[str, list[float]] = {"many": [], "single": []}

    def round(self) -> None:
        result, seconds = self.asker.ask("contact.solve_many", {"problems": self.problems})
        assert all(one["status"]["code"] == 0 for one in result["solutions"]), result["solutions"][0]
        alone, single = self.asker.ask("contact.solve", self.problems[0])
        assert alone["forces"] == result["solutions"][0]["result"]["forces"]
        self.seconds["many"].append(seconds / PROBLEMS)
        self.seconds["single"].append(single)


def measure(program: Path | str, rounds: int, part: float = 0.5) -> list[dict[str, Any]]:
    """Returns quantiles of the seconds for one problem, by workers."""
    with ExitStack() as stack:
        trials = {workers: Trial(stack, program, workers) for workers in (1, 2)}
        for _ in range(rounds):
            for trial in trials.values():
                trial.round()
    return [
        {"workers": workers, **{name: quantile(values, part) for name, values in trial.seconds.items()}}
        for workers, trial in trials.items()
    ]


def show(rows: list[dict[str, Any]]) -> None:
    print(f"{f'{PROBLEMS} solves by hertz (us each)':36} {'in one':>8} {'alone':>8} {'ratio':>6}")
    for row in rows:
        name = f"{row['workers']} worker{'s' if row['workers'] > 1 else ''}"
        print(f"{name:36} {1e6 * row['many']:8.1f} {1e6 * row['single']:8.1f} {row['many'] / row['single']:6.2f}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=50, help="messages of each daemon (default %(default)s)")
    parser.add_argument("--quantile", type=float, default=0.5, help="quantile of the times; use 0.1 on a busy machine (default 0.5)")
    options = parser.parse_args()
    program = daemon_program()
    show(measure(program, options.rounds, options.quantile))


if __name__ == "__main__":
    main()

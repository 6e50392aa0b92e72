"""Measures the cost of the contacts of a vehicle: eight warm steps of steady rolling in one session.step_many, the
same steps in eight consecutive session.step, and the solves alone, as the daemon reports them for both.

One worker and two are measured over ipc. All variants alternate, with separate sessions and the same motions. The
program uses ZeroMQ directly, to exclude the cost of client libraries.

    python3 bench/many_steps.py [--rounds 300]     (PATH or CONTACTD_BIN names contactd; part of ./dev bench --service)
"""

from __future__ import annotations

import argparse
import statistics
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import zmq

from contactd import LocalDaemon
from daemon_program import daemon_program
from session_steps import Asker, motion, problem, quantile, solver_seconds

CONTACTS = 8
CHANGE = 0.05  # relative change of the creepages from step to step


class Vehicle:
    """Solves eight contacts with different loads on 25 x 25 elements, each in its own session."""

    def __init__(self, asker: Asker) -> None:
        self.asker = asker
        self.sessions = [asker.ask("session.open", problem(25))[0]["session"] for _ in range(CONTACTS)]
        self.step = 0

    def inputs(self) -> list[dict[str, Any]]:
        """Returns the messages of the next step."""
        self.step += 1
        friction = {"rolling": motion(self.step, CHANGE)}
        return [
            {"session": session, "step": self.step, "Fn": 50e3 * (1 + 0.02 * i), "friction": friction}
            for i, session in enumerate(self.sessions)
        ]

    def together(self) -> tuple[list[dict[str, Any]], float]:
        result, seconds = self.asker.ask("session.step_many", {"steps": self.inputs()})
        assert all(one["status"]["code"] == 0 for one in result["steps"]), result
        return [one["result"] for one in result["steps"]], seconds

    def one_by_one(self) -> tuple[list[dict[str, Any]], float]:
        answers = [self.asker.ask("session.step", step) for step in self.inputs()]
        return [result for result, _ in answers], sum(seconds for _, seconds in answers)


class Trial:
    """Starts a daemon with this number of workers, and a vehicle for each variant."""

    def __init__(self, stack: ExitStack, program: Path | str, workers: int) -> None:
        config = {"workers": workers, "log": {"level": "warn"}}
        daemon = stack.enter_context(LocalDaemon(program, config=config))
        context = zmq.Context[zmq.Socket[bytes]]()
        stack.callback(context.destroy, linger=0)
        asker = Asker(context, daemon.endpoint)
        self.one_message, self.single = Vehicle(asker), Vehicle(asker)
        self.trips: dict[str, list[float]] = {"together": [], "one_by_one": [], "solves": [], "beyond": []}

    def round(self) -> None:
        answers, together = self.one_message.together()
        expected, one_by_one = self.single.one_by_one()
        assert [one["forces"] for one in answers] == [one["forces"] for one in expected]
        solves = sum(map(solver_seconds, answers))
        row = {"together": together, "one_by_one": one_by_one, "solves": solves, "beyond": (together - solves) / CONTACTS}
        for name, value in row.items():
            self.trips[name].append(value)


def measure(program: Path | str, rounds: int, part: float = 0.5) -> dict[str, Any]:
    """Returns quantiles of seconds by workers, and medians of the ratios of one round."""
    with ExitStack() as stack:
        trials = {workers: Trial(stack, program, workers) for workers in (1, 2)}
        for _ in range(rounds):
            for trial in trials.values():
                trial.round()
    together = {workers: trial.trips["together"] for workers, trial in trials.items()}
    rows = [
        {
            "workers": workers,
            **{name: quantile(values, part) for name, values in trial.trips.items()},
            "over_one_by_one": statistics.median(a / b for a, b in zip(together[workers], trial.trips["one_by_one"])),
        }
        for workers, trial in trials.items()
    ]
    return {"rows": rows, "two_over_one": statistics.median(b / a for a, b in zip(together[1], together[2]))}


def show(found: dict[str, Any]) -> None:
    print(f"{'8 steps, 25 x 25 (ms)':36} {'one message':>12} {'one by one':>11} {'ratio':>6} {'solvers':>8} {'beyond':>7}")
    for row in found["rows"]:
        name = f"{row['workers']} worker{'s' if row['workers'] > 1 else ''}"
        beyond = f"{1e3 * row['beyond']:7.3f}" if row["workers"] == 1 else ""
        print(
            f"{name:36} {1e3 * row['together']:12.3f} {1e3 * row['one_by_one']:11.3f} {row['over_one_by_one']:6.2f} "
            f"{1e3 * row['solves']:8.3f} {beyond}"
        )
    print(f"two workers over one: {found['two_over_one']:.2f}; beyond: one message less its solvers, for each contact")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=300, help="steps of each vehicle (default %(default)s)")
    parser.add_argument("--quantile", type=float, default=0.5, help="quantile of the times; use 0.1 on a busy machine (default 0.5)")
    options = parser.parse_args()
    program = daemon_program()
    show(measure(program, options.rounds, options.quantile))


if __name__ == "__main__":
    main()

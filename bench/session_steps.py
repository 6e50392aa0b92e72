"""Measures the overhead of a session's step beyond its solve: round trips of warm steps, of their answers sent again,
of the same problems by contact.solve, and of an empty request, over ipc and loopback TCP. The program uses ZeroMQ
directly, to exclude the cost of client libraries.

    python3 bench/session_steps.py [--n 25] [--steps 400]     (PATH or CONTACTD_BIN names contactd)
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from collections.abc import Callable
from typing import Any

import zmq

from contactd import LocalDaemon
from daemon_program import daemon_program


def answered(socket: zmq.Socket[bytes]) -> tuple[dict[str, Any], float]:
    """Returns an answer's envelope and its arrival time. Skips progress messages, which a busy machine sends often."""
    while True:
        first, *_ = socket.recv_multipart()
        end = time.perf_counter()
        envelope: dict[str, Any] = json.loads(first)
        if "progress" not in envelope:
            assert envelope["status"]["code"] == 0, envelope["status"]
            return envelope, end


class Asker:
    """Represents one DEALER; `ask` returns the result and the seconds of the round trip."""

    def __init__(self, context: zmq.Context[Any], endpoint: str) -> None:
        self.socket = context.socket(zmq.DEALER)
        self.socket.connect(endpoint)

    def ask(self, method: str, params: dict[str, Any]) -> tuple[dict[str, Any], float]:
        request = json.dumps({"contactd": 1, "id": "1", "method": method, "params": params}).encode()
        start = time.perf_counter()
        self.socket.send(request)
        envelope, end = answered(self.socket)
        return envelope["result"], end - start


def solver_seconds(result: dict[str, Any]) -> float:
    return sum(part["seconds"] for name, part in result["evidence"].items() if name in ("normal", "tangential"))


def problem(n: int) -> dict[str, Any]:
    """Returns steady rolling of an ellipse of 6 x 4 mm under 50 kN, the case of docs/performance.md."""
    return {
        "grid": {"nx": n, "ny": n, "dx": 14.4 / n, "dy": 9.6 / n},
        "bodies": {"upper": {"G": 82000, "nu": 0.28}},
        "ics": {"source": "analytic"},
        "gap": {"semi_axes": {"a": 6, "b": 4}},
        "friction": {"mu": 0.3, "rolling": {}},
    }


def motion(step: int, change: float) -> dict[str, Any]:
    """Returns creepages that vary up and down between one and two times the first, by `change` per step."""
    period = round(0.7 / change)
    growth = (1 + change) ** min(step % (2 * period), 2 * period - step % (2 * period))
    return {"xi": 0.002 * growth, "eta": 0.001 * growth, "phi": 1e-4 * growth}


def quantile(values: list[float], part: float) -> float:
    return sorted(values)[int(part * (len(values) - 1))]


def measure(count: int, part: float, ask: Callable[[int], tuple[dict[str, Any], float]]) -> dict[str, float]:
    trips, solves, iterations = [], [], []
    for step in range(1, count + 1):
        result, seconds = ask(step)
        trips.append(seconds)
        if "evidence" in result:
            solves.append(solver_seconds(result))
            iterations.append(result["evidence"]["tangential"]["iterations"])
    row = {"trip": quantile(trips, part)}
    if solves:
        row["solve"] = quantile(solves, part)
        row["rest"] = quantile([t - s for t, s in zip(trips, solves, strict=True)], part)
        row["iterations"] = statistics.mean(iterations)
    return row


def run(endpoint: str, n: int, steps: int, change: float, part: float) -> dict[str, dict[str, float]]:
    context: zmq.Context[Any] = zmq.Context()
    try:
        asker, fixed = Asker(context, endpoint), problem(n)
        rows = {"server.health": measure(steps, part, lambda _: asker.ask("server.health", {}))}

        def solve(step: int) -> tuple[dict[str, Any], float]:
            friction = {"mu": 0.3, "rolling": motion(step, change)}
            return asker.ask("contact.solve", {**fixed, "Fn": 50e3, "friction": friction})

        solve(1)
        rows["contact.solve"] = measure(steps, part, solve)
        session = asker.ask("session.open", fixed)[0]["session"]

        def take(step: int) -> tuple[dict[str, Any], float]:
            friction = {"rolling": motion(step, change)}
            return asker.ask("session.step", {"session": session, "step": step, "Fn": 50e3, "friction": friction})

        rows["session.step"] = measure(steps, part, take)
        rows["... again"] = {"trip": measure(steps, part, lambda _: take(steps))["trip"]}
        asker.ask("session.close", {"session": session})
        return rows
    finally:
        context.destroy(linger=0)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--n", type=int, default=25, help="elements along x and y (default %(default)s)")
    parser.add_argument("--steps", type=int, default=400, help="requests of each kind (default %(default)s)")
    parser.add_argument("--change", type=float, default=0.05, help="relative change of a step (default %(default)s)")
    parser.add_argument("--quantile", type=float, default=0.5, help="quantile of the times; use 0.1 on a busy machine (default 0.5)")
    options = parser.parse_args()
    program = daemon_program()
    print(f"{'':14}{'':16}{'round trip':>12}{'solver':>12}{'rest (us)':>12}{'iterations':>12}")
    for name, given in (("ipc", {}), ("loopback TCP", {"endpoint": "tcp://127.0.0.1:*"})):
        with LocalDaemon(program, config={"log": {"level": "warn"}, **given}) as daemon:
            for method, row in run(daemon.endpoint, options.n, options.steps, options.change, options.quantile).items():
                cells = [f"{1e6 * row[key]:12.0f}" if key in row else " " * 12 for key in ("trip", "solve", "rest")]
                print(f"{name:14}{method:16}{''.join(cells)}{row.get('iterations', 0):12.1f}")


if __name__ == "__main__":
    main()

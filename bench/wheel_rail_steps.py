"""Compares the cost of a step of a wheel on its rail in a session with that of wheelrail.solve: round trips and bytes
sent, alternating, over ipc. Both have profiles given by points, like measured ones. The program uses ZeroMQ directly,
to exclude the cost of client libraries.

    python3 bench/wheel_rail_steps.py [--model fastsim] [--points 500] [--steps 200]     (CONTACTD_BIN names contactd)
"""

from __future__ import annotations

import argparse
import json
import math
import statistics
import time
from typing import Any

import zmq

from contactd import LocalDaemon
from contactd.wheel_rail import WheelRailSetup
from daemon_program import daemon_program
from session_steps import answered


class Asker:
    """Represents one DEALER; `ask` returns the result, the bytes that were sent and the seconds of the round trip."""

    def __init__(self, context: zmq.Context[Any], endpoint: str) -> None:
        self.socket = context.socket(zmq.DEALER)
        self.socket.connect(endpoint)

    def ask(self, method: str, params: dict[str, Any], frames: list[bytes]) -> tuple[dict[str, Any], int, float]:
        start = time.perf_counter()
        request = json.dumps({"contactd": 1, "id": "1", "method": method, "params": params}).encode()
        self.socket.send_multipart([request, *frames])
        envelope, end = answered(self.socket)
        return envelope["result"], len(request) + sum(map(len, frames)), end - start


def profile(client: Any, points: int) -> tuple[dict[str, Any], list[bytes]]:
    """Returns S1002 and 60E1 as points, with their frames."""
    side = client.placed_profiles(WheelRailSetup()).right
    frames, parts = [], {}
    for name, curve in (("wheel", side.wheel), ("rail", side.rail)):
        chosen = curve[:: max(1, len(curve) // points)]
        frames.append(chosen.astype("<f8").tobytes())
        parts[name] = {"points": {"$array": {"frame": len(frames), "dtype": "<f8", "shape": list(chosen.shape)}}}
    return parts, frames


def state(step: int) -> dict[str, Any]:
    """Returns a state of hunting by 3 mm at 20 m/s, one millisecond per step, under an oscillating force."""
    way = 2 * math.pi * step / 300
    return {
        "position": {"y": 3 * math.sin(way), "yaw": 2e-3 * math.cos(way), "roll": -1.5e-4 * math.sin(way)},
        "velocity": {"x": 20e3, "y": 63 * math.cos(way), "pitch": -20e3 / 460},
        "Fz": 8e4 * (1 + 0.05 * math.sin(7 * way)),
    }


def run(daemon: LocalDaemon, options: argparse.Namespace) -> None:
    with daemon.client() as client:
        parts, frames = profile(client, options.points)
    setup = {**parts, "model": options.model, "friction": {"mu": 0.3}, "dx": options.size, "dy": options.size}
    context: zmq.Context[Any] = zmq.Context()
    try:
        asker = Asker(context, daemon.endpoint)
        session = asker.ask("session.open", {"wheelrail": {"setup": setup}}, frames)[0]["session"]
        rows: dict[str, list[tuple[int, float, int]]] = {"wheelrail.solve": [], "session.step": []}
        apart = 0.0
        for step in range(1, options.steps + 1):
            now = state(step)
            params = {"setup": setup, "state": now, "fields": []}
            alone, *cost = asker.ask("wheelrail.solve", params, frames)
            rows["wheelrail.solve"].append((cost[0], cost[1], alone["force"]["iterations"]))
            params = {"session": session, "step": step, "wheelrail": {"state": now}}
            result, *cost = asker.ask("session.step", params, [])
            kept = result["wheelrail"]
            rows["session.step"].append((cost[0], cost[1], kept["force"]["iterations"]))
            forces = zip(alone["forces"]["track"].values(), kept["forces"]["track"].values())
            apart = max(apart, *(abs(one - other) / now["Fz"] for one, other in list(forces)[:3]))
    finally:
        context.destroy(linger=0)
    print(f"{'':16}{'bytes':>8}{'round trip (us)':>18}{'solves':>8}")
    for method, costs in rows.items():
        sent, seconds, solves = zip(*costs[1:])
        print(f"{method:16}{statistics.mean(sent):8.0f}{1e6 * statistics.median(seconds):18.0f}{statistics.mean(solves):8.2f}")
    pairs = zip(rows["session.step"][1:], rows["wheelrail.solve"][1:])
    print(f"session.step over wheelrail.solve: {statistics.median(one[1] / other[1] for one, other in pairs):.2f} of the time")
    print(f"forces differ by at most {apart:.1e} of Fz")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--model", default="full", choices=["full", "fastsim"])
    parser.add_argument("--points", type=int, default=500, help="points of each profile (default %(default)s)")
    parser.add_argument("--size", type=float, default=0.5, help="element size (mm, default %(default)s)")
    parser.add_argument("--steps", type=int, default=200, help="requests of each kind (default %(default)s)")
    program = daemon_program()
    with LocalDaemon(program, config={"log": {"level": "warn"}}) as daemon:
        run(daemon, parser.parse_args())


if __name__ == "__main__":
    main()

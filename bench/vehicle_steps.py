"""Measures the cost of a step of the eight wheels of a vehicle for each interface: C in process and with a daemon
(rows of bench_vehicle), and Python in one session.step_many. It prints medians and 99th percentiles of one run.

    python3 bench/vehicle_steps.py --bin build/production/bin [--steps 300]
"""

from __future__ import annotations

import argparse
import json
import math
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from contactd import Client, LocalDaemon
from contactd.wheel_rail import WheelRailFriction, WheelRailSetup, WheelRailState, WheelsetPosition, WheelsetVelocity
from session_steps import quantile

WHEELS = 8
SPEED, RADIUS, STATIC_FZ = 20e3, 460.0, 70e3  # mm/s, mm, N


def states(step: int) -> Iterator[WheelRailState]:
    """Yields the wheels of the hunting vehicle of bench/vehicle.hpp."""
    for wheel in range(WHEELS):
        left = wheel % 2
        way = 2 * math.pi * step / 300 + 0.7 * (wheel // 2)
        share = (80 if left == 0 else 60) / 70 * (1 + 0.05 * math.sin(7 * way + left))
        yield WheelRailState(
            position=WheelsetPosition(y=3 * math.sin(way), yaw=2e-3 * math.cos(way), roll=-1.5e-4 * math.sin(way)),
            velocity=WheelsetVelocity(x=SPEED, y=63 * math.cos(way), pitch=-SPEED / RADIUS),
            Fz=STATIC_FZ * share,
        )


def by_python(client: Client, model: str, steps: int) -> list[float]:
    """Returns the seconds of each step, after twenty warm-up steps."""
    setups = [
        WheelRailSetup(model=model, side="left" if wheel % 2 else "right", dx=0.5, dy=0.5, friction=WheelRailFriction(0.3))
        for wheel in range(WHEELS)
    ]
    sessions = [client.wheel_rail_session(setup) for setup in setups]
    seconds = []
    for step in range(steps + 20):
        asked = [(session, {"state": state}) for session, state in zip(sessions, states(step), strict=True)]
        start = time.perf_counter()
        answers = client.step_many(asked)
        seconds.append(time.perf_counter() - start)
        for answer in answers:
            if isinstance(answer, Exception):
                raise answer
    for session in sessions:
        session.close()
    return seconds[20:]


def by_c(program: Path, endpoint: str) -> list[dict[str, Any]]:
    command = [program, "--benchmark_filter=hunting", "--benchmark_format=json", "--benchmark_min_time=1s"]
    done = subprocess.run(command, env={**os.environ, "CONTACTD_ENDPOINT": endpoint}, stdout=subprocess.PIPE, check=True)
    rows: list[dict[str, Any]] = json.loads(done.stdout)["benchmarks"]
    return rows


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=Path, required=True, help="folder with contactd and bench_vehicle")
    parser.add_argument("--steps", type=int, default=300, help="steps of Python (default: 300)")
    arguments = parser.parse_args()
    with LocalDaemon(arguments.bin / "contactd", config={"workers": 2, "log": {"level": "error"}}) as daemon:
        rows = by_c(arguments.bin / "bench_vehicle", daemon.endpoint)
        with Client(daemon.endpoint) as client:
            python = {model: by_python(client, model, arguments.steps) for model in ("fastsim", "full")}
    for row in rows:
        ratios = {name: row[name] for name in ("over_one_thread", "over_two_threads", "over_product") if name in row}
        tail = ", ".join(f"{name} {value:.2f}" for name, value in ratios.items())
        print(f"{row['name']:60} {row['us']:8.0f} us, 99 %: {row['p99_us']:8.0f} us  {tail}")
    for model, seconds in python.items():
        print(f"{'Python, ' + model:60} {1e6 * quantile(seconds, 0.5):8.0f} us, 99 %: {1e6 * quantile(seconds, 0.99):8.0f} us")
    return 0


if __name__ == "__main__":
    sys.exit(main())

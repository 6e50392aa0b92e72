"""Measures the overhead of the daemon: the latency of a request beyond its solve, solves per second by number of
workers, the steps of many contacts in one message (many_steps.py), many problems in one message (many_solves.py), and
Python calls in process (in_process.py).

    ./dev bench --service [--quick] [--json FILE]

bench_service measures the latency. For the throughput, one client keeps two requests per worker in flight.
"""

from __future__ import annotations

import json
import statistics
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import zmq

import in_process
import many_solves
import many_steps
from contactd import LocalDaemon
from session_steps import motion, problem

#: One and two workers alternate, so that other work on the machine disturbs both equally.
ROUNDS = 7
#: Times that daemon and client poll for messages before they sleep (us). Latency is measured with each.
SPINS = (0, 2000)


def message(slot: int, method: str, params: dict[str, Any]) -> bytes:
    return json.dumps({"contactd": 1, "id": str(slot), "method": method, "params": params}).encode()


class Solves:
    """Repeats the paper's Cattaneo problem on n x n elements."""

    def __init__(self, n: int) -> None:
        self.name = f"{n} x {n}, shift: solves/s"
        self.params = {
            "grid": {"nx": n, "ny": n, "dx": 2.4 / n, "dy": 2.4 / n},
            "bodies": {"upper": {"G": 200, "nu": 0.42}},
            "ics": {"source": "analytic"},
            "gap": {"paraboloid": {"Rx": 50, "Ry": 50}},
            "approach": 0.02,
            "friction": {"mu": 0.4, "rigid_shift": [0.00817, 0]},
        }

    def open(self, socket: zmq.Socket[bytes], slots: int) -> None:
        """Does nothing, because single solves need no session."""

    def request(self, slot: int) -> bytes:
        return message(slot, "contact.solve", self.params)


class Steps:
    """Repeats warm steps of steady rolling, each in the session of its slot, for the problem of session_steps.py."""

    def __init__(self, n: int) -> None:
        self.name = f"{n} x {n}, warm steps of sessions/s"
        self.params = problem(n)
        self.sessions: list[str] = []
        self.steps: list[int] = []

    def open(self, socket: zmq.Socket[bytes], slots: int) -> None:
        self.steps = [0] * slots
        self.sessions = []
        for slot in range(slots):
            socket.send(message(slot, "session.open", self.params))
            self.sessions.append(answer(socket)["result"]["session"])

    def request(self, slot: int) -> bytes:
        self.steps[slot] += 1
        step = self.steps[slot]
        friction = {"rolling": motion(step, 0.05)}
        params = {"session": self.sessions[slot], "step": step, "Fn": 50e3, "friction": friction}
        return message(slot, "session.step", params)


@contextmanager
def connected(endpoint: str) -> Iterator[zmq.Socket[bytes]]:
    with zmq.Context() as context, context.socket(zmq.DEALER) as socket:
        socket.linger = 0
        socket.rcvtimeo = 60_000
        socket.connect(endpoint)
        yield socket


def answer(socket: zmq.Socket[bytes]) -> dict[str, Any]:
    envelope: dict[str, Any] = json.loads(socket.recv_multipart()[0])
    while "progress" in envelope:
        envelope = json.loads(socket.recv_multipart()[0])
    if envelope["status"]["code"] != 0:
        raise RuntimeError(envelope["status"]["message"])
    return envelope


def answers_per_second(socket: zmq.Socket[bytes], work: Solves | Steps, slots: int, seconds: float) -> float:
    """Measures with one request of each slot in flight."""
    for slot in range(slots):
        socket.send(work.request(slot))
    start = time.perf_counter()
    count = 0
    while time.perf_counter() - start < seconds:
        socket.send(work.request(int(answer(socket)["id"])))
        count += 1
    took = time.perf_counter() - start
    for _ in range(slots):
        answer(socket)
    return count / took


def processor_seconds(pid: int) -> float:
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(") ")[2].split()
    return (int(fields[11]) + int(fields[12])) / 100.0


def throughput(binaries: Path, kind: type[Solves] | type[Steps], n: int, seconds: float) -> dict[str, Any]:
    """Returns answers per second of one and of two workers, which alternate."""
    rates: dict[int, list[float]] = {1: [], 2: []}
    processor: list[float] = []
    with ExitStack() as stack:
        daemons, sockets, works = {}, {}, {}
        for workers in rates:
            config = {"workers": workers, "log": {"level": "warn"}}
            daemons[workers] = stack.enter_context(LocalDaemon(binaries / "contactd", config=config))
            sockets[workers] = stack.enter_context(connected(daemons[workers].endpoint))
            works[workers] = kind(n)
            works[workers].open(sockets[workers], 2 * workers)
            answers_per_second(sockets[workers], works[workers], 2 * workers, 0.2)  # tables, plans, threads
        for _ in range(ROUNDS):
            for workers, socket in sockets.items():
                before, start = processor_seconds(daemons[workers].pid), time.perf_counter()
                rates[workers].append(answers_per_second(socket, works[workers], 2 * workers, seconds))
                if workers == 2:
                    spent = processor_seconds(daemons[workers].pid) - before
                    processor.append(spent / (time.perf_counter() - start))
    ratios = [two / one for one, two in zip(rates[1], rates[2], strict=True)]
    return {
        "name": kind(n).name, "n": n, "one": max(rates[1]), "two": max(rates[2]),
        "best_over_best": max(rates[2]) / max(rates[1]), "median_ratio": statistics.median(ratios), "ratios": ratios,
        "processors_used_by_two": statistics.median(processor),
    }  # fmt: skip


def latency(binaries: Path, rounds: int, spin: int) -> list[dict[str, Any]]:
    """Measures one request at a time with one worker. `spin` is the polling time of daemon and client (us)."""
    with tempfile.TemporaryDirectory() as folder, ExitStack() as stack:
        endpoints = []
        for name, endpoint in (("tcp", "tcp://127.0.0.1:*"), ("ipc", None)):
            config: dict[str, Any] = {"workers": 1, "spin_microseconds": spin} | ({"endpoint": endpoint} if endpoint else {})
            daemon = LocalDaemon(binaries / "contactd", folder=Path(folder) / name, config=config)
            endpoints.append(stack.enter_context(daemon).endpoint)
        command = [str(binaries / "bench_service"), str(rounds), str(spin), *endpoints]
        ran = subprocess.run(command, check=True, stdout=subprocess.PIPE)
    rows: list[dict[str, Any]] = json.loads(ran.stdout)
    return rows


def report(binaries: Path, quick: bool, json_file: Path | None) -> None:
    rows = [row for spin in SPINS for row in latency(binaries, 200 if quick else 2000, spin)]
    print(f"{'latency (ms, medians)':36} {'solve':>8} {'request':>8} {'overhead':>9} {'least':>7} {'echo':>7} {'health':>7} {'/echo':>7}")
    for row in rows:
        name = f"{row['endpoint']}, {row['n']} x {row['n']}, {'shift' if row['friction'] else 'normal'}"
        name += ", spinning" if row["spin"] else ""
        least = row["request"]["min"] - row["solve"]["min"]
        print(
            f"{name:36} {row['solve']['median']:8.3f} {row['request']['median']:8.3f} {row['overhead']['median']:9.3f} "
            f"{least:7.3f} {row['echo']['median']:7.3f} {row['health']['median']:7.3f} {row['over_echo']['median']:7.2f}"
        )
    print(
        "overhead: median of request - solve; least: fastest request - fastest solve; echo: the same frames, bare ZeroMQ;\n"
        "/echo: median of overhead / echo"
    )
    seconds = 0.5 if quick else 2.0
    rates = [throughput(binaries, kind, n, seconds) for kind, n in ((Steps, 25), (Solves, 25), (Solves, 160))]
    print(f"\n{'throughput':36} {'1 worker':>9} {'2 workers':>10} {'best/best':>10} {'median':>7} {'processors':>11}")
    for rate in rates:
        print(
            f"{rate['name']:36} {rate['one']:9.1f} {rate['two']:10.1f} {rate['best_over_best']:10.2f} {rate['median_ratio']:7.2f} "
            f"{rate['processors_used_by_two']:11.2f}"
        )
    print()
    many = many_steps.measure(binaries / "contactd", 100 if quick else 1000)
    many_steps.show(many)
    solves = many_solves.measure(binaries / "contactd", 20 if quick else 100)
    many_solves.show(solves)
    print()
    calls = in_process.measure(binaries, 100 if quick else 1000)
    in_process.show(calls)
    if json_file:
        found = {"latency": rows, "throughput": rates, "many_steps": many, "many_solves": solves, "in_process": calls}
        json_file.write_text(json.dumps(found, indent=1))

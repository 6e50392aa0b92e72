"""Load: many clients at once, every answer checked, the memory of the daemon watched, bad citizens among them.

    ./dev load [--seconds 600] [--clients 200] [--transport tcp] [--json FILE]

The first third of the time (after a warm-up) is without bad citizens, the rest with them: one that never reads, one that
sends forever without reading, one that disconnects in the middle of requests.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import statistics
import sys
import time
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import zmq

from contactd import LocalDaemon
from load import clients
from load.bad_citizens import BAD_CITIZENS
from load.process import resident_bytes
from load.workload import SMALL

OUTBOX_BYTES = 32 << 20  # small, so that it fills while somebody watches


def watch_memory(pid: int, until: float, interval: float) -> list[tuple[float, int]]:
    """Resident bytes over time."""
    samples = []
    while (now := time.monotonic()) < until:
        samples.append((now, resident_bytes(pid)))
        time.sleep(min(interval, max(0.01, until - now)))
    return samples


def percentiles(values: list[float]) -> dict[str, float]:
    values = sorted(values)
    return {f"p{q:g}": values[min(len(values) - 1, int(q / 100 * len(values)))] for q in (50, 90, 99, 99.9)} | {"count": len(values)}


def phases_of(start: float, seconds: float) -> list[tuple[str, float]]:
    warm_up = 0.1 * seconds
    return [("warm-up", start + warm_up), ("alone", start + seconds / 3 + warm_up), ("with bad citizens", start + seconds)]


def _executor(size: int, in_threads: bool) -> Executor:
    """Of processes that have started."""
    if in_threads:
        return ThreadPoolExecutor(size)
    pool = ProcessPoolExecutor(size, mp_context=multiprocessing.get_context("spawn"))
    list(pool.map(time.sleep, [0.2] * size))
    return pool


def run(
    daemon: LocalDaemon, number: int, seconds: float, processes: int = 4, seed: int = 1, in_threads: bool = False
) -> dict[str, Any]:
    """The report; `problems` is empty when every request was answered once and rightly."""
    with zmq.Context() as context, context.socket(zmq.DEALER) as socket:
        socket.linger = 0
        socket.connect(daemon.endpoint)
        references = clients.references(socket)
    with _executor(processes + len(BAD_CITIZENS), in_threads) as pool:
        start = time.monotonic()
        phases = phases_of(start, seconds)
        shares = [number // processes + (n < number % processes) for n in range(processes)]
        good = [
            pool.submit(clients.run, daemon.endpoint, f"p{n}", share, seed + n, references, phases) for n, share in enumerate(shares)
        ]
        memory = watch_memory(daemon.pid, phases[1][1], seconds / 100)
        bad = [pool.submit(citizen, daemon.endpoint, phases[-1][1]) for citizen in BAD_CITIZENS]
        memory += watch_memory(daemon.pid, phases[-1][1], seconds / 100)
        tallies = [future.result() for future in good]
        sent_badly = {citizen.__name__: future.result() for citizen, future in zip(BAD_CITIZENS, bad, strict=True)}
    return report(tallies, memory, phases, sent_badly)


def report(tallies: list[clients.Tally], memory: list[tuple[float, int]], phases: Any, sent_badly: dict[str, int]) -> dict[str, Any]:
    names = [name for name, _ in phases]
    latency: dict[str, Any] = {}
    for phase in names:
        merged: dict[str, list[float]] = {}
        for tally in tallies:
            for kind, values in tally.latencies.get(phase, {}).items():
                merged.setdefault(kind, []).extend(values)
        latency[phase] = {kind: percentiles(values) for kind, values in sorted(merged.items())}
    ends = dict(phases)
    halves: dict[str, list[float]] = {}
    for before, phase in zip(names, names[1:], strict=False):
        middle = (ends[before] + ends[phase]) / 2
        parts = [[b for t, b in memory if ends[before] <= t < middle], [b for t, b in memory if middle <= t < ends[phase]]]
        halves[phase] = [round(statistics.median(part) / 2**20, 1) for part in parts if part]
    return {
        "sent": sum(t.sent for t in tallies),
        "answered": sum(t.answered for t in tallies),
        "refused": sum(t.refused for t in tallies),
        "problems": [problem for t in tallies for problem in t.problems],
        "latency_ms": latency,
        "resident_MiB_halves": halves,
        "resident_MiB": [(round(t - memory[0][0], 1), round(b / 2**20, 1)) for t, b in memory],
        "bad_citizens_sent": sent_badly,
    }


def print_report(found: dict[str, Any], seconds: float) -> None:
    print(f"{found['sent']} requests, {found['answered']} answers ({found['answered'] / seconds:.0f}/s), {found['refused']} refused for now")
    print(f"bad citizens sent {found['bad_citizens_sent']}")
    print(f"{'latency (ms)':44} {'count':>8} {'p50':>8} {'p90':>8} {'p99':>8} {'p99.9':>8}")
    for phase, kinds in found["latency_ms"].items():
        for kind, p in kinds.items():
            print(f"{phase + ': ' + kind:44} {p['count']:8} {p['p50']:8.1f} {p['p90']:8.1f} {p['p99']:8.1f} {p['p99.9']:8.1f}")
    print(f"resident memory (MiB), median of the first and second half of each phase: {found['resident_MiB_halves']}")
    for phase in ("alone", "with bad citizens"):
        print(f"99th percentile of small solves, {phase}: {found['latency_ms'][phase][SMALL]['p99']:.1f} ms")
    for problem in found["problems"]:
        print(f"PROBLEM: {problem}")


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=Path, required=True, help="folder with the programs")
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--clients", type=int, default=200)
    parser.add_argument("--transport", choices=["tcp", "ipc"], default="tcp")
    parser.add_argument("--json", type=Path, help="write the report to this file, too")
    options = parser.parse_args(arguments)
    config: dict[str, Any] = {"limits": {"max_outbox_bytes": OUTBOX_BYTES}, "log": {"level": "warn"}}
    if options.transport == "tcp":
        config["endpoint"] = "tcp://127.0.0.1:*"
    with LocalDaemon(options.bin / "contactd", config=config) as daemon:
        found = run(daemon, options.clients, options.seconds)
    print_report(found, options.seconds)
    if options.json:
        options.json.write_text(json.dumps(found, indent=1))
    return 1 if found["problems"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

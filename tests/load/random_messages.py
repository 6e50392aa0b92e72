"""Sends random messages to a running daemon: each gets exactly one status with its id.

    ./dev load random [--seconds 600] [--seed 1]                grids as large as the limits allow
    ./dev load random --small [--count 100000]                  grids of 36 elements, ten times as many messages
    ./dev load random --preset sanitize [--small ...]           at a daemon that is built with ASan and UBSan (several times slower)

Requests are made from the schemas of server.describe and damaged (messages.py, large_messages.py). With large grids,
the memory must stay within its bound, and health must be answered soon (large_load.py). Small messages must leave
nothing in memory; half of them go through DEALER, half through REQ. The daemon's builder is /bin/false.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

import zmq

from contactd import LocalDaemon
from load import large_load
from load.exchange import Outcome, Wrong, by_dealer, by_req, connected, describe, expect_silence, open_session
from load.messages import Messages
from load.process import resident_bytes

LIMITS = {"max_grid_elements": 64, "max_array_elements": 2000, "max_frame_bytes": 65536, "max_message_bytes": 262144, "max_frames": 32}
CONFIG = {"limits": LIMITS, "sessions": {"max_sessions": 4096, "lease_seconds": 5, "max_lease_seconds": 10}, "builds": {"program": "/bin/false"}, "log": {"level": "warn"}}
BATCH = 32


def run(daemon: LocalDaemon, count: int, seed: int) -> Outcome:
    """Sends `count` messages. The memory is checked twenty times, first after a twentieth of them."""
    outcome = Outcome()
    with connected(daemon, zmq.DEALER) as dealer, connected(daemon, zmq.REQ) as req:
        messages = Messages(describe(dealer), seed)
        sent = 0
        while sent < count:
            start = time.monotonic()
            messages.sessions = [*messages.sessions[-2:], open_session(dealer)]
            batch = [messages.next(f"{sent + n}") for n in range(min(BATCH, count - sent))]
            half = len(batch) // 2
            by_dealer(dealer, batch[:half], outcome)
            for message in batch[half:]:
                by_req(req, message, outcome)
            sent += len(batch)
            outcome.slowest = max(outcome.slowest, time.monotonic() - start)
            if sent >= count * (len(outcome.memory) + 1) / 20:
                outcome.memory.append(resident_bytes(daemon.pid))
        expect_silence(dealer)
    if daemon.process.poll() is not None:
        raise Wrong("the daemon has ended")
    return outcome


def print_small(outcome: Outcome, seconds: float) -> None:
    mib = [bytes_ / 2**20 for bytes_ in outcome.memory]
    print(f"resident memory (MiB), each twentieth: {' '.join(f'{value:.1f}' for value in mib)}")
    print(f"slowest batch of {BATCH}: {outcome.slowest:.2f} s; all in {seconds:.0f} s")


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=Path, required=True, help="folder with the programs")
    parser.add_argument("--small", action="store_true", help="small grids, and limits that messages go beyond")
    parser.add_argument("--seconds", type=float, default=600, help="with large grids (default 600)")
    parser.add_argument("--count", type=int, default=100_000, help="messages with small grids (default 100000)")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(arguments)
    start = time.monotonic()
    report: large_load.Report | None = None
    with LocalDaemon(options.bin / "contactd", config=CONFIG if options.small else large_load.CONFIG) as daemon:
        try:
            if options.small:
                outcome = run(daemon, options.count, options.seed)
            else:
                report = large_load.run(daemon, options.seconds, options.seed)
                outcome = report.outcome
        finally:
            # A sanitizer ends the daemon with its report in the log; leaks are reported at a normal end.
            if (status := daemon.stop()) != 0:
                print(f"the daemon ended with status {status}; the end of its log:\n{daemon.log[-5000:]}")
        if status != 0:
            return 1
    for name, count in outcome.statuses.most_common():
        print(f"{count:8} {name}")
    if report is None:
        print_small(outcome, time.monotonic() - start)
        return 0
    print("\n".join(report.lines()))
    problems = report.problems()
    for problem in problems:
        print(f"PROBLEM: {problem}")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

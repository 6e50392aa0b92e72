"""Sends random messages with large grids from several clients at once, and checks and prints three properties: each
message has one answer, the daemon's memory stays within the bound of docs/limits.md, and health is answered soon."""

from __future__ import annotations

import math
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import Any

import zmq

from contactd import LocalDaemon
from load.exchange import Outcome, by_dealer, connected, describe, expect_silence, open_session
from load.large_messages import LargeMessages, templates
from load.watch import Watched, watching

GIB, MIB = 1 << 30, 1 << 20
MAX_GRID_ELEMENTS = 1_000_000
#: Messages are small compared with work here, so that the bound is one of work.
CONFIG: dict[str, Any] = {
    "limits": {"max_work_bytes": 3 * GIB, "max_queue_bytes": 128 * MIB, "max_inbox_bytes": 128 * MIB,
               "max_outbox_bytes": 128 * MIB, "max_message_bytes": 128 * MIB, "max_frame_bytes": 64 * MIB},
    "store": {"memory_budget_bytes": 128 * MIB, "influence_budget_bytes": 128 * MIB},
    "sessions": {"max_sessions": 4096, "lease_seconds": 5, "max_lease_seconds": 10, "max_bytes": 256 * MIB},
    "builds": {"program": "/bin/false"}, "log": {"level": "warn"},
}  # fmt: skip
#: In addition to its work, a daemon has its program, its threads and arenas of the allocator.
BESIDE = 100 * MIB
CLIENTS, BATCH = 3, 8
SOON_MS, IN_TIME = 50, 0.999


def within(times: list[float]) -> float:
    """Returns the time that at most one in a thousand exceeds."""
    return sorted(times)[math.ceil(IN_TIME * len(times)) - 1]


@dataclass
class Report:
    """`bound` counts resident bytes."""

    outcome: Outcome
    watched: Watched
    bound: int
    #: Each batch has here how long after the last deadline its last answer came (s).
    overdue: list[float] = field(default_factory=list)

    def lines(self) -> list[str]:
        seen = self.watched
        own = seen.own_ms()
        return [
            f"{sum(self.outcome.statuses.values())} messages, each answered once",
            f"resident memory: {seen.most / MIB:.0f} MiB at most, of a bound of {self.bound / MIB:.0f}; "
            f"{seen.before / MIB:.0f} before, {seen.kept / MIB:.0f} in caches and sessions at most",
            f"health: {len(own)} answers, {IN_TIME:.1%} within {within(seen.latencies_ms):.1f} ms, all within "
            f"{max(seen.latencies_ms):.1f}; without waits for a processor {within(own):.1f} and {max(own):.1f} ms",
            f"last answer of a batch at most {max(self.overdue):.2f} s after its last deadline",
        ]

    def problems(self, own: bool = False) -> list[str]:
        """Returns violations; `own`: times in which threads waited for a processor do not count, as on a busy
        machine."""
        found = []
        if self.watched.most > self.bound:
            found.append(f"the daemon took {self.watched.most} bytes of memory, and its bound is {self.bound}")
        late = within(self.watched.own_ms() if own else self.watched.latencies_ms)
        if late > SOON_MS:
            found.append(f"{IN_TIME:.1%} of the answers of health took {late:.1f} ms, and {SOON_MS} is the bound")
        return found


def bound(config: dict[str, Any], watched: Watched) -> int:
    """Returns the memory limit of a daemon with this configuration: its work, open messages, and the data that it
    reports."""
    limits = config["limits"]
    messages = limits["max_queue_bytes"] + limits["max_inbox_bytes"] + limits["max_outbox_bytes"]
    return int(limits["max_work_bytes"] + messages + watched.kept + BESIDE)


def client(daemon: LocalDaemon, messages: LargeMessages, until: float, least: int, stop: threading.Event, report: Report) -> None:
    """Sends batches until the time is over and `least` messages were sent; no second answers may follow."""
    sent = 0
    with connected(daemon, zmq.DEALER) as dealer:
        while (time.monotonic() < until or sent < least) and not stop.is_set():
            if name := open_session(dealer):
                messages.sessions = [*messages.sessions[-2:], name]
            batch = [messages.next(f"{sent + n}") for n in range(BATCH)]
            start = time.monotonic()
            by_dealer(dealer, batch, report.outcome)
            report.overdue.append(time.monotonic() - start - max(messages.timeouts_ms) / 1000)
            sent += len(batch)
        expect_silence(dealer)


def run(daemon: LocalDaemon, seconds: float, seed: int, at_least: int = 0) -> Report:
    """Runs for this time, with at least this number of messages. Raises Wrong for a message with a wrong answer;
    Report.problems contains other violations."""
    with connected(daemon, zmq.DEALER) as dealer:
        document = describe(dealer)
    examples = templates(str(daemon.process.args[0]))  # type: ignore[index]
    elements = daemon.config["limits"].get("max_grid_elements", MAX_GRID_ELEMENTS)
    stop = threading.Event()
    with watching(daemon.endpoint, daemon.pid) as watched, ThreadPoolExecutor(CLIENTS) as pool:
        reports = [Report(Outcome(), watched, 0) for _ in range(CLIENTS)]
        until = time.monotonic() + seconds
        futures = [
            pool.submit(client, daemon, LargeMessages(document, 1000 * seed + n, examples, elements), until, at_least // CLIENTS, stop, report)
            for n, report in enumerate(reports)
        ]
        try:
            for future in futures:
                future.result()
        finally:
            stop.set()
    whole = Report(Outcome(), watched, bound(daemon.config, watched))
    for report in reports:
        whole.outcome.statuses.update(report.outcome.statuses)
        whole.overdue += report.overdue
    return whole

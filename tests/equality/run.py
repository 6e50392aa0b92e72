"""Plays cases at a daemon and records its answers."""

from __future__ import annotations

import collections
import threading
from dataclasses import dataclass, field
from pathlib import Path

from contactd import LocalDaemon

from .cases import Case
from .contents import Contents, contents
from .wire import Connection, Request, connected

#: Uses one worker, so that it is deterministic which of two problems finds a table in memory.
CONFIG = {"workers": 1, "builds": {"concurrent": 1}, "log": {"level": "warn"}, "shutdown": {"drain_seconds": 0}}


@dataclass
class Played:
    """Holds the methods of a case's requests, and the contents of their answers."""

    case: Case
    methods: list[str] = field(default_factory=list)
    answers: list[Contents] = field(default_factory=list)


@dataclass
class Run:
    played: list[Played]
    builds: int
    statuses: collections.Counter[str]


def run(program: Path, folder: Path, cases: list[Case], stop: threading.Event | None = None) -> Run:
    """Plays all cases, one request at a time, at a separate daemon whose store is in `folder`. Raises InterruptedError
    on `stop`."""
    with (
        LocalDaemon(program, folder=folder, config=CONFIG) as daemon,
        connected(daemon.endpoint, stop or threading.Event()) as connection,
    ):
        played = [play(connection, case) for case in cases]
        counters = connection.ask(Request("server.info", {})).result["counters"]
    statuses = collections.Counter(str(answer["status.name"]) for one in played for answer in one.answers)
    return Run(played, counters["builds_finished"], statuses)


def play(connection: Connection, case: Case) -> Played:
    played, names = Played(case), dict[str, str]()
    requests = case.play()
    request = next(requests)
    while True:
        answer = connection.ask(request, f"{case.number}/{len(played.answers) + 1}")
        if request.method == "session.open" and answer.ok:
            names[answer.result["session"]] = f"(session {len(names) + 1})"
        played.methods.append(request.method)
        played.answers.append(contents(answer, names))
        try:
            request = requests.send(answer)
        except StopIteration:
            return played

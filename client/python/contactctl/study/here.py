"""Solves cases of a study in threads of this process, which share a client."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from contactd import Client

from ..asking import OwnBuilds
from .journal import Journal
from .plan import Case, Plan
from .solving import row_of
from .threads import Add, by_threads

__all__ = ["run_here"]


def run_here(
    client: Client, plan: Plan, cases: Iterable[Case], journal: Journal, workers: int, on_row: Callable[[], None]
) -> None:
    """Adds a row for each case, and calls `on_row` in this thread. If interrupted, it ends the builds that it started;
    other work in the daemon ends with the connections.
    """
    builds = OwnBuilds(client)

    def answer(case: Case, add: Add) -> None:
        row = row_of(client, plan.method, plan.params(case), plan.names, plan.answers, builds.notice)
        add({"key": case.key, "values": case.values, **row})

    by_threads(cases, answer, journal, workers, on_row, builds.cancel)

"""Runs chains of cases in threads of this process, which share a client."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from contactd.contact_files.case import Case
from contactd.contact_files.runner import Runner
from contactd.contact_files.solved_case import SolvedCase

from ..study.journal import Journal
from ..study.threads import Add, by_threads
from .rows import row_of

__all__ = ["run_requests"]


def run_requests(
    runner: Runner, requests: Sequence[Sequence[Case]], keys: Mapping[int, str], journal: Journal, workers: int,
    keep: Callable[[SolvedCase], None], on_row: Callable[[], None],
) -> None:  # fmt: skip
    """Adds a row for each case of some requests to the journal, and calls `on_row` in this thread. `keys` are by the
    identities of the cases. `keep` writes the other files of a case.
    """

    def compute(cases: Sequence[Case], add: Add) -> None:
        for solved in runner.run(cases):
            keep(solved)
            if not add(row_of(keys[id(solved.case)], solved)):
                return

    by_threads(requests, compute, journal, workers, on_row)

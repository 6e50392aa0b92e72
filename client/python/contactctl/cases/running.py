"""Runs chains of cases in threads of this process, which share a client."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from contactd.contact_files.case import Case
from contactd.contact_files.runner import Outcome, Runner

from ..study.journal import Journal
from ..study.threads import Add, by_threads
from .rows import keys_of, row_of

__all__ = ["run_chains"]


def run_chains(
    runner: Runner, chains: Sequence[Sequence[Case]], options: Mapping[str, Any], journal: Journal, workers: int,
    keep: Callable[[Outcome], None], on_row: Callable[[], None],
) -> None:  # fmt: skip
    """Adds a row for each case to the journal, except for complete chains, and calls `on_row` in this thread. `keep`
    writes the other files of an outcome.
    """
    todo = [chain for chain in chains if any(key not in journal.rows for key in keys_of(chain, options))]

    def compute(chain: Sequence[Case], add: Add) -> None:
        for key, outcome in zip(keys_of(chain, options), runner.run(chain)):
            keep(outcome)
            if not add(row_of(key, outcome)):
                return

    by_threads(todo, compute, journal, workers, on_row)

"""Solves the rows of a table by threads of this process, or by the workers of a Dask cluster."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from contactd import Client

from ..common import Setting
from ..study.by_dask import client_of_worker, dask_at
from ..study.journal import Journal
from ..study.threads import Add, by_threads
from .nodes import solved_row
from .plan import Row, TablePlan

__all__ = ["build_by_dask", "build_here"]


def build_here(client: Client, plan: TablePlan, rows: Sequence[Row], journal: Journal, workers: int, on_row: Callable[[], None]) -> None:
    """Adds the rows to the journal, and calls `on_row` in this thread."""

    def solve(row: Row, add: Add) -> None:
        add({"key": row.key, "values": row.values, **solved_row(client, plan, row)})

    by_threads(rows, solve, journal, workers, on_row)


def build_by_dask(scheduler: str, given: Setting, plan: TablePlan, rows: Sequence[Row], journal: Journal, on_row: Callable[[], None]) -> None:
    """Adds the rows to the journal, and calls `on_row`. The package must be installed on the workers."""
    with dask_at(scheduler) as dask:
        from dask.distributed import as_completed

        futures = dask.map(_solved, rows, plan=plan, given=vars(given), pure=False)
        try:
            for future, row in as_completed(futures, loop=dask.loop, with_results=True):
                journal.add(row)
                future.release()
                on_row()
        except BaseException:
            dask.cancel(futures)
            raise


def _solved(row: Row, plan: TablePlan, given: dict[str, Any]) -> dict[str, Any]:
    """Runs on a worker."""
    return {"key": row.key, "values": row.values, **solved_row(client_of_worker(given), plan, row)}

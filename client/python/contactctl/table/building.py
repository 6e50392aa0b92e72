"""Solves rows of a table or of its check by threads of this process, or by the workers of a Dask cluster."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

from contactd import Client

from ..common import Setting
from ..study.by_dask import client_of_worker, dask_at
from ..study.journal import Journal
from ..study.threads import Add, by_threads

__all__ = ["Solve", "Unit", "solve_by_dask", "solve_here"]


class Unit(Protocol):
    """The unit of work. Its key identifies it in all runs, and its values describe it."""

    @property
    def key(self) -> str: ...
    @property
    def values(self) -> dict[str, Any]: ...


Solve = Callable[[Client, Any], dict[str, Any]]  #: Returns the row of a unit.


def solve_here(
    client: Client, solve: Solve, units: Sequence[Unit], journal: Journal, workers: int, on_row: Callable[[], None]
) -> None:
    """Adds the rows to the journal, and calls `on_row` in this thread."""

    def do(unit: Unit, add: Add) -> None:
        add({"key": unit.key, "values": unit.values, **solve(client, unit)})

    by_threads(units, do, journal, workers, on_row)


def solve_by_dask(
    scheduler: str, given: Setting, solve: Solve, units: Sequence[Unit], journal: Journal, on_row: Callable[[], None]
) -> None:
    """Adds the rows to the journal, and calls `on_row`. The package must be installed on the workers."""
    with dask_at(scheduler) as dask:
        from dask.distributed import as_completed

        futures = dask.map(_solved, units, solve=solve, given=vars(given), pure=False)
        try:
            for future, row in as_completed(futures, loop=dask.loop, with_results=True):
                journal.add(row)
                future.release()
                on_row()
        except BaseException:
            dask.cancel(futures)
            raise


def _solved(unit: Unit, solve: Solve, given: dict[str, Any]) -> dict[str, Any]:
    """Runs on a worker."""
    return {"key": unit.key, "values": unit.values, **solve(client_of_worker(given), unit)}

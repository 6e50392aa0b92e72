"""Solves states of a wear study on the workers of a Dask cluster."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from contactd.wear.evolution import Solve

from ..common import Setting
from ..study.by_dask import client_of_worker, dask_at

__all__ = ["solving_by_dask"]


@contextmanager
def solving_by_dask(scheduler: str, given: Setting) -> Iterator[Solve]:
    """Solves each state on a worker, where the package must be installed."""
    with dask_at(scheduler) as dask:
        yield _solving(dask, given)


def _solving(dask: Any, given: Setting) -> Solve:
    def solve(requests: Sequence[dict[str, Any]], tell: Callable[[int], None]) -> list[dict[str, Any]]:
        futures = dask.map(_solved, list(requests), given=vars(given), pure=False)
        found = []
        try:
            for future in futures:
                found.append(future.result())
                tell(len(found))
        finally:
            dask.cancel(futures)
        return found

    return solve


def _solved(params: dict[str, Any], given: dict[str, Any]) -> dict[str, Any]:
    return client_of_worker(given).call("wheelrail.solve", params)

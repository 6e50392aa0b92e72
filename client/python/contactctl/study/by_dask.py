"""Solves cases of a study on the workers of a Dask cluster, each with a daemon, or in its own process."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from typing import Any

import click

import contactd
from contactd import Client

from ..common import Setting, client_of, is_local
from .journal import Journal
from .plan import Case, Plan
from .solving import row_of

__all__ = ["client_of_worker", "dask_at", "run_by_dask"]

_CLIENTS: dict[Any, Client] = {}  #: Clients of this worker by endpoint.
_ADDRESS = re.compile(r"^inproc://|:\d+/?$")
_OPEN = ExitStack()  #: In-process solvers, which end with the worker.


def dask_at(scheduler: str) -> Any:
    """Returns a Dask client, which closes at the end of a `with`. Raises click.UsageError, and ConnectionFailed without
    an answer.
    """
    try:
        from dask.distributed import Client as Dask
    except ImportError:
        raise click.UsageError("--dask needs dask.distributed: pip install distributed, or on Debian python3-distributed.") from None
    if not _ADDRESS.search(scheduler):  # Dask's client would not close with it.
        raise click.UsageError(f"--dask is {scheduler!r}; it must be the address of a scheduler with its port, such as tcp://host:8786.")
    try:
        return Dask(scheduler, timeout=10, set_as_default=False)
    except (OSError, ValueError) as error:
        raise contactd.ConnectionFailed(f"No Dask scheduler answers at {scheduler}: {error}") from None


def run_by_dask(
    scheduler: str, given: Setting, plan: Plan, cases: Sequence[Case], journal: Journal, on_row: Callable[[], None]
) -> None:
    """Adds a row for each case, and calls `on_row`. The package must be installed on the workers."""
    with dask_at(scheduler) as dask:
        from dask.distributed import as_completed

        by_key = {case.key: case for case in cases}
        arguments = [(case.key, plan.params(case)) for case in cases]
        futures = dask.map(_solved, arguments, method=plan.method, varying=plan.names, answers=plan.answers, given=vars(given), pure=False)
        try:
            for future, (key, row) in as_completed(futures, loop=dask.loop, with_results=True):
                journal.add({"key": key, "values": by_key[key].values, **row})
                future.release()
                on_row()
        except BaseException:
            dask.cancel(futures)
            raise


def _solved(
    argument: tuple[str, dict[str, Any]], method: str, varying: Sequence[str], answers: Sequence[str], given: dict[str, Any]
) -> tuple[str, dict[str, Any]]:
    """Runs on a worker."""
    key, params = argument
    return key, row_of(client_of_worker(given), method, params, varying, answers)


def client_of_worker(given: dict[str, Any]) -> Client:
    """Returns the client of this worker: for the endpoint of the command, or else CONTACTD_ENDPOINT of the worker.
    Without both, the worker solves in process.
    """
    there = Setting(**{name: value for name, value in given.items() if value not in (None, False, ())})
    identity = (there.local, there.folder, there.endpoint)
    if identity not in _CLIENTS:
        here = contactd.local(folder=there.folder) if is_local(there) else None
        _CLIENTS[identity] = client_of(there) if here is None else _OPEN.enter_context(here)
    return _CLIENTS[identity]

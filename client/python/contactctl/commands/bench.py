"""Implements bench, which measures response times of a daemon."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Annotated, Any

import numpy as np
import typer

from contactd import Client

from ..common import Command, connected, setting
from ..files import read_object
from ..output import emit, listing, span
from ..paths import changed
from ..progress import Bar
from .solve import Set

__all__ = ["add_to"]

#: A small contact, so that the cost of requests exceeds that of the solve.
SMALL = {
    "grid": {"nx": 20, "ny": 20, "dx": 0.12, "dy": 0.12},
    "bodies": {"upper": {"G": 200, "nu": 0.42}},
    "gap": {"paraboloid": {"Rx": 50, "Ry": 50}},
    "approach": 0.02,
    "friction": {"mu": 0.4, "rigid_shift": [0.00817, 0]},
    "ics": {"source": "analytic"},
    "fields": [],
}
PERCENTILES = (50, 90, 99)


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(bench)


def bench(
    file: Annotated[str | None, typer.Argument(metavar="[FILE]", help="A problem of contact.solve. Default: a small one of 20 x 20 elements.")] = None,
    sets: Set = None,
    count: Annotated[int, typer.Option("--count", "-n", min=1, max=1_000_000, help="Number of requests of each kind.")] = 200,
    clients: Annotated[int, typer.Option("--clients", "-c", min=1, max=128, help="Number of simultaneous requests.")] = 1,
) -> None:
    """Measure the response times of the daemon from here.

    Requests are server.health, which does nothing, and a solve.
    """
    problem = changed({"fields": [], **read_object(file)} if file else SMALL, sets or ())
    kinds: list[tuple[str, dict[str, Any]]] = [("server.health", {}), ("contact.solve", problem)]
    measured = {}
    with connected(workers=clients if setting().local else None) as client, Bar("timing") as bar:
        for number, (method, params) in enumerate(kinds):
            client.call(method, params)  # warm-up: creates connections and operators
            bar.show(number / len(kinds), method)
            measured[method] = _measured(client, method, params, count, clients)
    columns = ["request", "a second", *(f"{percent} %" for percent in PERCENTILES), "longest"]
    rows = [
        (method, f"{found['per_second']:.4g}", *(span(found[f"p{percent}"]) for percent in PERCENTILES), span(found["max"]))
        for method, found in measured.items()
    ]
    title = f"{count} requests of each kind to {client.endpoint}, {clients} at the same time"
    emit(setting().json, {"count": count, "clients": clients, "requests": measured}, listing(title, columns, rows))


def _measured(client: Client, method: str, params: dict[str, Any], count: int, clients: int) -> dict[str, float]:
    times: list[float] = []
    errors: list[BaseException] = []
    todo = iter(range(count))
    lock = threading.Lock()

    def work() -> None:
        while not errors:
            with lock:
                if next(todo, None) is None:
                    return
            began = time.perf_counter()
            try:
                client.call(method, params)
            except BaseException as error:  # raised in the thread that waits
                errors.append(error)
                return
            times.append(time.perf_counter() - began)

    began = time.perf_counter()
    _run(work, clients, errors)
    elapsed = time.perf_counter() - began
    percentiles = {f"p{percent}": float(np.percentile(times, percent)) for percent in PERCENTILES}
    return {"per_second": len(times) / elapsed, **percentiles, "max": max(times)}


def _run(work: Callable[[], None], threads: int, errors: list[BaseException]) -> None:
    started = [threading.Thread(target=work, daemon=True) for _ in range(threads)]
    for thread in started:
        thread.start()
    try:
        for thread in started:
            thread.join()
    except KeyboardInterrupt as error:
        errors.append(error)
        for thread in started:
            thread.join()
        raise
    if errors:
        raise errors[0]

"""watch: what the daemon is doing, again and again."""

from __future__ import annotations

import sys
import time
from typing import Annotated, Any

import typer
from rich.console import Group as Stack
from rich.live import Live

from contactd import Job

from ..common import Command, connected, setting
from ..measured import Reading, difference
from ..output import console, emit, facts, listing, on_terminal, size, span
from .jobs import shown_jobs

__all__ = ["add_to"]


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(watch)


def watch(
    interval: Annotated[float, typer.Option("--interval", "-i", min=0.1, max=3600, help="Seconds between looks.")] = 1.0,
    count: Annotated[int | None, typer.Option("--count", "-n", min=1, help="End after so many looks; else with Ctrl-C.")] = None,
) -> None:
    """Show live what the daemon does, until Ctrl-C.

    Requests, solves, builds, memory, jobs. In a pipe a line a look, with --json an object.
    """
    as_json, is_live = setting().json, on_terminal(sys.stdout) and not setting().json
    with connected() as client, Live(console=console(), auto_refresh=False, transient=False) as live:
        if not is_live:
            live.stop()
        before, look = Reading.of(client.metrics()), 0
        while count is None or look < count:
            time.sleep(interval)
            now, look = Reading.of(client.metrics()), look + 1
            said = difference(before, now)
            before = now
            if is_live:
                live.update(_screen(client.endpoint, said, client.jobs()), refresh=True)
            else:
                emit(as_json, said, _line(said))


def _line(said: dict[str, Any]) -> str:
    return (
        f"{said['requests_per_second']:.4g} requests/s  {said['solves_per_second']:.4g} solves/s  "
        f"{said['workers_busy']:.0f} of {said['workers']:.0f} workers  {said['builds_running']:.0f} builds  "
        f"{said['sessions']:.0f} sessions  {size(said['resident_bytes'])}"
    )


def _screen(endpoint: str, said: dict[str, Any], jobs: tuple[Job, ...]) -> Stack:
    rates = facts(
        f"{endpoint}, running for {span(said['uptime_seconds'])}; Ctrl-C ends",
        [
            ("requests", f"{said['requests_per_second']:.4g} a second, {said['open_requests']:.0f} open"),
            ("solves", f"{said['solves_per_second']:.4g} a second, {said['solves_waiting']:.0f} waiting"),
            ("workers", f"{said['workers_busy']:.0f} of {said['workers']:.0f} busy"),
            ("builds", f"{said['builds_running']:.0f} running, {said['builds_waiting']:.0f} waiting"),
            ("sessions", f"{said['sessions']:.0f}, {size(said['session_bytes'])}"),
            ("tables", f"{said['tables']:.0f} in memory, {said['store_tables']:.0f} ({size(said['store_bytes'])}) in the store"),
            ("connections", f"{said['connections']:.0f}"),
            ("memory", f"{size(said['resident_bytes'])}, without builders"),
            ("processor", f"{100 * said['processors']:.0f} % of one"),
        ],
    )
    methods = listing(
        None, ["method", "a second", "mean time"],
        [(name, f"{rate['per_second']:.4g}", span(rate["mean_seconds"])) for name, rate in said["methods"].items()],
    )  # fmt: skip
    parts: list[Any] = [rates]
    if said["methods"]:
        parts += ["", methods]
    if jobs:
        parts += ["", shown_jobs(jobs)]
    return Stack(*parts)

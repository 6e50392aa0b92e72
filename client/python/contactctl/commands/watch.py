"""Implements watch, which regularly updates the activity of the daemon."""

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
    interval: Annotated[float, typer.Option("--interval", "-i", min=0.1, max=3600, help="Seconds between updates.")] = 1.0,
    count: Annotated[int | None, typer.Option("--count", "-n", min=1, help="End after this number of updates.")] = None,
) -> None:
    """Show the activity of the daemon, until Ctrl-C.

    It shows requests, solves, builds, memory and jobs. A pipe receives one line per update, or one object with --json.
    """
    as_json, is_live = setting().json, on_terminal(sys.stdout) and not setting().json
    with connected() as client, Live(console=console(), auto_refresh=False, transient=False) as live:
        if not is_live:
            live.stop()
        before, look = Reading.of(client.metrics()), 0
        while count is None or look < count:
            time.sleep(interval)
            now, look = Reading.of(client.metrics()), look + 1
            given = difference(before, now)
            before = now
            if is_live:
                live.update(_screen(client.endpoint, given, client.jobs()), refresh=True)
            else:
                emit(as_json, given, _line(given))


def _line(given: dict[str, Any]) -> str:
    return (
        f"{given['requests_per_second']:.4g} requests/s  {given['solves_per_second']:.4g} solves/s  "
        f"{given['workers_busy']:.0f} of {given['workers']:.0f} workers  {given['builds_running']:.0f} builds  "
        f"{given['sessions']:.0f} sessions  {size(given['resident_bytes'])}"
    )


def _screen(endpoint: str, given: dict[str, Any], jobs: tuple[Job, ...]) -> Stack:
    rates = facts(
        f"{endpoint}, running for {span(given['uptime_seconds'])}; Ctrl-C ends",
        [
            ("requests", f"{given['requests_per_second']:.4g} per second, {given['open_requests']:.0f} open"),
            ("solves", f"{given['solves_per_second']:.4g} per second, {given['solves_waiting']:.0f} waiting"),
            ("workers", f"{given['workers_busy']:.0f} of {given['workers']:.0f} busy"),
            ("builds", f"{given['builds_running']:.0f} running, {given['builds_waiting']:.0f} waiting"),
            ("sessions", f"{given['sessions']:.0f}, {size(given['session_bytes'])}"),
            ("tables", f"{given['tables']:.0f} in memory, {given['store_tables']:.0f} ({size(given['store_bytes'])}) in the store"),
            ("connections", f"{given['connections']:.0f}"),
            ("memory", f"{size(given['resident_bytes'])}, without builders"),
            ("processor", f"{100 * given['processors']:.0f} % of one"),
        ],
    )
    methods = listing(
        None, ["method", "a second", "mean time"],
        [(name, f"{rate['per_second']:.4g}", span(rate["mean_seconds"])) for name, rate in given["methods"].items()],
    )  # fmt: skip
    parts: list[Any] = [rates]
    if given["methods"]:
        parts += ["", methods]
    if jobs:
        parts += ["", shown_jobs(jobs)]
    return Stack(*parts)

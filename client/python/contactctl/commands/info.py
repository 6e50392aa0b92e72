"""Implements info and health, which show version and state of the daemon."""

from __future__ import annotations

import typer
from rich.console import RenderableType

from contactd import ServerInfo

from ..codes import Code
from ..common import Command, connected, setting
from ..output import emit, facts, listing, size, span

__all__ = ["add_to"]


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(info)
    app.command(cls=Command)(health)


def info() -> None:
    """Show versions, limits and counters of the daemon."""
    with connected() as client:
        given = client.info()
        emit(setting().json, given, *_shown(client.endpoint, given))


def health() -> None:
    """Show whether the daemon is serving, and its warnings.

    Exit codes: 0 if it is serving, 3 if it is stopping.
    """
    with connected() as client:
        given = client.call("server.health")
    emit(setting().json, given, str(given["state"]))
    if given["state"] != "serving":
        raise typer.Exit(Code.CONNECTION)


def _shown(endpoint: str, given: ServerInfo) -> list[RenderableType]:
    title = f"contactd {given.version} ({given.commit}) at {endpoint}"
    queue, cache, limits = given.queue, given.cache, given.limits
    return [
        facts(
            title,
            [
                ("running for", span(given.uptime_seconds)),
                ("solves", f"{queue['solves_running']} running, {queue['solves_waiting']} waiting"),
                ("builds", f"{queue['builds_running']} running, {queue['builds_waiting']} waiting"),
                ("tables in memory", f"{cache['tables']}, {size(cache['bytes'])} of {size(cache['budget_bytes'])}"),
                ("largest grid", f"{limits.max_grid_elements} elements"),
                ("largest message", size(limits.max_message_bytes)),
                ("longest queue", f"{limits.max_queue} requests, {limits.max_queue_per_client} of a client"),
                ("sessions", f"at most {limits.max_sessions}, {size(limits.max_session_bytes)} together"),
            ],
        ),
        "",
        listing("Since it started", ["counter", "count"], given.counters.items()),
        "",
        listing("Libraries", ["library", "version"], given.libraries.items()),
    ]

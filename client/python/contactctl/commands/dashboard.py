"""Implements dashboard, which shows the activity of the daemon in a browser."""

from __future__ import annotations

import ipaddress
from typing import Annotated

import click
import typer

from ..codes import Code, Ended
from ..common import Command, client_of, setting
from ..output import emit, note

__all__ = ["add_to"]


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(dashboard)


def dashboard(
    address: Annotated[str, typer.Option("--address", metavar="IP", help="Numeric address to listen on.")] = "127.0.0.1",
    port: Annotated[int, typer.Option("--port", "-p", min=0, max=65535, help="Port to listen on; 0: a free one.")] = 5580,
    interval: Annotated[float, typer.Option("--interval", "-i", min=0.2, max=3600, help="Seconds between updates.")] = 1.0,
    name: Annotated[list[str] | None, typer.Option("--name", metavar="NAME[:PORT]", help="Further address by which browsers reach it, for example through ssh -L or a proxy. Repeatable.")] = None,
) -> None:
    """Show the activity of the daemon in a browser, until Ctrl-C.

    It has jobs, the last solves, tables, sessions, latency and configuration. The command prints the address to open.
    """
    if setting().local:
        raise click.UsageError("dashboard shows a daemon, but --local has none; give its address with --endpoint.")
    is_loopback = _is_loopback(address)
    try:
        from ..dashboard.serving import serve
        from ..dashboard.watcher import Watcher
    except ModuleNotFoundError as error:
        if error.name is None or error.name.partition(".")[0] not in ("nicegui", "fastapi", "uvicorn", "matplotlib"):
            raise
        raise click.UsageError('dashboard needs NiceGUI and matplotlib: pip install "contactd[dashboard]".') from None
    if not is_loopback:
        note("warning: other machines can reach the dashboard. Its connections are not encrypted, and only its token restricts access.")
    with client_of(setting()) as client, Watcher(client, interval=interval) as watcher:
        try:
            serve(watcher, address, port, lambda link: emit(setting().json, {"address": link}, link), name or ())
        except OSError as error:
            raise Ended(Code.USAGE, f"{address} port {port}: {error.strerror or error}.") from None
        except SystemExit:  # raised by uvicorn
            raise Ended(Code.DEFECT, "NiceGUI has ended; see its messages above.") from None


def _is_loopback(address: str) -> bool:
    try:
        return ipaddress.ip_address(address).is_loopback
    except ValueError:
        raise click.UsageError(
            f"--address is {address!r}; it must be a numerical address of this machine, such as 127.0.0.1 or ::1."
        ) from None

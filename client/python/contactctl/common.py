"""Defines common options of all commands, before and after the name, and the client that they describe."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import click
from click.core import ParameterSource
from typer.core import TyperCommand, TyperGroup

import contactd
from contactd import Client, DaemonFailed, LocalDaemon
from contactd.refusals import did_you_mean
from contactd.transport.in_process import can_solve_here
from contactd.transport.programs import program_of

from .output import warned
from .reporting import reported

__all__ = ["Command", "Group", "Setting", "client_of", "connected", "is_local", "setting"]

DEFAULT_ENDPOINT = "tcp://127.0.0.1:5555"


def _of_environment(name: str) -> str | None:
    return os.environ.get(name) or None


@dataclass
class Setting:
    """Holds values of the common options; each may also be set by an environment variable."""

    endpoint: str | None = field(default_factory=lambda: _of_environment("CONTACTD_ENDPOINT"))
    local: bool = False
    folder: str | None = None
    server_key: str | None = field(default_factory=lambda: _of_environment("CONTACTD_SERVER_KEY"))
    own_key: str | None = field(default_factory=lambda: _of_environment("CONTACTD_OWN_KEY"))
    timeout: float | None = None
    json: bool = False
    overwrite: bool = False
    allow_folder: tuple[str, ...] = ()


def setting() -> Setting:
    """Returns the setting of the running command."""
    found: Setting = click.get_current_context().find_root().ensure_object(Setting)
    return found


def _keep(context: click.Context, parameter: click.Parameter, value: Any) -> None:
    """Stores the option, whether it precedes or follows the name."""
    assert parameter.name is not None
    if context.get_parameter_source(parameter.name) is not ParameterSource.DEFAULT:
        setattr(context.find_root().ensure_object(Setting), parameter.name, value)


def _options() -> list[click.Parameter]:
    def option(*names: str, **options: Any) -> click.Option:
        return click.Option(list(names), expose_value=False, callback=_keep, **options)

    seconds = click.FloatRange(min=0, min_open=True, max=86400)
    return [
        option("--endpoint", "-e", metavar="ENDPOINT",
               help="Address of the daemon, such as tcp://host:5555 or ipc:///path. Default: CONTACTD_ENDPOINT. Without either, commands "
               f"that solve need no daemon; all others use {DEFAULT_ENDPOINT}."),
        option("--local", is_flag=True, help="Ignore CONTACTD_ENDPOINT: solve in this process, or with a private daemon."),
        option("--folder", metavar="FOLDER", help="Without a daemon: folder for tables. By default they are deleted at the end."),
        option("--server-key", metavar="FILE", help="File with the daemon's public key. Default: CONTACTD_SERVER_KEY."),
        option("--own-key", metavar="FILE", help="File with your secret key. Default: CONTACTD_OWN_KEY."),
        option("--timeout", type=seconds, metavar="SECONDS", help="Timeout of each request. Default: 60 s, and an hour for builds."),
        option("--json", is_flag=True, help="Print JSON on standard output."),
        option("--allow-folder", metavar="FOLDER", multiple=True,
               help="Allow files to refer to files in this folder. By default only their own folder and below are allowed."),
        option("--overwrite", is_flag=True, help="Overwrite files that other programs have written."),
    ]  # fmt: skip


class _Helpful(click.Command):
    """Prints help unchanged; typer escapes brackets for rich, which is not used here."""

    def format_help(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        super().format_help(ctx, formatter)
        formatter.buffer = [piece.replace("\\[", "[") for piece in formatter.buffer]


class Command(_Helpful, TyperCommand):
    """Runs a command with the common options; errors become sentences and exit codes."""

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self.params.extend(_options())

    def invoke(self, ctx: click.Context) -> Any:
        with reported(), warned():
            return super().invoke(ctx)


class Group(_Helpful, TyperGroup):
    """Lists commands with the common options before their names."""

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self.params.extend(_options())

    def resolve_command(self, ctx: click.Context, args: list[str]) -> tuple[str | None, click.Command | None, list[str]]:
        """Suggests a similar command for an unknown name."""
        try:
            return super().resolve_command(ctx, args)
        except click.UsageError as error:
            if "did you mean" not in error.message.lower():
                error.message += did_you_mean(args[0], self.list_commands(ctx))
            raise


@contextmanager
def connected(*, workers: int | None = None, local_unless_named: bool = False) -> Iterator[Client]:
    """Returns the client for the options; `workers` is for a local one.

    Commands that solve are `local_unless_named`: they use a daemon only if an endpoint is set. All others need a
    daemon; the default is DEFAULT_ENDPOINT.
    """
    given = setting()
    if is_local(given, local_unless_named=local_unless_named):
        _check_keys(given)
        with _local(given, workers) as client:
            if given.timeout is not None:
                client.timeout = client.build_timeout = given.timeout
            yield client
        return
    if given.folder is not None:
        raise click.UsageError("--folder requires --local, because a daemon's configuration determines the folder of its tables.")
    with client_of(given) as client:
        yield client


def is_local(given: Setting, *, local_unless_named: bool = True) -> bool:
    """Returns whether these options need no daemon."""
    return given.local or (local_unless_named and given.endpoint is None)


def _check_keys(given: Setting) -> None:
    """Raises click.UsageError for keys on the command line without a daemon."""
    usual = Setting()
    if not given.local and (given.server_key, given.own_key) != (usual.server_key, usual.own_key):
        raise click.UsageError("--server-key and --own-key require a daemon: give its address with --endpoint.")


def client_of(given: Setting) -> Client:
    """Returns a client of a daemon."""
    times = {} if given.timeout is None else {"timeout": given.timeout, "build_timeout": given.timeout}
    try:
        return Client(given.endpoint or DEFAULT_ENDPOINT, server_key=given.server_key, own_key=given.own_key, **times)
    except (ValueError, TypeError) as error:
        raise click.UsageError(str(error)) from None


@contextmanager
def _local(given: Setting, workers: int | None) -> Iterator[Client]:
    config: dict[str, Any] = {} if workers is None else {"workers": workers}
    folder = None if given.folder is None else Path(given.folder)
    if can_solve_here():
        with contactd.local(folder=folder, config=config, in_process=True) as client:
            yield client
        return
    # No later use after the command ends.
    config["shutdown"] = {"drain_seconds": 0}
    with _private_daemon(folder, config) as daemon, daemon.client() as client:
        yield client


def _private_daemon(folder: Path | None, config: dict[str, Any]) -> LocalDaemon:
    if shutil.which(program_of("contactd")) is None:
        raise DaemonFailed(
            'No solver is installed. Install contactd_local with pip install "contactd[local]", put the program contactd ' "on PATH, or give the address of a running daemon with --endpoint."
        )
    return LocalDaemon(folder=folder, config=config)

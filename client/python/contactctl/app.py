"""Lists all commands, and runs a command."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

import click
import typer

from contactd import __version__
from contactd.files.text_lines import printable

from .codes import Code, code_of
from .commands import (
    bench,
    compare,
    completion,
    conform,
    contact,
    creep_tables,
    dashboard,
    fit,
    info,
    jobs,
    keys,
    profile,
    profiles,
    roughness,
    session,
    solve,
    study,
    tables,
    watch,
    wear,
    wheelrail,
)
from .common import Group
from .interrupts import heeded_signals
from .output import note
from .reporting import drop_output

__all__ = ["app", "run"]

app = typer.Typer(
    name="contactctl",
    cls=Group,
    add_completion=False,
    no_args_is_help=True,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)
for family in (
    info, tables, solve, wheelrail, profile, profiles, roughness, conform, contact, compare, fit, session, jobs, watch, bench, dashboard,
    keys, study, creep_tables, wear, completion,
):  # fmt: skip
    family.add_to(app)


def _say_version(requested: bool) -> None:
    if requested:
        typer.echo(f"contactctl {__version__}")
        raise typer.Exit


@app.callback()
def contactctl(
    version: Annotated[
        bool, typer.Option("--version", callback=_say_version, is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    """Solve elastic contact problems from a terminal, in this process or with the daemon contactd.

    Commands that solve use a daemon only if --endpoint or CONTACTD_ENDPOINT is set. All others show or change the state
    of a daemon. Files are JSON or YAML with the field names of the wire (docs/protocol.md).
    """


def run(arguments: Sequence[str] | None = None) -> int:
    """Runs the command in `arguments` and returns its exit code."""
    try:
        with heeded_signals():
            return _run(arguments)
    except KeyboardInterrupt as error:  # before the command begins, or while it ends
        return code_of(error)


def _run(arguments: Sequence[str] | None) -> int:
    try:
        command = typer.main.get_command(app)
        if (answered := completion.completed(command)) is not None:
            return answered
        ended = command.main(None if arguments is None else list(arguments), "contactctl", standalone_mode=False)
    except click.ClickException as error:
        error.message = printable(error.message)
        error.show()
        return Code.USAGE
    except click.Abort:
        return Code.INTERRUPTED
    except SystemExit:  # is click's, but its help is hidden
        drop_output()
        return Code.PIPE
    except OSError as error:  # of its help, too
        note(f"contactctl: {error.strerror or error}.")
        drop_output()
        return Code.DEFECT
    return ended if isinstance(ended, int) else Code.DONE


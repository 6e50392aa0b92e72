"""completion: what makes shells complete commands and options."""

from __future__ import annotations

import os
from enum import Enum
from typing import Annotated

import typer
from click import Command as ClickCommand
from click.shell_completion import get_completion_class, shell_complete

from ..common import Command

__all__ = ["add_to", "completed"]

_VARIABLE = "_CONTACTCTL_COMPLETE"  #: what the scripts set


class Shell(str, Enum):
    """Those that can be helped."""

    bash = "bash"
    zsh = "zsh"
    fish = "fish"


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(completion)


def completion(context: typer.Context, shell: Annotated[Shell, typer.Argument(help="Which one.")]) -> None:
    """Print what makes a shell complete commands and options.

    Put this into the start file of the shell: eval "$(contactctl completion bash)"
    """
    kind = get_completion_class(shell.value)
    assert kind is not None
    typer.echo(kind(context.find_root().command, {}, "contactctl", _VARIABLE).source())


def completed(command: ClickCommand) -> int | None:
    """The exit code after an answer to the script of a shell; None when none asks."""
    instruction = os.environ.get(_VARIABLE)
    return None if instruction is None else shell_complete(command, {}, "contactctl", _VARIABLE, instruction)

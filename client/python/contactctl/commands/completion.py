"""Implements completion, which completes commands and options in shells."""

from __future__ import annotations

import os
from enum import Enum
from typing import Annotated

import typer
from click import Command as ClickCommand
from click.shell_completion import get_completion_class, shell_complete

from ..common import Command

__all__ = ["add_to", "completed"]

_VARIABLE = "_CONTACTCTL_COMPLETE"  #: Variable set by the scripts.


class Shell(str, Enum):
    """Supported shells."""

    bash = "bash"
    zsh = "zsh"
    fish = "fish"


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(completion)


def completion(context: typer.Context, shell: Annotated[Shell, typer.Argument(help="The shell.")]) -> None:
    """Print a script that completes commands and options in a shell.

    Add this line to the start file of your shell: eval "$(contactctl completion bash)"
    """
    kind = get_completion_class(shell.value)
    assert kind is not None
    typer.echo(kind(context.find_root().command, {}, "contactctl", _VARIABLE).source())


def completed(command: ClickCommand) -> int | None:
    """Answers a completion request of a shell and returns the exit code; None if there is no request."""
    instruction = os.environ.get(_VARIABLE)
    return None if instruction is None else shell_complete(command, {}, "contactctl", _VARIABLE, instruction)

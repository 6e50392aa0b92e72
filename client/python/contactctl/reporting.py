"""Converts errors to sentences on standard error and exit codes."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import click

from contactd import ContactdError, StatusError, TableFileError

from .codes import Code, Ended, code_of
from .interrupts import ignore_more
from .output import note

__all__ = ["drop_output", "reported", "sentence"]


@contextmanager
def reported() -> Iterator[None]:
    """Prints an error in the block, and ends the command with its exit code."""
    try:
        yield
        sys.stdout.flush()
    except (click.ClickException, click.exceptions.Exit):
        raise
    except BrokenPipeError:
        drop_output()
        raise click.exceptions.Exit(Code.PIPE) from None
    except KeyboardInterrupt as error:
        ignore_more()
        raise click.exceptions.Exit(code_of(error)) from None
    except Ended as error:
        note(f"contactctl: {error}")
        raise click.exceptions.Exit(error.code) from None
    except TableFileError as error:
        raise click.UsageError(str(error)) from None
    except ContactdError as error:
        note(f"contactctl: {sentence(error)}")
        raise click.exceptions.Exit(code_of(error)) from None
    except OSError as error:
        where = f"{error.filename}: " if error.filename else ""
        note(f"contactctl: {where}{error.strerror or error}.")
        if not where:  # The output cannot be written.
            drop_output()
        raise click.exceptions.Exit(code_of(error)) from None


def drop_output() -> None:
    """Discards pending output, so that Python does not try to write it at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def sentence(error: ContactdError) -> str:
    """Returns the error as a sentence, with each invalid field of the request."""
    if not isinstance(error, StatusError):
        return str(error)
    text = error.message.rstrip()
    lines = []
    if len(error.violations) > 1:  # The message already lists them.
        text = f"{len(error.violations)} fields of the request cannot be used."
        lines = [f"  {violation.field}: {violation.description}" for violation in error.violations]
    words = f"{error.name}, {error.reason}" if error.reason else error.name
    head = f"{text if text.endswith(('.', '!', '?')) else text + '.'} ({words})"
    if error.retry_delay:
        lines.append(f"  Try again in {error.retry_delay:g} s.")
    return "\n".join([head, *lines])

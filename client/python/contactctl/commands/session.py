"""Implements session, which replays a recorded history step by step."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any

import click
import typer

from contactd import Client, ContactdError, ContactWarning
from contactd.calls.answer_warnings import sentences_in
from contactd.files.number_text import table_of
from contactd.files.whole import read_whole
from contactd.refusals import did_you_mean

from ..asking import ask
from ..common import Command, connected, setting
from ..files import named_file, read_object
from ..output import emit, listing, warn
from ..paths import changed, put
from ..progress import Bar
from .solve import Set, contact_rows

__all__ = ["add_to"]

_MOST_BYTES = 1 << 26  #: Largest number of steps in a file.


def add_to(app: typer.Typer) -> None:
    """Adds the commands of this family."""
    app.command(cls=Command)(session)


def session(
    file: Annotated[str, typer.Argument(help="JSON or YAML: open (parameters of session.open) and steps (of session.step); - reads standard input.")],
    sets: Set = None,
    accept: Annotated[bool, typer.Option("--accept-unconverged", help="Continue after a step that missed a tolerance.")] = False,
) -> None:
    """Replay the steps of a history, with one line per step. Exit code 5: a step did not converge.

    `steps` is a list, or the name of a CSV file whose columns are paths, such as Fn and friction.rolling.xi.
    """
    history = changed(read_object(file), sets or ())
    opening, steps = _opening(file, history), _steps(file, history)
    if accept:
        opening["accept_unconverged"] = True
    answers: list[dict[str, Any]] = []
    # Solved steps are shown however the session ends.
    with connected(local_unless_named=True) as client, _opened(client, opening) as name, Bar("stepping") as bar:
        try:
            for number, step in enumerate(steps, 1):
                bar.show((number - 1) / len(steps), f"step {number} of {len(steps)}")
                params = {"fields": [], **step, "session": name, "step": number}
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore", ContactWarning)  # printed below the steps, with their numbers
                    answers.append(client.call("session.step", params))
        except BaseException:
            _show(answers)
            raise
    _show(answers)


def _show(answers: list[dict[str, Any]]) -> None:
    columns = ["step", "Fn (N)", "Fx (N)", "Fy (N)", "Mz (N mm)", "approach (mm)", "pmax (N/mm^2)", "adhesion", "slip", "converged"]
    rows = []
    for answer in answers:
        given = dict(contact_rows(answer))
        found = [given.get(name) for name in columns[1:7]]
        counts = [answer["elements"][name] for name in ("adhesion", "slip")]
        rows.append((answer["step"], *found, *counts, bool(answer["converged"])))
    emit(setting().json, {"steps": answers}, listing(None, columns, rows))
    warn(f"step {answer['step']}: {sentence}" for answer in answers for sentence in sentences_in("session.step", answer))


@contextmanager
def _opened(client: Client, opening: dict[str, Any]) -> Iterator[str]:
    """Yields the name of a session, which ends with the block."""
    name = str(ask(client, "session.open", opening, "opening")["session"])
    try:
        yield name
    finally:
        try:
            client.call("session.close", {"session": name})
        except ContactdError:
            pass  # its lease ends it


def _opening(file: str, history: dict[str, Any]) -> dict[str, Any]:
    if unknown := history.keys() - {"open", "steps"}:
        raise click.UsageError(f"{file} has {min(unknown)!r}; a history has open and steps.{did_you_mean(min(unknown), ('open', 'steps'))}")
    opening = history.get("open")
    if not isinstance(opening, dict):
        raise click.UsageError(f"{file} lacks open, the parameters of session.open: grid, bodies, ics, gap, friction.")
    return opening


def _steps(file: str, history: dict[str, Any]) -> list[dict[str, Any]]:
    steps = history.get("steps")
    if isinstance(steps, str):
        steps = _steps_of_csv(named_file(steps, file))
    if not isinstance(steps, list) or not steps:
        raise click.UsageError(f"{file} lacks steps, a list with the input of each step, or the name of a CSV file.")
    for number, step in enumerate(steps, 1):
        if not isinstance(step, dict) or step.keys() & {"session", "step", "again"}:
            raise click.UsageError(f"{file}: step {number} must be an object such as {{Fn: 1000}}, without session, step and again.")
    return steps


def _steps_of_csv(path: Path) -> list[dict[str, Any]]:
    try:
        names, rows = table_of(read_whole(path, _MOST_BYTES).decode("utf-8-sig"))
    except OSError as error:
        raise click.UsageError(f"{path} cannot be read: {error.strerror}.") from None
    except UnicodeDecodeError:
        raise click.UsageError(f"{path} is not text in UTF-8.") from None
    except ValueError as error:
        raise click.UsageError(f"{path} is not a CSV file: {error}.") from None
    steps = []
    for number, (_, cells) in enumerate(rows, 1):
        step: dict[str, Any] = {}
        for column, text in zip(names, cells, strict=True):
            if text:
                put(step, column, _number(path, number, column, text))
        steps.append(step)
    return steps


def _number(path: Path, number: int, column: str, text: str) -> float | int:
    try:
        found = int(text) if text.strip().lstrip("+-").isdigit() else float(text)
    except ValueError:
        raise click.UsageError(f"{path}: step {number} has {column} = {text[:40]!r}, which is not a number.") from None
    if isinstance(found, float) and not math.isfinite(found):
        raise click.UsageError(f"{path}: step {number} has {column} = {text[:40]!r}; it must be finite.")
    return found

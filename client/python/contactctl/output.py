"""Prints output of commands: tables or JSON on standard output, everything else on standard error."""

from __future__ import annotations

import json
import math
import sys
import warnings
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import fields, is_dataclass
from threading import Lock
from typing import Any, NoReturn

import numpy as np
from rich import box
from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from contactd import ContactWarning
from contactd.files.text_lines import printable

__all__ = [
    "above_rounding", "console", "counted", "emit", "facts", "listing", "note", "number", "on_terminal", "plain_json", "size",
    "span", "warn", "warn_of", "warned",
]  # fmt: skip

_MOST_WARNINGS = 20  # largest number of warnings of a command
_MOST_NAMED = 5  # largest number of cases, rows or steps named in a sentence
_MOST_KEPT = 1000
_OTHERS = "other sentences"
_UNBOUNDED = 10_000  # columns without a terminal, so that nothing is truncated in a pipe


class _Console(Console):
    def on_broken_pipe(self) -> NoReturn:
        raise BrokenPipeError


def on_terminal(stream: Any) -> bool:
    """Returns whether the stream is a terminal."""
    return bool(stream.isatty())


def console(*, stderr: bool = False, is_bounded: bool = True) -> Console:
    """Returns the console for printing. Colours are used only in a terminal without NO_COLOR. `is_bounded` limits the
    width.
    """
    stream = sys.stderr if stderr else sys.stdout
    width = None if is_bounded and on_terminal(stream) else _UNBOUNDED
    return _Console(file=stream, width=width, highlight=False, markup=False, emoji=False, legacy_windows=False)


def note(text: str) -> None:
    """Prints a sentence on standard error."""
    console(stderr=True).print(printable(text), soft_wrap=True)


def warn(sentences: Iterable[str]) -> None:
    """Prints warnings, each once."""
    for sentence in dict.fromkeys(sentences):
        note(f"warning: {sentence}")


def warn_of(noun: str, warnings: Iterable[tuple[str, str]]) -> None:
    """Prints warnings of cases, rows or steps (`noun`), given as names and sentences: each sentence once, with its
    names.
    """
    found: dict[str, dict[str, None]] = {}
    for name, sentence in warnings:
        found.setdefault(sentence, {})[name] = None
    given = [f"{_named(noun, list(names))}: {sentence}" for sentence, names in found.items()]
    warn(given[:_MOST_WARNINGS])
    if len(given) > _MOST_WARNINGS:
        note(f"and {len(given) - _MOST_WARNINGS} other warnings.")


def _named(noun: str, names: list[str]) -> str:
    if len(names) == 1:
        return f"{noun} {names[0]}"
    if len(names) > _MOST_NAMED:
        return f"{noun}s {', '.join(names[:_MOST_NAMED])} and {len(names) - _MOST_NAMED} more"
    return f"{noun}s {', '.join(names[:-1])} and {names[-1]}"


@contextmanager
def warned() -> Iterator[None]:
    """Prints the warnings of answers in the block at its end, with the number of answers for each."""
    counts: Counter[str] = Counter()
    lock = Lock()

    def keep(message: Warning | str, *where: Any, **more: Any) -> None:
        if not isinstance(message, ContactWarning):
            return shown(message, *where, **more)
        with lock:
            known = len(counts) < _MOST_KEPT
            counts.update(sentence if known or sentence in counts else _OTHERS for sentence in message.sentences)

    with warnings.catch_warnings():
        shown = warnings.showwarning
        warnings.showwarning = keep
        warnings.simplefilter("always", ContactWarning)
        try:
            yield
        finally:
            with lock:
                given = [sentence if count == 1 else f"{sentence} ({count} answers)" for sentence, count in counts.items()]
            warn(given[:_MOST_WARNINGS])
            if len(given) > _MOST_WARNINGS:
                note(f"and {len(given) - _MOST_WARNINGS} other warnings.")


def emit(as_json: bool, value: Any, *shown: RenderableType) -> None:
    """Prints `value` as one line of JSON, or `shown`."""
    if as_json:
        sys.stdout.write(json.dumps(plain_json(value), allow_nan=False) + "\n")
    else:
        _print(shown)
    sys.stdout.flush()


def _print(shown: Iterable[RenderableType]) -> None:
    # In a narrow terminal, wrapped lines are more readable than broken numbers.
    page = console(is_bounded=False)
    if on_terminal(sys.stdout):
        for part in shown:
            page.print(part)
        return
    with page.capture() as captured:
        for part in shown:
            page.print(part)
    # Removes trailing blanks of columns.
    sys.stdout.writelines(f"{line.rstrip()}\n" for line in captured.get().splitlines())


def plain_json(value: Any) -> Any:
    """Returns `value` for JSON: arrays as lists, classes as objects without None, and no numbers that are not
    finite.
    """
    if isinstance(value, np.ndarray):
        return plain_json(value.tolist())
    if isinstance(value, np.generic):
        return plain_json(value.item())
    if is_dataclass(value) and not isinstance(value, type):
        members = ((field.name, getattr(value, field.name)) for field in fields(value))
        return {name: plain_json(member) for name, member in members if member is not None}
    if isinstance(value, Mapping):
        return {str(name): plain_json(member) for name, member in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain_json(member) for member in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def number(value: Any) -> str:
    """Returns six digits of a number, "yes" or "NO", or a dash for a missing value."""
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "NO"
    if isinstance(value, float):
        return f"{value + 0.0:.6g}"  # no negative zero
    return printable(str(value))


def above_rounding(value: float, scale: float) -> float:
    """Returns `value`, or 0 if it is a rounding error of numbers as large as `scale`."""
    return value if abs(value) > 1e-12 * abs(scale) else 0.0


def counted(count: int, noun: str) -> str:
    """Returns a count with a noun, such as "1 table" or "2 tables"."""
    return f"{count} {noun}{'' if count == 1 else 's'}"


def size(count: float) -> str:
    """Returns bytes in a unit with one to three digits before the point."""
    for unit in ("bytes", "kB", "MB", "GB", "TB"):
        if abs(count) < 1000 or unit == "TB":
            return f"{count:.0f} {unit}" if unit == "bytes" else f"{count:.3g} {unit}"
        count /= 1000
    raise AssertionError


def span(seconds: float) -> str:
    """Returns a time in a suitable unit."""
    if seconds < 1:
        return f"{1000 * seconds:.3g} ms"
    if seconds < 120:
        return f"{seconds:.3g} s"
    minutes = seconds / 60
    return f"{minutes:.0f} min" if minutes < 120 else f"{minutes / 60:.1f} h"


def facts(title: str, rows: Iterable[tuple[str, Any]]) -> RenderableType:
    """Returns a table of names and values; rows of None are omitted."""
    table = Table(show_header=False, box=None, padding=(0, 3, 0, 0))
    table.add_column(style="cyan", no_wrap=True)
    table.add_column(overflow="fold")
    for name, value in rows:
        if value is not None:
            table.add_row(name, number(value))
    return _titled(title, table)


def listing(title: str | None, columns: Sequence[str], rows: Iterable[Sequence[Any]]) -> RenderableType:
    """Returns a table with one line per row; numbers are right-aligned."""
    found = [[*row] for row in rows]
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False)
    for index, name in enumerate(columns):
        cells = [row[index] for row in found if row[index] is not None]
        right = bool(cells) and all(isinstance(cell, (int, float)) and not isinstance(cell, bool) for cell in cells)
        table.add_column(name, justify="right" if right else "left", overflow="fold")
    for row in found:
        table.add_row(*(number(cell) for cell in row))
    return table if title is None else _titled(title, table)


def _titled(title: str, table: Table) -> RenderableType:
    """Puts the title above the table, because its columns may be narrower."""
    return Group(Text(title, style="bold"), table)

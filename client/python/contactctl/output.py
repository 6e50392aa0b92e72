"""Output of commands: tables for people or JSON for scripts on standard output, all else on standard error."""

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

_MOST_WARNINGS = 20  # that are said of a command
_MOST_NAMED = 5  # cases, rows or steps that a sentence is of
_MOST_KEPT = 1000
_OTHERS = "other sentences"
_UNBOUNDED = 10_000  # columns where there is no terminal: nothing is cut off in a pipe


class _Console(Console):
    def on_broken_pipe(self) -> NoReturn:
        raise BrokenPipeError


def on_terminal(stream: Any) -> bool:
    """Whether a person is likely to read what is written there."""
    return bool(stream.isatty())


def console(*, stderr: bool = False, is_bounded: bool = True) -> Console:
    """Where to print; colours on a terminal only, and there not against NO_COLOR. `is_bounded` by its width."""
    stream = sys.stderr if stderr else sys.stdout
    width = None if is_bounded and on_terminal(stream) else _UNBOUNDED
    return _Console(file=stream, width=width, highlight=False, markup=False, emoji=False, legacy_windows=False)


def note(text: str) -> None:
    """A sentence on standard error."""
    console(stderr=True).print(printable(text), soft_wrap=True)


def warn(sentences: Iterable[str]) -> None:
    """Warnings, each once."""
    for sentence in dict.fromkeys(sentences):
        note(f"warning: {sentence}")


def warn_of(noun: str, warnings: Iterable[tuple[str, str]]) -> None:
    """Warnings of cases, rows or steps, as the `noun` says: names and sentences, each sentence once with the names it is of."""
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
    """Says what answers warn of inside at its end, with how many of them do."""
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
    """`value` as one line of JSON, or what is `shown` of it."""
    if as_json:
        sys.stdout.write(json.dumps(plain_json(value), allow_nan=False) + "\n")
    else:
        _print(shown)
    sys.stdout.flush()


def _print(shown: Iterable[RenderableType]) -> None:
    # A terminal that is too narrow breaks lines, which reads better than numbers in pieces.
    page = console(is_bounded=False)
    if on_terminal(sys.stdout):
        for part in shown:
            page.print(part)
        return
    with page.capture() as captured:
        for part in shown:
            page.print(part)
    # Columns are filled up with blanks, which nobody needs in a file.
    sys.stdout.writelines(f"{line.rstrip()}\n" for line in captured.get().splitlines())


def plain_json(value: Any) -> Any:
    """`value` as what JSON has: arrays as lists, classes as objects without what is None, no numbers that are not finite."""
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
    """Six digits of a number, "yes" or "NO", a dash for what is not there."""
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "NO"
    if isinstance(value, float):
        return f"{value + 0.0:.6g}"  # no minus before a zero
    return printable(str(value))


def above_rounding(value: float, scale: float) -> float:
    """`value`, or 0 where it is what rounding leaves of numbers as large as `scale`."""
    return value if abs(value) > 1e-12 * abs(scale) else 0.0


def counted(count: int, noun: str) -> str:
    """Counts things, as in "1 table", "2 tables"."""
    return f"{count} {noun}{'' if count == 1 else 's'}"


def size(count: float) -> str:
    """Bytes in the unit that leaves one to three digits before the point."""
    for unit in ("bytes", "kB", "MB", "GB", "TB"):
        if abs(count) < 1000 or unit == "TB":
            return f"{count:.0f} {unit}" if unit == "bytes" else f"{count:.3g} {unit}"
        count /= 1000
    raise AssertionError


def span(seconds: float) -> str:
    """A time in the unit that suits it."""
    if seconds < 1:
        return f"{1000 * seconds:.3g} ms"
    if seconds < 120:
        return f"{seconds:.3g} s"
    minutes = seconds / 60
    return f"{minutes:.0f} min" if minutes < 120 else f"{minutes / 60:.1f} h"


def facts(title: str, rows: Iterable[tuple[str, Any]]) -> RenderableType:
    """Names and values of one thing; rows of None are left out."""
    table = Table(show_header=False, box=None, padding=(0, 3, 0, 0))
    table.add_column(style="cyan", no_wrap=True)
    table.add_column(overflow="fold")
    for name, value in rows:
        if value is not None:
            table.add_row(name, number(value))
    return _titled(title, table)


def listing(title: str | None, columns: Sequence[str], rows: Iterable[Sequence[Any]]) -> RenderableType:
    """A line each; numbers to the right."""
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
    """Above, and not in the table, whose columns may be narrower."""
    return Group(Text(title, style="bold"), table)

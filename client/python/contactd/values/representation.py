"""Representations of values: a line in a terminal, a small table in a notebook."""

from __future__ import annotations

import html
import inspect
from collections.abc import Sequence
from typing import Any, TypeVar

__all__ = ["ProgressText", "Rows", "Shown", "number", "with_inherited_attributes"]

Rows = list[tuple[str, object]]
Kind = TypeVar("Kind", bound=type)


def number(value: object) -> str:
    """Returns a float with six digits; other values unchanged."""
    return f"{value:.6g}" if isinstance(value, float) else str(value)


class Shown:
    """Represents a value with a representation: `_title` is its type, `_rows` are names and values."""

    def _title(self) -> str:
        return type(self).__name__

    def _rows(self) -> Rows:
        raise NotImplementedError

    def _remarks(self) -> Sequence[str]:
        """Returns sentences: their number for a line, their text for a table."""
        return ()

    def __repr__(self) -> str:
        parts = [f"{name} {number(value)}" for name, value in self._rows()]
        if remarks := self._remarks():
            parts.append(f"{len(remarks)} warning{'s' if len(remarks) > 1 else ''}")
        return f"<{self._title()}: {', '.join(parts)}>"

    def _repr_html_(self) -> str:
        rows = [(name, number(value)) for name, value in self._rows()]
        rows += [("warning", remark) for remark in self._remarks()]
        cells = (f"<tr><th>{html.escape(name)}</th><td>{html.escape(value)}</td></tr>" for name, value in rows)
        return f"<table><caption>{html.escape(self._title())}</caption>{''.join(cells)}</table>"


def with_inherited_attributes(kind: Kind) -> Kind:
    """Adds the attributes in the base's docstring to that of a class, for help()."""
    own, inherited = kind.__doc__, kind.__mro__[1].__doc__
    if own is None or inherited is None:  # python -OO
        return kind
    own, heading = inspect.cleandoc(own), "Attributes:"
    if heading not in own:
        own = f"{own}\n\n{heading}"
    kind.__doc__ = own + inspect.cleandoc(inherited).partition(heading)[2]
    return kind


class ProgressText:
    """Methods of a Progress."""

    def __str__(self: Any) -> str:
        if self.state:
            return f"the daemon is {self.state}"
        parts = [f"{self.stage} {100 * self.fraction:.0f} %"]
        if self.iteration:
            parts.append(f"iteration {self.iteration}, residual {self.residual:.1e}")
        if self.seconds_left is not None:
            parts.append(f"about {_duration(self.seconds_left)} to go")
        if self.memory_bytes is not None:
            parts.append(f"about {_size(self.memory_bytes)} of memory")
        return ", ".join(parts)


def _duration(seconds: float) -> str:
    whole = round(seconds)
    if whole < 120:
        return f"{whole} s"
    return f"{whole // 60} min" if whole < 7200 else f"{whole / 3600:.1f} h"


def _size(count: float) -> str:
    for unit in ("kB", "MB"):
        count /= 1000
        if count < 1000:
            return f"{count:.0f} {unit}"
    return f"{count / 1000:.1f} GB"

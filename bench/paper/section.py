"""Defines the parts of a section of the paper that are needed to repeat its computations."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

from .finding import Found, Rows
from .rows import Row

#: A request as plain data. Equal requests are one computation.
Spec = dict[str, Any]
#: The stored result of a computation. If it did not converge, it is {"failure": text}.
Result = dict[str, Any]
Measure = Callable[[Spec], Result]


class Case(Protocol):
    """Describes a request and the place of its result in a figure."""

    @property
    def part(self) -> str: ...
    @property
    def curve(self) -> str: ...
    @property
    def parameter(self) -> str: ...
    @property
    def value(self) -> float: ...
    @property
    def spec(self) -> Spec: ...


class ComputationFailed(Exception):
    """Raised when a computation ends with an error, which the message contains."""


@dataclass(frozen=True)
class Table:
    """Describes a CSV file in addition to that of its part."""

    name: str
    columns: Sequence[str]
    make: Callable[[Sequence[Row]], Sequence[Row]]


@dataclass(frozen=True)
class Section:
    """Describes a section of the paper. Parts are named after their CSV files. The page is <name>.md, and finished
    computations are in <name>.jsonl."""

    name: str
    number: int | None  #: those of the paper's section only
    parts: Mapping[str, Callable[[], Sequence[Any]]]  #: cases of each part, in computation order
    columns: Sequence[str]
    row: Callable[[Any, Result], Row]  #: of a case and its result, which is not a failure
    pictures: Mapping[str, Callable[[Sequence[Row], Path], None]]  #: parts without a picture are tables
    find: Callable[[Rows], Found]  #: numbers and verdicts of the page
    efforts: Callable[[Sequence[Spec]], Sequence[float]]  #: estimated CPU seconds, for the remaining time
    summary: Callable[[Result], str]  #: one line of progress
    solver: Callable[[Path], AbstractContextManager[Measure]]  #: identifies the program in the folder
    tables: Mapping[str, Table] = field(default_factory=dict)  #: by part
    part_columns: Mapping[str, Sequence[str]] = field(default_factory=dict)  #: of parts with other columns

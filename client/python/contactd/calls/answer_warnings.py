"""Gives the warnings of answers as Python warnings."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any

from ..refusals import package_of

__all__ = ["ContactWarning", "collected", "give", "sentences_in"]

#: Methods that list the store without using its tables.
_LISTS = ("ic.list", "ic.import")
#: Places of further `warnings` in answers, and the name of that part in the request ("" for the whole).
_PARTS = {"result": "", "evidence": "", "ics": "", "upper": "", "lower": "", "pair": "", "wheelrail": "", "solution": "",
          "solutions": "problems", "steps": "steps", "geometries": "states", "left": "left", "right": "right",
          "patches": "patches", "profiles": "profiles", "wheel_evidence": "wheel", "rail_evidence": "rail",
          "cases": "cases", "contact": ""}  # fmt: skip
_MOST_PARTS = 5  #: Maximum number of named parts with the same sentence.
_COLLECTED: ContextVar[list[str] | None] = ContextVar("collected", default=None)


class ContactWarning(UserWarning):
    """Represents the `warnings` of an answer: complete sentences about its limitations, joined to one message.

    Each answer gives at most one warning, located at the caller's line. Filters of Python's `warnings` can silence it
    or turn it into an exception. The exception is raised after the call: the session has then already advanced by the
    step.

    Attributes:
        sentences: The sentences. For a call with several problems, steps or patches, each begins with its part, such as
            ``problems[3]:``.
    """

    @property
    def sentences(self) -> tuple[str, ...]:
        return self.args

    def __str__(self) -> str:
        return " ".join(self.args)


def sentences_in(method: str, answer: dict[str, Any]) -> tuple[str, ...]:
    """Returns all warnings of the answer to `method`, each sentence once."""
    found: dict[str, list[str]] = {}
    if method not in _LISTS:
        _collect(answer, "", found)
    for sentence, parts in list(found.items()):
        _, *ends = sentence.split(": ")
        for first in range(len(ends)):
            if (same := found.get(": ".join(ends[first:]))) is not None:
                same[:] = [part for part in same if not any(_is_in(part, whole) for whole in parts)]
    return tuple(_of_parts(parts, sentence) for sentence, parts in found.items() if parts)


def _is_in(part: str, whole: str) -> bool:
    """Returns whether the other sentence is the same with a place in front of it, "The contact at y = 750 mm: ..."."""
    return part != whole and (whole == "" or part.startswith((f"{whole}.", f"{whole}[")))


def _collect(value: Any, part: str, found: dict[str, list[str]]) -> None:
    if isinstance(value, list):
        for index, item in enumerate(value):
            _collect(item, f"{part}[{index}]", found)
    elif isinstance(value, dict):
        given = value.get("warnings")
        for sentence in given if isinstance(given, list) else ():
            parts = found.setdefault(str(sentence), [])
            if part not in parts:
                parts.append(part)
        for name, shown in _PARTS.items():
            if name in value:
                _collect(value[name], ".".join(filter(None, (part, shown))), found)


def _of_parts(parts: list[str], sentence: str) -> str:
    if "" in parts:
        return sentence
    more = f" and {len(parts) - _MOST_PARTS} more" if len(parts) > _MOST_PARTS else ""
    return f"{', '.join(parts[:_MOST_PARTS])}{more}: {sentence}"


@contextmanager
def collected() -> Iterator[list[str]]:
    """Collects the warnings of answers in this thread inside the block, each sentence once. They are not given as
    Python warnings: the caller adds the case, row or state.
    """
    found: list[str] = []
    token = _COLLECTED.set(found)
    try:
        yield found
    finally:
        _COLLECTED.reset(token)


def give(sentences: Iterable[str]) -> None:
    """Gives the sentences as a warning at the line that called this package, unless they are collected."""
    given = tuple(dict.fromkeys(sentences))
    if (found := _COLLECTED.get()) is not None:
        found.extend(sentence for sentence in given if sentence not in found)
    elif given:
        warnings.warn(ContactWarning(*given), stacklevel=_level_of_caller())


def _level_of_caller() -> int:
    """Returns the stack level for warnings.warn in `give`."""
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and package_of(frame) == "contactd":
        frame, level = frame.f_back, level + 1
    return level

"""Converts cases to a Python program that solves them with contactd."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields
from typing import Any

import numpy as np

from ..files.marks import written_by
from ..files.text_lines import one_line
from ..values.generated.contact_files import ConvertedCase
from ..values.generated.problem import Estimate

__all__ = ["python_text"]

_HEAD = '''\
{title}
# {mark}

import numpy as np

import contactd

STATE = ({state})

with contactd.local() as client:
    last = {{}}'''
_OF_ROW = 8  #: Numbers of an array per line.
_LONGEST_LINE = 100


def python_text(title: str, cases: Iterable[ConvertedCase]) -> str:
    """Returns a program with the parameters of each case; a case without parameters is a comment with the reason."""
    state = ", ".join(f'"{one.name}"' for one in fields(Estimate))
    lines = [_HEAD.format(title=ascii(title), mark=written_by().capitalize(), state=state)]
    for case in cases:
        lines += ["", *_case(case)]
    return "\n".join([*lines, ""])


def _case(case: ConvertedCase) -> Iterator[str]:
    params = case.wheelrail if case.contact is None else case.contact
    yield f"    # Case {case.number}, line {case.line}."
    if params is None:
        yield f"    # {one_line(f'{case.status}: {case.sentence}')}"
        yield "    last = {}"
        return
    yield f"    params = {_written(params, 4)}"
    if case.contact is None:
        yield '    solution = client.call("wheelrail.solve", params)'
        yield f'    print("case", {case.number}, solution["z"], solution["forces"]["track"])'
        return
    if case.continues:
        yield '    params["previous"] = {name: last[name] for name in STATE if name in last}'
    yield '    last = client.call("contact.solve", params)'
    yield f'    print("case", {case.number}, last["forces"], last["approach"], last["pmax"])'


def _written(value: Any, indent: int) -> str:
    """Returns a value as a Python expression, also for unusual names of files."""
    if isinstance(value, np.ndarray):
        return _array(value, indent)
    if isinstance(value, (Mapping, list, tuple)):
        begin, end = ("{", "}") if isinstance(value, Mapping) else ("[", "]")
        names = [f"{name!a}: " for name in value] if isinstance(value, Mapping) else [""] * len(value)
        members = value.values() if isinstance(value, Mapping) else value
        parts = [f"{name}{_written(member, indent + 4)}" for name, member in zip(names, members)]
        if sum(map(len, parts)) <= _LONGEST_LINE:
            return f"{begin}{', '.join(parts)}{end}"
        blank = " " * (indent + 4)
        return "\n".join([begin, *(f"{blank}{part}," for part in parts), " " * indent + end])
    if isinstance(value, float) and not math.isfinite(value):
        return f'float("{value!r}")'
    if value is None or isinstance(value, (bool, int, float, str, bytes)):
        return ascii(value)
    raise TypeError(f"a {type(value).__name__} is not a value of a case")


def _array(array: np.ndarray[Any, Any], indent: int) -> str:
    numbers = [_written(number, 0) for number in array.ravel().tolist()]
    blank = " " * (indent + 4)
    rows = [f"{blank}{', '.join(numbers[start : start + _OF_ROW])}," for start in range(0, len(numbers), _OF_ROW)]
    return "\n".join(["np.array([", *rows, f"{' ' * indent}]).reshape({array.shape})"])

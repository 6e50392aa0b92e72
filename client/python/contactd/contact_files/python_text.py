"""Converts cases to a Python program that solves them with contactd."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import MISSING, fields, is_dataclass
from typing import Any

import numpy as np

from ..files.marks import written_by
from ..files.text_lines import one_line
from .problems.basic import BasicContact
from .problems.rails import RailContact

__all__ = ["python_text"]

_HEAD = '''\
{title}
# {mark}

import numpy as np

import contactd
from contactd import *
from contactd.wheel_rail import *

'''
_OF_ROW = 8  #: Numbers of an array per line.


def python_text(title: str, contacts: Iterable[BasicContact | RailContact | str], goes_on: Iterable[bool]) -> str:
    """`contacts` are prepared cases, or sentences with the reason why they are not; `goes_on` marks those that continue
    the previous case.
    """
    lines = [_HEAD.format(title=ascii(title), mark=written_by().capitalize()), "with contactd.local() as client:\n    last = None"]
    for contact, follows in zip(contacts, goes_on):
        lines += ["", *_case(contact, follows)]
    return "\n".join([*lines, ""])


def _case(contact: BasicContact | RailContact | str, follows: bool) -> Iterator[str]:
    if isinstance(contact, str):
        yield f"    # {one_line(contact)}"
        yield "    last = None"
        return
    case = contact.case
    yield f"    # Case {case.number}, line {case.line}."
    if isinstance(contact, RailContact):
        yield f"    setup = {_written(contact.setup, 4)}"
        yield f"    state = {_written(contact.state, 4)}"
        yield "    solution = client.wheel_rail(setup, state)"
        yield f'    print("case", {case.number}, solution.z, solution.forces.track)'
        return
    yield f"    problem = {_written(contact.problem, 4)}"
    if follows:
        yield "    problem = problem.replace(previous=last)"
    yield "    last = client.solve(problem)"
    yield f'    print("case", {case.number}, last.Fn, last.Fx, last.Fy, last.Mz, last.approach, last.pmax)'


def _written(value: Any, indent: int) -> str:
    if isinstance(value, np.ndarray):
        return _array(value, indent)
    if is_dataclass(value) and not isinstance(value, type):
        return _call(value, indent)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{key!r}: {_written(member, indent)}" for key, member in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        inside = ", ".join(_written(member, indent) for member in value)
        return f"[{inside}]" if isinstance(value, list) else f"({inside}{',' if len(value) == 1 else ''})"
    return _plain(value.item() if isinstance(value, np.generic) else value)


def _plain(value: Any) -> str:
    """Returns a number, text or boolean as a Python expression, also for unusual names of files."""
    if isinstance(value, float) and not math.isfinite(value):
        return f'float("{value!r}")'
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, (str, bytes)):
        return ascii(value)
    if value is None or isinstance(value, (bool, int, float)):
        return repr(value)
    raise TypeError(f"a {type(value).__name__} is not a value of a case")


def _call(value: Any, indent: int) -> str:
    given = [(one.name, getattr(value, one.name)) for one in fields(value) if not _is_default(value, one)]
    if len(given) <= 2 and not any(is_dataclass(member) for _, member in given):
        return f"{type(value).__name__}({', '.join(f'{name}={_written(member, indent)}' for name, member in given)})"
    blank = " " * (indent + 4)
    lines = [f"{blank}{name}={_written(member, indent + 4)}," for name, member in given]
    return "\n".join([f"{type(value).__name__}(", *lines, " " * indent + ")"])


def _is_default(value: Any, one: Any) -> bool:
    member = getattr(value, one.name)
    if one.default is MISSING or isinstance(member, np.ndarray):
        return False
    return bool(member is one.default or member == one.default)


def _array(array: np.ndarray[Any, Any], indent: int) -> str:
    numbers = [_plain(number) for number in array.ravel().tolist()]
    blank = " " * (indent + 4)
    rows = [f"{blank}{', '.join(numbers[start : start + _OF_ROW])}," for start in range(0, len(numbers), _OF_ROW)]
    return "\n".join(["np.array([", *rows, f"{' ' * indent}]).reshape({array.shape})"])

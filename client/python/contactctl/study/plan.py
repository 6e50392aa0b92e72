"""Plans of studies: a problem, the varied fields, and the requested answers."""

from __future__ import annotations

import hashlib
import itertools
import json
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import click

from contactd.refusals import did_you_mean

from ..files import named_file, read_named, read_object, with_arrays
from ..output import plain_json
from ..paths import copied, parts, put, put_into_words
from .values import MOST, values_of

__all__ = ["Case", "Plan", "read_plan"]

METHODS = ("contact.solve", "wheelrail.solve")
#: Default answers by method.
USUAL = {
    "contact.solve": ["forces.Fn", "forces.Fx", "forces.Fy", "forces.Mz", "approach", "pmax", "converged"],
    "wheelrail.solve": ["z", "forces.track.Fx", "forces.track.Fy", "forces.track.Fz", "converged"],
}
_FIELDS = {"method", "problem", "vary", "together", "answers"}


@dataclass(frozen=True)
class Case:
    """A case to solve.

    Attributes:
        key: Identifies the case, also in later runs: a digest of the request.
        values: Values of the varied fields by their paths, as in the file.
        asked: The same with the arrays of the named files.
    """

    key: str
    values: dict[str, Any]
    asked: dict[str, Any]


@dataclass(frozen=True)
class Plan:
    """A study.

    Attributes:
        method: Method of the wire.
        problem: Parameters that all rows share.
        axes: Paths and values of the varied fields: all combinations of values of different axes are solved, and the
            fields of one axis vary together.
        answers: Paths of the requested answers.
        cases: Cases in order: the last axis varies fastest.
    """

    method: str
    problem: dict[str, Any]
    axes: list[dict[str, list[Any]]]
    answers: list[str]
    cases: list[Case]

    @property
    def names(self) -> list[str]:
        """Paths of the varied fields."""
        return [name for axis in self.axes for name in axis]

    def params(self, case: Case) -> dict[str, Any]:
        """Returns the parameters of the request."""
        found: dict[str, Any] = copied(self.problem)
        for path, value in case.asked.items():
            put(found, path, value)
        put_into_words(found)
        return found


def read_plan(path: str) -> Plan:
    """Returns the study in a file. Raises click.UsageError naming the field."""
    named = read_named(path)
    inputs = with_arrays(named, path)
    if unknown := inputs.keys() - _FIELDS:
        meant = did_you_mean(min(unknown), _FIELDS)
        raise click.UsageError(f"{path} has {min(unknown)!r}; a study has {', '.join(sorted(_FIELDS))}.{meant}")
    method = inputs.get("method", METHODS[0])
    if method not in METHODS:
        meant = did_you_mean(str(method), METHODS)
        raise click.UsageError(f"{path}: method is {method!r}; it must be {' or '.join(METHODS)}.{meant}")
    problem = _problem(path, inputs.get("problem"))
    if problem.get("fields"):
        raise click.UsageError(f"{path}: problem.fields requests arrays, but rows have none; remove it.")
    problem["fields"] = []
    axes = _axes(path, named)
    answers = inputs.get("answers", USUAL[method])
    if not isinstance(answers, list) or not answers or not all(isinstance(answer, str) for answer in answers):
        raise click.UsageError(f"{path}: answers must be a list of paths in the answer, such as forces.Fx.")
    for answer in answers:
        parts(answer)
    plan = Plan(method, problem, axes, answers, [])
    plan.cases.extend(_cases(path, plan, [with_arrays(axis, path) for axis in axes]))
    if plan.cases:
        plan.params(plan.cases[0])  # report an invalid path before anything is solved
    return plan


def _problem(path: str, given: Any) -> dict[str, Any]:
    if isinstance(given, str):
        return read_object(str(named_file(given, path)))
    if not isinstance(given, dict):
        raise click.UsageError(f"{path} lacks problem, the parameters that all rows share, or the name of a file with them.")
    found: dict[str, Any] = copied(given)
    return found


def _axes(path: str, inputs: dict[str, Any]) -> list[dict[str, list[Any]]]:
    """Returns the axes; the fields of one axis vary together."""
    vary, together = (inputs.get(name, {}) for name in ("vary", "together"))
    if not isinstance(vary, dict) or not isinstance(together, dict) or not (vary or together):
        raise click.UsageError(f"{path} lacks vary, an object of paths and their values, such as Fn: [1000, 2000].")
    if both := vary.keys() & together.keys():
        raise click.UsageError(f"{path}: {min(both)} is in both vary and together.")
    axes = [{name: values_of(path, name, values)} for name, values in vary.items()]
    if together:
        group = {name: values_of(path, name, values) for name, values in together.items()}
        lengths = {name: len(values) for name, values in group.items()}
        if len(set(lengths.values())) > 1:
            raise click.UsageError(f"{path}: the fields of together have different numbers of values: {lengths}.")
        axes.append(group)
    if math.prod(len(next(iter(axis.values()))) for axis in axes) > MOST:
        raise click.UsageError(f"{path} has more than {MOST} rows.")
    return axes


def _cases(path: str, plan: Plan, asked: list[dict[str, list[Any]]]) -> Iterator[Case]:
    """Returns the cases; `asked` are the axes with the arrays of files."""
    shared = json.dumps([plan.method, plan_answers(plan), plain_json(plan.problem)], sort_keys=True)
    base = hashlib.sha256(shared.encode()).hexdigest()
    seen: set[str] = set()
    for values, inputs in zip(_chosen(plan.axes), _chosen(asked)):
        key = hashlib.sha256(f"{base}{json.dumps(plain_json(inputs), sort_keys=True)}".encode()).hexdigest()[:32]
        if key in seen:
            raise click.UsageError(f"{path} has a row twice: {values}.")
        seen.add(key)
        yield Case(key, values, inputs)


def _chosen(axes: list[dict[str, list[Any]]]) -> Iterator[dict[str, Any]]:
    """Yields all combinations of the axes."""
    moves = [[dict(zip(axis, values)) for values in zip(*axis.values())] for axis in axes]
    for chosen in itertools.product(*moves):
        yield {name: value for part in chosen for name, value in part.items()}


def plan_answers(plan: Plan) -> list[str]:
    """Returns the answers; other answers need new rows."""
    return sorted(plan.answers)

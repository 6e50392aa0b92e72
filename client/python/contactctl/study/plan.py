"""What a study is: a problem, the fields that vary, and the answers that are wanted."""

from __future__ import annotations

import hashlib
import itertools
import json
import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click
import numpy as np

from ..files import read_object
from ..output import plain_json
from ..paths import copied, parts, put

__all__ = ["Case", "Plan", "read_plan"]

METHODS = ("contact.solve", "wheelrail.solve")
#: Answers where the file names none, by method.
USUAL = {
    "contact.solve": ["forces.Fn", "forces.Fx", "forces.Fy", "forces.Mz", "approach", "pmax", "converged"],
    "wheelrail.solve": ["z", "forces.track.Fx", "forces.track.Fy", "forces.track.Fz", "converged"],
}
MOST = 1_000_000  #: rows of a study
_FIELDS = {"method", "problem", "vary", "together", "answers"}


@dataclass(frozen=True)
class Case:
    """One row to be.

    Attributes:
        key: Tells it from all others, also in a later run: a digest of what is asked.
        values: Of the fields that vary, by their paths.
    """

    key: str
    values: dict[str, Any]


@dataclass(frozen=True)
class Plan:
    """A study.

    Attributes:
        method: That of the wire.
        problem: Parameters that all rows share.
        names: Paths of the fields that vary.
        answers: Paths of what is wanted of each answer.
        cases: In their order.
    """

    method: str
    problem: dict[str, Any]
    names: list[str]
    answers: list[str]
    cases: list[Case]

    def params(self, case: Case) -> dict[str, Any]:
        """Of the request."""
        found: dict[str, Any] = copied(self.problem)
        for path, value in case.values.items():
            put(found, path, value)
        return found


def read_plan(path: str) -> Plan:
    """The study that a file describes. Raises click.UsageError naming the field."""
    said = read_object(path)
    if unknown := said.keys() - _FIELDS:
        raise click.UsageError(f"{path} has {min(unknown)!r}; a study has {', '.join(sorted(_FIELDS))}.")
    method = said.get("method", METHODS[0])
    if method not in METHODS:
        raise click.UsageError(f"{path}: method is {method!r}; it must be {' or '.join(METHODS)}.")
    problem = _problem(path, said.get("problem"))
    if problem.get("fields"):
        raise click.UsageError(f"{path}: problem.fields asks for arrays, of which a row has none; leave it out.")
    problem["fields"] = []
    axes = _axes(path, said)
    answers = said.get("answers", USUAL[method])
    if not isinstance(answers, list) or not answers or not all(isinstance(answer, str) for answer in answers):
        raise click.UsageError(f"{path}: answers must be a list of paths in the answer, such as forces.Fx.")
    for answer in answers:
        parts(answer)
    plan = Plan(method, problem, [name for axis in axes for name in axis], answers, [])
    plan.cases.extend(_cases(path, plan, axes))
    if plan.cases:
        plan.params(plan.cases[0])  # a path that leads nowhere is told before anything is solved
    return plan


def _problem(path: str, given: Any) -> dict[str, Any]:
    if isinstance(given, str):
        return read_object(str(Path(path).parent / given) if path != "-" else given)
    if not isinstance(given, dict):
        raise click.UsageError(f"{path} lacks problem, the parameters that all rows share, or the name of a file with them.")
    found: dict[str, Any] = copied(given)
    return found


def _axes(path: str, said: dict[str, Any]) -> list[dict[str, list[Any]]]:
    """Each moves by itself; its fields move together."""
    vary, together = (said.get(name, {}) for name in ("vary", "together"))
    if not isinstance(vary, dict) or not isinstance(together, dict) or not (vary or together):
        raise click.UsageError(f"{path} lacks vary, an object of paths and their values, such as Fn: [1000, 2000].")
    if both := vary.keys() & together.keys():
        raise click.UsageError(f"{path}: {min(both)} is in vary and in together.")
    axes = [{name: _values(path, name, values)} for name, values in vary.items()]
    if together:
        group = {name: _values(path, name, values) for name, values in together.items()}
        lengths = {name: len(values) for name, values in group.items()}
        if len(set(lengths.values())) > 1:
            raise click.UsageError(f"{path}: the fields of together have numbers of values that differ: {lengths}.")
        axes.append(group)
    if math.prod(len(next(iter(axis.values()))) for axis in axes) > MOST:
        raise click.UsageError(f"{path} has more than {MOST} rows.")
    return axes


def _values(path: str, name: str, said: Any) -> list[Any]:
    parts(name)
    right = "a list, or {from: 0, to: 1, count: 11}, or with step in place of count, or with scale: log"
    if isinstance(said, list) and said:
        return said
    if not isinstance(said, dict) or not said.keys() <= {"from", "to", "count", "step", "scale"}:
        raise click.UsageError(f"{path}: the values of {name} must be {right}.")
    start, end = (said.get(name, "") for name in ("from", "to"))
    numbers = [start, end, said.get("step", 1), said.get("count", 1)]
    if not all(isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value) for value in numbers):
        raise click.UsageError(f"{path}: the values of {name} must be {right}; all are finite numbers.")
    return _range(path, name, float(start), float(end), said)


def _range(path: str, name: str, start: float, end: float, said: dict[str, Any]) -> list[Any]:
    scale = said.get("scale", "linear")
    if scale not in ("linear", "log") or (scale == "log" and not (start > 0 and end > 0)):
        raise click.UsageError(f"{path}: scale of {name} must be linear, or log between positive numbers.")
    if ("step" in said) == ("count" in said) or ("step" in said and scale == "log"):
        raise click.UsageError(f"{path}: {name} must have either count or, of a linear scale, step.")
    if "step" in said:
        count = (end - start) / said["step"] if said["step"] else -1
        if count < 0 or count > MOST:
            raise click.UsageError(f"{path}: step of {name} does not lead from {start:g} to {end:g} in {MOST} steps.")
        return [start + index * said["step"] for index in range(math.floor(count * (1 + 1e-12)) + 1)]
    if not isinstance(said["count"], int) or not 1 <= said["count"] <= MOST:
        raise click.UsageError(f"{path}: count of {name} must be a whole number, 1 to {MOST}.")
    space = np.geomspace if scale == "log" else np.linspace
    return [float(value) for value in space(start, end, said["count"])]


def _cases(path: str, plan: Plan, axes: list[dict[str, list[Any]]]) -> Iterator[Case]:
    shared = json.dumps([plan.method, plan_answers(plan), plain_json(plan.problem)], sort_keys=True)
    base = hashlib.sha256(shared.encode()).hexdigest()
    seen: set[str] = set()
    moves = [[dict(zip(axis, values)) for values in zip(*axis.values())] for axis in axes]
    for chosen in itertools.product(*moves):
        values = {name: value for part in chosen for name, value in part.items()}
        key = hashlib.sha256(f"{base}{json.dumps(plain_json(values), sort_keys=True)}".encode()).hexdigest()[:32]
        if key in seen:
            raise click.UsageError(f"{path} has a row twice: {values}.")
        seen.add(key)
        yield Case(key, values)


def plan_answers(plan: Plan) -> list[str]:
    """Whoever wants other answers needs other rows."""
    return sorted(plan.answers)

"""Computes what the store does not hold yet, one request after the other, and says how far it is."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterable
from typing import Any

from .cases import Case, Spec, effort
from .store import ResultStore

Measure = Callable[[Spec], dict[str, Any]]
Say = Callable[[str], None]


def identity(spec: Spec) -> str:
    return json.dumps(spec, sort_keys=True)


def distinct(cases: Iterable[Case]) -> list[Case]:
    """The first case of each request: figures share computations."""
    first: dict[str, Case] = {}
    for case in cases:
        first.setdefault(identity(case.spec), case)
    return list(first.values())


def compute(cases: Iterable[Case], store: ResultStore, measure: Measure, say: Say) -> None:
    """After it the store holds the result of every case; each is written as soon as it is there."""
    wanted = distinct(cases)
    missing = [case for case in wanted if store.get(case.spec) is None]
    if len(missing) < len(wanted):
        say(f"{len(wanted) - len(missing)} of {len(wanted)} computations are in the store")
    if others := sum(store.is_of_another_build(case.spec) for case in wanted):
        say(f"note: {others} of them are of another build of this version; --fresh computes them again")
    left = sum(effort(case.spec) for case in missing)
    done, start = 0.0, time.monotonic()
    for number, case in enumerate(missing, 1):
        result = measure(case.spec)
        store.put(case.spec, result)
        done += effort(case.spec)
        elapsed = time.monotonic() - start
        remaining = duration(elapsed / done * max(0.0, left - done))
        name = f"{case.part}: {case.curve}, {case.parameter} = {case.value:g}"
        say(f"[{number:3}/{len(missing)}] {name:52} {summary(result)}; about {remaining} left")


def summary(result: dict[str, Any]) -> str:
    if "failure" in result:
        return "did not converge"
    error = next(iter(result["errors"].values()))["zz"]["origin"]
    return f"{result['dofs']:7} dofs, {result['cpu_seconds']:6.1f} s CPU, origin {100 * error:+7.3f} %"


def duration(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 90 else f"{seconds / 60:.0f} min"

"""Computes the results that are not in the store yet, one request after the other, and reports progress."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterable
from contextlib import AbstractContextManager

from .section import Case, Measure, Section, Spec
from .store import ResultStore

Say = Callable[[str], None]


def identity(spec: Spec) -> str:
    return json.dumps(spec, sort_keys=True)


def distinct(cases: Iterable[Case]) -> list[Case]:
    """Returns the first case of each request, because figures share computations."""
    first: dict[str, Case] = {}
    for case in cases:
        first.setdefault(identity(case.spec), case)
    return list(first.values())


def compute(
    cases: Iterable[Case], store: ResultStore, section: Section, solver: AbstractContextManager[Measure], say: Say
) -> None:
    """Computes every case that is not in the store, and writes each result at once."""
    computations = distinct(cases)
    missing = [case for case in computations if store.get(case.spec) is None]
    if len(missing) < len(computations):
        say(f"{len(computations) - len(missing)} of {len(computations)} computations are in the store")
    if others := sum(store.is_of_another_build(case.spec) for case in computations):
        say(f"note: {others} of them are of another build of this version; --fresh computes them again")
    if not missing:
        return
    efforts = section.efforts([case.spec for case in missing])
    left, done, start = sum(efforts), 0.0, time.monotonic()
    with solver as measure:
        for number, (case, effort) in enumerate(zip(missing, efforts, strict=True), 1):
            result = measure(case.spec)
            store.put(case.spec, result)
            done += effort
            remaining = duration((time.monotonic() - start) / done * max(0.0, left - done))
            name = f"{case.part}: {case.curve}, {case.parameter} = {case.value:g}"
            text = "did not converge" if "failure" in result else section.summary(result)
            say(f"[{number:3}/{len(missing)}] {name:52} {text}; about {remaining} left")


def duration(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 90 else f"{seconds / 60:.0f} min"

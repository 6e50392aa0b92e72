"""Solves one case with all contact models that support it."""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any, TypeVar

import numpy as np

from ..errors import Cancelled, DeadlineExceeded, InternalError, StatusError, Unauthenticated, Unavailable, invalid
from ..refusals import check_type
from ..values.answers import read
from ..values.contact_params import problem_params
from ..values.generated.grid import Grid
from ..values.generated.problem import ContactProblem
from ..values.generated.service import Progress
from ..values.generated.wheel_rail.setup import WheelRailSetup
from ..values.generated.wheel_rail.state import WheelRailState
from ..values.step_solution import read_solution
from ..values.wheel_rail.comparison import ComparedModel, ModelComparison, combinations, errors_of, model_names
from ..values.wheel_rail.params import setup_params, state_params
from ..values.wheel_rail.solution import read_wheel_rail
from .call import Answering, Noted, asks
from .caller import Caller, ProgressCallback
from .progress_bar import progress_shown

__all__ = ["ComparisonCalls"]

T = TypeVar("T")

_FIELDS = ["element_division", "pressure", "traction_x", "traction_y"]
#: Options of `simplified` by model; other models have none.
_OPTIONS = {
    "fastsim": ("slope", "bound", "on_elements", "blended", "coefficients"),
    "fastrip": ("slope", "blended", "coefficients"),
    "polach": ("coefficients", "k_adhesion", "k_slip"),
}
#: Answers that are not compared; some models do not have them.
_NOT_COMPARED = ("derivatives", "displacements")
_LONG = 1.0  #: Solves longer than this (s) are not repeated to measure their time.
#: These errors do not depend on the case.
_NO_REFUSALS = (Cancelled, DeadlineExceeded, InternalError, Unauthenticated, Unavailable)


class ComparisonCalls(Caller):
    """Calls that compare models."""

    @asks
    def compare(
        self,
        problem: ContactProblem | Mapping[str, Any],
        *,
        models: Iterable[str] | None = None,
        repeats: int = 3,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[ModelComparison]:
        """Solves one contact with all models that support it, and compares them with the full theory::

            found = client.compare(problem)
            print(found["fastsim"].errors.force, found["kpec+fastsim"].seconds)
            found.plot().savefig("models.png")

        `problem` may also be the parameters of contact.solve or wheelrail.solve, as on the wire. `models` are names
        such as "fastsim" or "kpec+fastsim"; the full theory is always included. If a model does not support the case,
        its `refusal` contains the reason. Options of `simplified` apply to the models that have them.

        Models are solved one after the other. Short solves are repeated `repeats` times to measure their time.
        `timeout` applies to each request.

        If no model supports the case, raises the exception of the full theory.
        """
        check_type("problem", problem, ContactProblem, Mapping)
        params = problem_params(problem) if isinstance(problem, ContactProblem) else dict(problem)
        return (yield from _compared(self, params, models, repeats, timeout, on_progress, progress))

    @asks
    def compare_wheel_rail(
        self,
        setup: WheelRailSetup,
        state: WheelRailState,
        *,
        models: Iterable[str] | None = None,
        repeats: int = 3,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[ModelComparison]:
        """Compares all models that support a wheel on its rail, like `compare`."""
        params = {"setup": setup_params(setup), "state": state_params(state, "state")}
        return (yield from _compared(self, params, models, repeats, timeout, on_progress, progress))


def _compared(
    caller: Caller,
    params: dict[str, Any],
    models: Iterable[str] | None,
    repeats: int,
    timeout: float | None,
    on_progress: ProgressCallback | None,
    progress: bool,
) -> Answering[ModelComparison]:
    if not isinstance(repeats, int) or repeats < 1:
        raise ValueError(f"repeats is {repeats!r}; it must be a whole number, 1 or more")
    of_wheel = "setup" in params
    mu = _largest_mu(params["setup"].get("friction", {"mu": 0.3}) if of_wheel else params.get("friction"))
    names = model_names(models, mu is not None)
    found: list[ComparedModel] = []
    refusals: list[StatusError] = []
    with progress_shown("comparing", progress) as show:
        for index, name in enumerate(names):
            news = Progress(name, index / len(names))
            show(news)
            if on_progress is not None:
                on_progress(news)
            one = _Asked(caller, params, name, timeout, on_progress)
            try:
                found.append((yield from _named(one.compared(repeats), name)))
            except _NO_REFUSALS:
                raise
            except StatusError as error:
                refusals.append(error)
                found.append(ComparedModel(name, *combinations()[name], refusal=error.message))
    if len(refusals) == len(names):
        raise refusals[0]
    full = found[0].solution
    if full is not None and full.converged:
        found = [
            one if one.solution is None else replace(one, errors=errors_of(one.solution, full, mu)) for one in found
        ]
    nothing = yield from _shortest_of_nothing(caller, repeats, timeout)
    return ModelComparison(tuple(found), nothing)


def _shortest_of_nothing(caller: Caller, repeats: int, timeout: float | None) -> Answering[float]:
    shortest = float("inf")
    for _ in range(1 + repeats):
        began = time.perf_counter()
        yield from caller.asked("server.health", timeout=timeout)
        shortest = min(shortest, time.perf_counter() - began)
    return shortest


class _Asked:
    """Returns the case with one model."""

    def __init__(
        self, caller: Caller, params: dict[str, Any], name: str, timeout: float | None, on_progress: ProgressCallback | None
    ) -> None:  # fmt: skip
        self._caller, self._name, self._timeout, self._on_progress = caller, name, timeout, on_progress
        self._model, self._normal = combinations()[name]
        self._of_wheel = "setup" in params
        self._left_out: tuple[str, ...] = ()
        if self._of_wheel:
            state = {key: value for key, value in params.get("state", {}).items() if key not in _NOT_COMPARED}
            given = {key: value for key, value in params.items() if key != "gap"}
            self._params = {**given, "setup": self._of_this_model(params["setup"]), "state": state}
        else:
            self._params = self._of_this_model(params)

    def _of_this_model(self, given: Mapping[str, Any]) -> dict[str, Any]:
        changed = {
            key: value
            for key, value in given.items()
            if key not in ("model", "normal_model", "simplified", *_NOT_COMPARED)
        }
        changed["model"] = self._model
        if self._normal != "of_model":
            changed["normal_model"] = self._normal
        own = _OPTIONS.get(self._model, ())
        options = {key: value for key, value in (given.get("simplified") or {}).items() if value is not None}
        self._left_out = tuple(key for key in options if key not in own)
        if kept := {key: value for key, value in options.items() if key in own}:
            changed["simplified"] = kept
        bodies = changed.get("bodies")
        if not self._of_wheel and isinstance(bodies, Mapping) and "ics" not in changed and not _has_own_ics(bodies):
            changed["ics"] = {"source": "analytic"}  # effects that simplified models neglect
        return changed

    def compared(self, repeats: int) -> Answering[ComparedModel]:
        solution, seconds = yield from self._solved(_FIELDS)
        for _ in range(repeats if seconds < _LONG else 0):
            _, again = yield from self._solved([])
            seconds = min(seconds, again)
        return ComparedModel(
            self._name, self._model, self._normal, solution=solution, seconds=seconds, left_out=self._left_out
        )

    def _report(self, progress: Progress) -> None:
        """Reports builds that the request waits for. Solves end too soon to be reported."""
        if self._on_progress is not None and progress.job.startswith("build-"):
            self._on_progress(progress)

    def _solved(self, fields: list[str]) -> Answering[tuple[Any, float]]:
        params = {**self._params, "fields": fields}
        began = time.perf_counter()
        method = "wheelrail.solve" if self._of_wheel else "contact.solve"
        result = yield from self._caller.asked(method, params, timeout=self._timeout, on_progress=self._report)
        seconds = time.perf_counter() - began
        if self._of_wheel:
            return read_wheel_rail(fields, False, result), seconds
        return read_solution(read(Grid, self._params["grid"], "grid"), fields, result), seconds


def _has_own_ics(bodies: Mapping[str, Any]) -> bool:
    return any(isinstance(body, Mapping) and "ics" in body for body in bodies.values())


def _largest_mu(friction: Any) -> float | None:
    """None without friction."""
    if friction is None:
        return None
    if not isinstance(friction, Mapping):
        raise invalid("friction", f"is {friction!r:.60}; it must be an object such as {{mu: 0.3}}")
    given = friction.get("mu", 0.3)
    if isinstance(given, list) and given and isinstance(given[0], Mapping):  # by the angle of the rail's surface
        given = [part.get("mu", 0.0) for part in given]
    try:
        return float(np.max(np.asarray(given, dtype=float)))
    except (TypeError, ValueError):
        return 0.0  # The daemon reports the error.


def _named(steps: Answering[T], name: str) -> Answering[T]:
    """Runs these steps, and adds the model to their warnings."""
    try:
        asked = next(steps)
        while True:
            if isinstance(asked, Noted):
                asked = Noted(tuple(f"{name}: {sentence}" for sentence in asked.sentences))
            try:
                reply = yield asked
            except BaseException as error:
                asked = steps.throw(error)
            else:
                asked = steps.send(reply)
    except StopIteration as end:
        answer: T = end.value
        return answer

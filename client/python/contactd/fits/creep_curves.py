"""Solves creep curves of a contact for given parameters, in batches on all workers of the daemon."""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import ProtocolError, StatusError
from ..transport.messages import results
from ..values.arrays import Array
from ..values.field_paths import copied, get, put

__all__ = ["Ask", "CreepCurves", "Response"]

#: Names of creepages, and the force of each.
_CREEPAGES = {"xi": "Fx", "eta": "Fy", "phi": "Fy"}
_NUMBER = re.compile(r"\d+(\.\d+)?(e[+-]?\d+)?")
_MOST_AT_ONCE = 1000
_TARGET = 2.0  #: Target time of a batch (s), so that Ctrl-C and progress are not delayed.
_UNUSABLE = ("FIELD_INVALID", "ARRAY_INVALID")  #: Reasons that concern a single problem, not the batch.
#: Paths of inputs for which the daemon computes derivatives of forces.
_DERIVATIVES = {"friction.mu": "mu", "Fn": "Fn"}


#: A function that calls any method of the daemon, like Client.call.
Ask = Callable[..., dict[str, Any]]


@dataclass(frozen=True)
class Response:
    """Describes the location of the measured value in each answer.

    Attributes:
        by: Path of the creepage.
        force: "Fx" or "Fy".
        is_coefficient: Whether it is divided by the normal force.
    """

    by: str
    force: str
    is_coefficient: bool

    @staticmethod
    def of(by: str, force: str | None, quantity: str) -> Response:
        """Creates the response. `by` is xi, eta or phi of rolling, or a path. Raises ValueError."""
        if quantity not in ("coefficient", "force"):
            raise ValueError(f'quantity is {quantity!r}; it must be "coefficient" or "force"')
        if force not in (None, "Fx", "Fy"):
            raise ValueError(f'force is {force!r}; it must be "Fx" or "Fy"')
        path = f"friction.rolling.{by}" if by in _CREEPAGES else by
        if "." not in path:
            raise ValueError(f'by is {by!r}; it must be "xi", "eta", "phi", or a path such as friction.rigid_shift[0]')
        usual = "Fy" if path.endswith(("eta", "phi", "[1]")) else "Fx"
        return Response(path, force or usual, quantity == "coefficient")

    def value(self, answer: dict[str, Any]) -> float:
        """Returns the value, positive if the force opposes a positive creepage."""
        forces = answer["forces"]
        return float(-forces[self.force] / (forces["Fn"] if self.is_coefficient and forces["Fn"] else 1.0) + 0.0)

    def derivative(self, answer: dict[str, Any], path: str) -> float:
        """Returns the derivative with respect to an input of _DERIVATIVES; NaN if the answer does not have it."""
        found = get(answer, f"derivatives.{self.force}.{_DERIVATIVES[path]}")
        if found is None:
            return float("nan")
        if not self.is_coefficient:
            return float(-found)
        Fn = answer["forces"]["Fn"]
        own = answer["forces"][self.force] / Fn**2 if path == "Fn" else 0.0
        return float(-found / Fn + own)


class CreepCurves:
    """Solves curves. Points that cannot be solved, or do not converge, are NaN; `trouble` is the reason.

    Attributes:
        solves: Number of contact problems that were solved.
        trouble: The error of the last point without a value; empty if there is none.
        refusal: The exception of that point, if the daemon refused it.
    """

    def __init__(
        self, ask: Ask, params: Mapping[str, Any], paths: Sequence[str], response: Response, timeout: float | None,
        report: Callable[[Any], None],
    ) -> None:  # fmt: skip
        self._ask, self._paths, self._response = ask, list(paths), response
        self._timeout, self._report = timeout, report
        self._params = copied(dict(params))
        for name in ("derivatives", "displacements"):
            self._params.pop(name, None)
        self._params["fields"] = []
        self._at_once = 8
        self.solves = 0
        self.trouble = ""
        self.refusal: StatusError | None = None

    def problem(self, values: Sequence[float], creepage: float | None = None) -> dict[str, Any]:
        """Returns the parameters of contact.solve."""
        made: dict[str, Any] = copied(self._params)
        for path, value in zip(self._paths, values):
            put(made, path, float(value))
        if creepage is not None:
            put(made, self._response.by, float(creepage))
        return made

    def curves(self, values: Sequence[Sequence[float]], creepage: Array) -> Array:
        """Returns a curve for each of several sets of values, shape [n, m]."""
        return self.points([(one, x) for one in values for x in creepage]).reshape(len(values), len(creepage))

    def points(self, points: Sequence[tuple[Sequence[float], float]]) -> Array:
        """Returns single points, each with its own parameters and creepage."""
        return np.array([self._value(answer) for answer in self._answers([self.problem(*point) for point in points])])

    def curve_with_warnings(self, values: Sequence[float], creepage: Array) -> tuple[Array, tuple[str, ...]]:
        """Returns a curve and the warnings of its answers. Sentences that differ only in their numbers are reported
        once.
        """
        answers = self._answers([self.problem(values, x) for x in creepage])
        alike: dict[str, list[str]] = {}
        for sentence in (str(one) for answer in answers if isinstance(answer, dict) for one in answer.get("warnings", ())):
            alike.setdefault(_NUMBER.sub("#", sentence), []).append(sentence)
        sentences = [same[-1] if len(same) == 1 else f"{same[-1]} ({len(same)} points)" for same in alike.values()]
        return np.array([self._value(answer) for answer in answers]), tuple(sentences)

    def derivatives(self, values: Sequence[float], creepage: Array, path: str) -> Array | None:
        """Returns derivatives of the curve with respect to a parameter, computed by the daemon; None if it does not
        support it.
        """
        if path not in _DERIVATIVES or self._params.get("model", "full") not in ("full", "fastsim", "fastrip", "polach"):
            return None
        problems = [{**self.problem(values, x), "derivatives": True} for x in creepage]
        found = []
        for answer in self._answers(problems):
            if isinstance(answer, StatusError) or not answer["converged"]:
                return None
            found.append(self._response.derivative(answer, path))
        return np.array(found) if np.all(np.isfinite(found)) else None

    def _value(self, answer: dict[str, Any] | StatusError) -> float:
        if isinstance(answer, StatusError):
            self.trouble, self.refusal = answer.message.rstrip("."), answer
            return float("nan")
        if not answer["converged"]:
            self.trouble, self.refusal = "a solve did not converge", None
            return float("nan")
        return self._response.value(answer)

    def _answers(self, problems: list[dict[str, Any]]) -> list[dict[str, Any] | StatusError]:
        found: list[dict[str, Any] | StatusError] = []
        while len(found) < len(problems):
            part = problems[len(found) : len(found) + self._at_once]
            began = time.monotonic()
            try:
                answers = self._solved(part)
            except StatusError as error:
                if error.reason == "LIMIT_EXCEEDED" and len(part) > 1:
                    self._at_once = len(part) // 2
                    continue
                if error.reason not in _UNUSABLE:
                    raise
                # Solve them one by one to find those that are invalid.
                answers = [self._alone(one) for one in part]
            found.extend(answers)
            self.solves += len(part)
            elapsed = time.monotonic() - began
            self._at_once = min(_MOST_AT_ONCE, max(1, int(len(part) * min(4.0, _TARGET / max(elapsed, 1e-3)))))
        return found

    def _alone(self, problem: dict[str, Any]) -> dict[str, Any] | StatusError:
        try:
            return self._solved([problem])[0]
        except StatusError as error:
            if error.reason not in _UNUSABLE:
                raise
            error.message = error.message.replace("problems[0].", "")
            return error

    def _solved(self, problems: list[dict[str, Any]]) -> list[dict[str, Any] | StatusError]:
        answer = self._ask("contact.solve_many", {"problems": problems}, timeout=self._timeout, on_progress=self._report)
        return results("contact.solve_many", answer, "solutions", [_checked] * len(problems))


def _checked(answer: Any, path: str) -> dict[str, Any]:
    if not isinstance(answer, dict) or not isinstance(answer.get("forces"), dict) or "converged" not in answer:
        raise ProtocolError(f"The answer's {path} lacks forces.")
    return answer

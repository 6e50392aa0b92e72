"""Searches the parameters of a curve by least squares."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import ContactdError, MissingExtra, invalid
from ..values.arrays import Array
from .creep_curves import CreepCurves
from .measured_curve import MeasuredCurve
from .parameter import VariedParameter

__all__ = ["FitFailed", "Found", "Search"]

_INSIDE = 1e-3  #: Distance of starts from the bounds.
_STEPS = (1.0, -1.0, 0.25, -0.25)  #: Fractions of the step of differences that are tried.
_ATTEMPTS = 4  #: Largest number of starts from which the search continues.
_STUCK = 0.05  #: Cosine between residuals and the change by a parameter, far above errors of differences.
_REASONS = {
    0: "the largest number of evaluations was reached",
    1: "the residuals do not decrease in any direction",
    2: "the sum of squares no longer changes",
    3: "the parameters no longer change",
    4: "sum of squares and parameters no longer change",
}


class FitFailed(ContactdError):
    """No curve can be computed at the start of the search, or at its next point. The cause is the daemon's refusal, if
    any.
    """


@dataclass(frozen=True, eq=False)
class Found:
    """Reports the end of the search.

    Attributes:
        places: Positions of the parameters between their bounds.
        start: Start of the search.
        jacobian: Derivatives of the curve with respect to the positions, shape [m, n].
        converged: Whether the search converged.
        reason: Reason for its end.
        evaluations: Number of computed curves.
        trouble: Reason why curves could not be computed; empty if all were computed.
    """

    places: Array
    start: Array
    jacobian: Array
    converged: bool
    reason: str
    evaluations: int
    trouble: str


class Search:
    """Varies the positions of parameters between their bounds, 0 to 1."""

    def __init__(
        self, parameters: Sequence[VariedParameter], curve: MeasuredCurve, curves: CreepCurves, report: Callable[[int, float], None]
    ) -> None:  # fmt: skip
        self._parameters, self._curve, self._curves, self._report = parameters, curve, curves, report
        self._evaluations = 0
        self._least = float("inf")
        self._known: tuple[Array, Array] | None = None
        self._is_partial = False
        self._has_derivatives: dict[str, bool] = {}

    def values(self, places: Array) -> list[float]:
        """Returns the values of the parameters."""
        return [one.value(float(place)) for one, place in zip(self._parameters, places)]

    def run(self, starts: int, most: int) -> Found:
        """Searches from the best of several starts, and from the next best ones if that stops early. Raises FitFailed,
        and MissingExtra without scipy.
        """
        least_squares = _least_squares()
        failure: FitFailed | None = None
        for start in self._starts(starts)[:_ATTEMPTS]:
            try:
                return self._from(start, least_squares, most)
            except FitFailed as error:
                failure = error
        assert failure is not None  # There is at least one start; otherwise _starts has raised.
        raise failure

    def _from(self, start: Array, least_squares: Any, most: int) -> Found:
        self._curves.trouble = ""
        ended = least_squares(
            self._residuals, start, self._jacobian_of_residuals, bounds=(0.0, 1.0), xtol=1e-7, ftol=1e-9, gtol=1e-10, max_nfev=most
        )
        jacobian = self.jacobian(ended.x, self._curve.creepage) if self._is_partial else -ended.jac / self._curve.weight[:, None]
        trouble, converged = self._curves.trouble, ended.status > 0
        if trouble and converged and self._is_stuck(ended.x, jacobian, ended.fun):
            raise FitFailed(
                f"The search cannot continue from {self._where(ended.x)}, where no neighbouring curve can be computed: {trouble}. Give "
                "narrower bounds, another start, or more starts."
            )
        reason = _REASONS.get(int(ended.status), str(ended.message))
        return Found(ended.x, start, jacobian, converged, reason, self._evaluations, trouble)

    def _is_stuck(self, places: Array, jacobian: Array, residuals: Array) -> bool:
        """Returns whether a change of a parameter within the bounds would reduce the residuals."""
        weighted = jacobian * self._curve.weight[:, None]
        sizes = np.linalg.norm(weighted, axis=0) * np.linalg.norm(residuals)
        downhill = (weighted.T @ residuals) / np.where(sizes > 0, sizes, 1.0)  # by larger places
        may_rise, may_fall = places < 1 - _INSIDE, places > _INSIDE
        return bool(np.any((may_rise & (downhill > _STUCK)) | (may_fall & (downhill < -_STUCK))))

    def jacobian(self, places: Array, creepage: Array) -> Array:
        """Returns the derivatives of the curve with respect to the positions, shape [m, n]: of the daemon if available,
        otherwise differences. Raises FitFailed if a point has none.
        """
        found = self._known_derivatives(places, creepage)
        if np.any(np.isnan(found)):
            point, index = divmod(int(np.isnan(found).argmax()), len(places))
            raise FitFailed(
                f"The derivative by {self._parameters[index].path} cannot be computed at creepage {creepage[point]:g}, neither "
                f"upwards nor downwards: {self._curves.trouble}. If solutions are not unique, give narrower bounds."
            )
        return found

    def _known_derivatives(self, places: Array, creepage: Array) -> Array:
        """Returns derivatives by differences upwards, downwards or with smaller steps, and NaN where all fail."""
        found = np.full((len(creepage), len(places)), np.nan)
        for index in range(len(places)):
            known = self._derivatives(index, places, creepage)
            if known is not None:
                found[:, index] = known
        base = self._curve_at(places) if creepage is self._curve.creepage else self._computed([places], creepage)[0]
        for part in _STEPS:
            todo = np.argwhere(np.isnan(found) & np.isfinite(base)[:, None])
            if not len(todo):
                break
            moved = [self._moved(places, index, part) for index in range(len(places))]
            values = [self.values(at) for at in moved]
            pairs = [(int(point), int(index)) for point, index in zip(*todo.T)]
            curve = self._curves.points([(values[index], float(creepage[point])) for point, index in pairs])
            for (point, index), value in zip(pairs, curve):
                found[point, index] = (value - base[point]) / (moved[index][index] - places[index])
        return found

    def _moved(self, places: Array, index: int, part: float) -> Array:
        """Returns the positions with one moved by a fraction of its step, upwards if that is within the bounds."""
        at = places.copy()
        way = 1.0 if places[index] + self._parameters[index].step <= 1 else -1.0
        at[index] += way * part * self._parameters[index].step
        return at

    def _derivatives(self, index: int, places: Array, creepage: Array) -> Array | None:
        one = self._parameters[index]
        if self._has_derivatives.get(one.path) is False:
            return None
        found = self._curves.derivatives(self.values(places), creepage, one.path)
        self._has_derivatives[one.path] = found is not None
        return None if found is None else found * one.slope(float(places[index]))

    def _computed(self, places: Sequence[Array], creepage: Array) -> Array:
        return self._curves.curves([self.values(one) for one in places], creepage)

    def _curve_at(self, places: Array) -> Array:
        if self._known is None or not np.array_equal(self._known[0], places):
            self._evaluations += 1
            self._known = places.copy(), self._computed([places], self._curve.creepage)[0]
        return self._known[1]

    def _residuals(self, places: Array) -> Array:
        found = self._curve.residuals(self._curve_at(places))
        if np.all(np.isfinite(found)):
            self._least = min(self._least, float(np.sqrt(np.mean(found**2))))
        self._report(self._evaluations, self._least)
        return found

    def _jacobian_of_residuals(self, places: Array) -> Array:
        """Points without derivatives do not affect the direction of a step, but they affect whether it is accepted."""
        found = self._known_derivatives(places, self._curve.creepage)
        has_all = np.all(np.isfinite(found), axis=1)
        if np.count_nonzero(has_all) < len(places):
            raise FitFailed(f"The search cannot continue from {self._where(places)}: {self._curves.trouble}.")
        self._is_partial = not np.all(has_all)
        return -np.where(has_all[:, None], found, 0.0) * self._curve.weight[:, None]

    def _where(self, places: Array) -> str:
        return ", ".join(f"{one.path} {value:g}" for one, value in zip(self._parameters, self.values(places)))

    def _starts(self, count: int) -> list[Array]:
        """Returns the start and others between the bounds: those with curves, the best first."""
        first = np.array([0.5 if one.start is None else one.place(one.start) for one in self._parameters])
        found: list[tuple[float, int, Array]] = []
        for place in (first, *_spread(count - 1, len(first))):
            inside = np.clip(place, _INSIDE, 1 - _INSIDE)
            size = float(np.sum(self._residuals(inside) ** 2))
            if np.isfinite(size):
                found.append((size, len(found), inside))
        if not found:
            raise FitFailed(
                f"No curve can be computed at the start, {self._where(first)}: {self._curves.trouble}. Give other starts or bounds, "
                "or omit points that cannot be computed."
            ) from self._curves.refusal
        return [place for _, _, place in sorted(found, key=lambda one: one[:2])]


def _spread(count: int, dimensions: int) -> list[Array]:
    """Returns Halton's points, which fill the box more evenly than random points."""
    if dimensions > len(_PRIMES):
        raise invalid("parameters", f"has {dimensions} fields, but at most {len(_PRIMES)} can be fitted")
    return [np.array([_radical_inverse(index + 1, base) for base in _PRIMES[:dimensions]]) for index in range(max(0, count))]


_PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29)


def _radical_inverse(index: int, base: int) -> float:
    found, part = 0.0, 1.0 / base
    while index:
        index, digit = divmod(index, base)
        found += digit * part
        part /= base
    return found


def _least_squares() -> Any:
    try:
        from scipy.optimize import least_squares
    except ImportError:
        raise MissingExtra("A fit", "scipy", "fit", "python3-scipy") from None
    return least_squares

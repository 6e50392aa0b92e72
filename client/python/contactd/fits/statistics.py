"""Uncertainties of fitted parameters: errors, correlations, and sentences about them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..values.arrays import Array
from .parameter import VariedParameter

__all__ = ["Certainty", "certainty_of"]

_AT_BOUND = 1e-3  #: Fraction of the distance between the bounds.
_CLOSE = 0.98  #: Correlation from which parameters cannot be distinguished.
_SINGULAR = 1e-6  #: Relative singular value below which a combination of parameters is undetermined.


@dataclass(frozen=True, eq=False)
class Certainty:
    """Computes errors of positions between bounds.

    Attributes:
        covariance: Covariance of the positions, shape [n, n]; zero for those at bounds, infinite for undetermined ones.
        quantile: Student's quantile; None if there are no more points than parameters.
        at_bound: "low", "high" or empty for each parameter.
        is_known: Whether a parameter has an error.
        sentences: Sentences about limitations.
    """

    covariance: Array
    quantile: float | None
    at_bound: tuple[str, ...]
    is_known: tuple[bool, ...]
    sentences: tuple[str, ...]

    def correlation(self) -> Array:
        """Returns the correlation of the errors; NaN for parameters without one."""
        sizes = np.sqrt(np.diag(self.covariance))
        with np.errstate(all="ignore"):
            found: Array = self.covariance / np.outer(sizes, sizes)
        unknown = np.logical_not(self.is_known)
        found[unknown, :] = found[:, unknown] = np.nan
        return found

    def band(self, jacobian: Array) -> Array:
        """Returns half the height of the confidence band of a curve with this Jacobian, shape [m, n]; NaN without
        one.
        """
        free = np.array(self.is_known)
        if self.quantile is None or not free.any() or any(not known and not bound for known, bound in zip(self.is_known, self.at_bound)):
            return np.full(len(jacobian), np.nan)
        part, among = jacobian[:, free], self.covariance[np.ix_(free, free)]
        half: Array = self.quantile * np.sqrt(np.maximum(0.0, np.einsum("ij,jk,ik->i", part, among, part)))
        return half


def certainty_of(
    parameters: Sequence[VariedParameter], places: Array, jacobian: Array, residuals: Array, confidence: float
) -> Certainty:
    """Computes the errors from `jacobian`, the derivatives of weighted residuals with respect to the positions, shape
    [m, n].
    """
    from scipy.special import stdtrit

    at_bound = tuple("low" if u < _AT_BOUND else "high" if u > 1 - _AT_BOUND else "" for u in places)
    free = np.array([not bound for bound in at_bound])
    n, freedom = len(parameters), len(residuals) - int(free.sum())
    covariance, known = np.zeros((n, n)), free.copy()
    sentences = [_bound_sentence(one, side) for one, side in zip(parameters, at_bound) if side]
    if free.any():
        part = jacobian[:, free]
        names = [one.path for one, is_free in zip(parameters, free) if is_free]
        _, sizes, ways = np.linalg.svd(part, full_matrices=False)
        untold = _untold(sizes, ways, len(names))
        if untold.any():
            sentences.append(_untold_sentence([name for name, is_untold in zip(names, untold) if is_untold]))
            known[free] = np.logical_not(untold)
        if freedom > 0:
            variance = float(np.sum(residuals**2)) / freedom
            inverse = np.linalg.pinv(part.T @ part, rcond=_SINGULAR**2, hermitian=True) * variance
            covariance[np.ix_(free, free)] = inverse
            sentences += _close_sentences(names, inverse, untold)
        else:
            sentences.append(f"There are {len(residuals)} points and {int(free.sum())} parameters, so their errors cannot be estimated.")
            known[:] = False
    quantile = float(stdtrit(freedom, 0.5 + confidence / 2)) if freedom > 0 else None
    certainty = Certainty(covariance, quantile, at_bound, tuple(bool(one) for one in known), tuple(sentences))
    return Certainty(covariance, quantile, at_bound, certainty.is_known, (*sentences, *_uncertain_sentences(parameters, certainty)))


def _untold(sizes: Array, ways: Array, count: int) -> Array:
    """Returns the parameters in combinations that do not change the curve."""
    found = np.zeros(count, dtype=bool)
    largest = sizes.max(initial=0.0)
    for size, way in zip(sizes, ways):
        if size <= _SINGULAR * largest or largest == 0:
            found |= np.abs(way) > 0.1
    return found if len(sizes) == count else np.ones(count, dtype=bool)


def _bound_sentence(one: VariedParameter, side: str) -> str:
    value = one.low if side == "low" else one.high
    return (
        f"{one.path} is at its {'lower' if side == 'low' else 'upper'} bound, {value:g}: the best value may lie beyond it, or the curve may not determine it. " "It has no error, and the errors of the others are those for this value."
    )


def _untold_sentence(names: list[str]) -> str:
    if len(names) == 1:
        return f"{names[0]} has no effect at the measured creepages: remove it, or measure where it matters."
    return f"{' and '.join(names)} cannot be determined separately by this curve: a change of one can be compensated by the others. Remove some of them."


def _close_sentences(names: list[str], covariance: Array, untold: Array) -> list[str]:
    sizes = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    found = []
    for i, first in enumerate(names):
        for j in range(i):
            if untold[i] or untold[j] or not sizes[i] * sizes[j]:
                continue
            correlation = covariance[i, j] / (sizes[i] * sizes[j])
            if abs(correlation) > _CLOSE:
                found.append(
                    f"{names[j]} and {first} can hardly be determined separately by this curve: their errors have a correlation of " f"{correlation:.4f}."
                )
    return found


def _uncertain_sentences(parameters: Sequence[VariedParameter], certainty: Certainty) -> list[str]:
    if certainty.quantile is None:
        return []
    uncertain = []
    for one, variance, known in zip(parameters, np.diag(certainty.covariance), certainty.is_known):
        if known and certainty.quantile * np.sqrt(variance) > 0.5:
            uncertain.append(f"The confidence interval of {one.path} is wider than its bounds: this curve hardly determines it.")
    return uncertain

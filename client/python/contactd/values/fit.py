"""Holds fitted parameters of a measured creep curve, and their uncertainty."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .arrays import Array
from .registry import extra
from .representation import Rows, Shown, number

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["Fit", "FittedCurve", "FittedParameter"]


@dataclass(frozen=True)
class FittedParameter:
    """One parameter.

    Attributes:
        path: Path of its field, such as ``friction.layer.flexibility``.
        value: Fitted value.
        start: Start of the search.
        low: Lower bound.
        high: Upper bound.
        is_logarithmic: Whether its logarithm was varied, as for parameters with positive bounds.
        standard_error: Standard error of the value; None if it is at a bound or the curve does not determine it.
        interval: Confidence interval, not limited to the bounds; None in the same cases.
        at_bound: "low" or "high" if the value is at this bound, otherwise empty. A value beyond the bound may fit
            better.
    """

    path: str
    value: float
    start: float
    low: float
    high: float
    is_logarithmic: bool
    standard_error: float | None = None
    interval: tuple[float, float] | None = None
    at_bound: str = ""


@dataclass(frozen=True, eq=False)
class FittedCurve:
    """The fitted curve and its confidence band.

    Attributes:
        creepage: Creepages.
        value: Traction coefficient or force there.
        low: Lower edge of the band; NaN if there is none.
        high: Upper edge of the band.
    """

    creepage: Array
    value: Array
    low: Array
    high: Array


@dataclass(frozen=True, eq=False, repr=False)
class Fit(Shown):
    """Parameters of friction fitted to a measured curve by least squares. Check `converged`, and read `warnings`.

    Attributes:
        parameters: The parameters with their errors, also available as `fit["friction.mu"]`.
        correlation: Correlation of the parameters' errors, shape [n, n]; NaN for parameters at bounds or undetermined
            by the curve.
        creepage: Measured creepages.
        measured: Measured values.
        computed: The same for the fitted values; all solves converged.
        residuals: Measured minus computed values.
        rms: Root of the mean square of the residuals, weighted as in the search.
        confidence: Probability of intervals and bands.
        converged: Whether the search converged before the limit of its evaluations.
        reason: Reason for its end.
        evaluations: Number of curves that the search computed.
        solves: Total number of solved contact problems.
        params: The problem with the fitted values, as parameters of contact.solve.
        quantity: "coefficient" or "force".
        by: Path of the creepage.
        curve: The fitted curve at requested creepages.
        warnings: Sentences about limitations of the fit.
    """

    parameters: tuple[FittedParameter, ...]
    correlation: Array
    creepage: Array
    measured: Array
    computed: Array
    residuals: Array
    rms: float
    confidence: float
    converged: bool
    reason: str
    evaluations: int
    solves: int
    params: Mapping[str, Any]
    quantity: str
    by: str
    curve: FittedCurve | None = None
    warnings: tuple[str, ...] = ()

    def __getitem__(self, path: str) -> FittedParameter:
        for one in self.parameters:
            if one.path == path:
                return one
        raise KeyError(path)

    def plot(self, axes: Axes | None = None) -> Axes:
        """Plots points, curve and band. Needs matplotlib ("contactd[pictures]")."""
        drawn: Axes = extra("Fit.plot")(self, axes)
        return drawn

    def _rows(self) -> Rows:
        found: Rows = [(one.path, _summary(one)) for one in self.parameters]
        return [*found, ("rms", self.rms), ("converged", "yes" if self.converged else "NO")]

    def _remarks(self) -> tuple[str, ...]:
        return self.warnings


def _summary(one: FittedParameter) -> str:
    error = "" if one.standard_error is None else f" +- {one.standard_error:.2g}"
    return f"{number(one.value)}{error}{', at its bound' if one.at_bound else ''}"

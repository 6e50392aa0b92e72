"""Parameters found for a measured creep curve, and how well the curve tells them."""

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
        path: Its field, such as ``friction.layer.flexibility``.
        value: The value found.
        start: Where the search began.
        low: Least value allowed.
        high: Largest value allowed.
        is_logarithmic: Whether its logarithm was varied, as is of those that are positive throughout.
        standard_error: Standard error of the value, None where it is at a bound or the curve does not tell it.
        interval: Confidence interval, None likewise; not cut at the bounds.
        at_bound: "low" or "high" where the value is at this bound, else empty: the curve may ask for more.
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
    """The curve by the values found, and its confidence band.

    Attributes:
        creepage: Creepages.
        value: Traction coefficient or force there.
        low: Lower edge of the band; NaN where there is none.
        high: Upper edge of the band.
    """

    creepage: Array
    value: Array
    low: Array
    high: Array


@dataclass(frozen=True, eq=False, repr=False)
class Fit(Shown):
    """Parameters of friction found for a measured curve, by least squares. Ask `converged`, and read `warnings`.

    Attributes:
        parameters: The parameters with their errors: `fit["friction.mu"]` is one of them.
        correlation: Correlation of the parameters' errors, shape [n, n]; NaN of those at bounds, and of what the curve does
            not tell.
        creepage: Measured creepages.
        measured: Measured values.
        computed: The same by the values found; all solves converged.
        residuals: Measured less computed values.
        rms: Root of the mean square of the residuals, weighted as in the search.
        confidence: Probability of intervals and bands.
        converged: Whether the search came to its end, and did not stop at the bound of its evaluations.
        reason: How it ended.
        evaluations: Number of curves that the search computed.
        solves: Number of contact problems that were solved in all.
        params: The problem with the values found, as contact.solve takes it.
        quantity: "coefficient" or "force".
        by: Path of the creepage.
        curve: The curve in between, where asked for.
        warnings: Sentences that a user should know.
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
        """Draws points, curve and band. Needs matplotlib ("contactd[pictures]")."""
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

"""Solves the scalar equation of a step: the force that fits both the law of the contact and the motion that it causes.

With d the approach of the contact, c the local compliance, and D = d + c F(d), a step has D = a - b G, b > 0. G is the
force of the step: for "mean" that of both its ends, for "linear" that at the end, and for "gradient" the change of the
energy U(d) + c F^2/2 over that of D, which conserves energy. The left side less the right side increases with a slope of
at least 1, so that its root is unique, with or without contact, and every trial bounds it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from ..errors import Aborted, status_error
from .laws import Hertz, Law

__all__ = ["Scheme", "StepEquation", "gradient_force"]

Scheme = Literal["mean", "linear", "gradient"]

_MOST_TRIALS = 60
_ROUNDING = 1e-13


@dataclass
class StepEquation:
    """The equation of a step, and the count of its trials.

    Attributes:
        law: The law of the contact.
        tolerance: Largest error of the force of a solved step (N).
        trials: Trials of all steps.
        most_trials: Largest number of trials of a step.
        residual: Largest remaining error of a step's force (N).
        slope: Derivative of the last force (N/m), the start for laws without derivatives.
    """

    law: Law
    tolerance: float
    trials: int = 0
    most_trials: int = 0
    residual: float = 0.0
    slope: float = 1e9

    def solve(self, a: float, b: float, c: float, x: float, start: float, share: float, before: tuple[float, float] | None) -> tuple[float, float, float]:
        """Returns approach and force at the end of a step, and the force G of the step.

        Args:
            a: The end without a force (m).
            b: Its change by a unit force G (m/N).
            c: The local compliance (m/N).
            x: The position (m).
            start: First trial of d (m).
            share: Share of the force at the end in G: 1/2 or 1.
            before: Approach and force at the beginning: for share 1 those of the discrete gradient, or None; for share
                1/2 the force is the other half of G.
        """
        law = self.law
        is_gradient = share == 1 and before is not None
        other = before[1] * (1 - share) if before is not None and not is_gradient else 0.0
        d, low, high = start, float("-inf"), a
        last: tuple[float, float] | None = None
        for trial in range(1, _MOST_TRIALS + 1):
            force, slope = law.force(d, x, trial > 1)
            if slope is None:
                slope = self.slope if last is None or last[0] == d else max((force - last[1]) / (d - last[0]), 0.0)
                if force > 0 and slope == 0:
                    slope = self.slope
            last = (d, force)
            if force > 0:
                self.slope = slope
            mean = gradient_force(law, before, (d, force), c) if is_gradient and before is not None else share * force + other
            error = d + c * force + b * mean - a
            weight = c + b * (0.5 if is_gradient else share)
            if abs(error) <= self.tolerance * weight + _ROUNDING * (abs(a) + abs(d)):
                self.trials += trial
                self.most_trials = max(self.most_trials, trial)
                self.residual = max(self.residual, abs(error) / weight)
                return d, force, mean
            low, high = (max(low, d - error), d) if error > 0 else (d, min(high, d - error))
            found = d - error / (1 + weight * slope)
            d = found if low <= found <= high and found != d else 0.5 * (low + high)
        raise status_error(Aborted.code, f"The force of the step at x = {x:g} m did not converge in {_MOST_TRIALS} trials.", reason="NOT_CONVERGED")


def gradient_force(law: Law, before: tuple[float, float], after: tuple[float, float], c: float) -> float:
    """Returns the change of U + c F^2/2 over that of d + c F, without cancellation for Hertz's law."""
    (d0, f0), (d1, f1) = before, after
    if isinstance(law, Hertz) and d0 > 0 and d1 > 0:
        p, q, constant = d1**0.5, d0**0.5, law.constant
        of_energy = 0.4 * constant * sum(p**i * q ** (4 - i) for i in range(5)) + 0.5 * c * constant**2 * sum(p**i * q ** (5 - i) for i in range(6))
        return float(of_energy / (p + q + c * constant * (p * p + p * q + q * q)))
    across = d1 + c * f1 - d0 - c * f0
    if across == 0:
        return 0.5 * (f0 + f1)
    return (law.energy(d1) + 0.5 * c * f1**2 - law.energy(d0) - 0.5 * c * f0**2) / across

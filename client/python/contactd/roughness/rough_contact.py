"""Full solves of a contact with a rough surface that moves through it, where the first order does not hold."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
import numpy.typing as npt

from ..calls.answer_warnings import ContactWarning
from ..errors import invalid
from ..values.arrays import Array
from ..values.generated.grid import Paraboloid
from ..values.generated.problem import ContactProblem
from ..values.hertz import Load, ellipse_of_axes
from .filters import Weights
from .records import Record

if TYPE_CHECKING:
    from ..client import Client

__all__ = ["RoughRun", "chi_of", "heights_at", "roll_over"]

Surface = Record | Callable[[Array, Array], Array]

_LARGEST_CHI = 0.3
_TAPS = 8  #: Number of samples on each side of an interpolated place.


@dataclass(frozen=True, eq=False)
class RoughRun:
    """The contact at each place of a rough surface, at constant force.

    Attributes:
        x: Places of the surface at the middle of the contact (mm), shape [places].
        roughness: Effective roughness: the approach of the smooth contact minus that of the rough one (mm).
        areas: Area in contact over that of the smooth contact.
    """

    x: Array
    roughness: Array
    areas: Array

    @property
    def record(self) -> Record:
        """The effective roughness as a record, for uniform places."""
        return Record(float(np.mean(np.diff(self.x))), self.roughness, np.zeros(1), float(self.x[0]))


def chi_of(record: Record, weights: Weights, Fn: float, *, across: Literal["isotropic", "alike"] = "isotropic") -> float:
    """Returns chi = E* g/(2 pm) at a force (N), and warns (ContactWarning) above 0.3: there the filter to first order errs
    by a decibel and more.

    g is the rms slope of the surface: that of a map is computed, that of one line is multiplied by sqrt(2) if the surface
    is isotropic. pm = Fn/(pi a b), with semi-axes from the second moments of the weights, and E* follows from these and
    the stiffness. chi increases with the finest waves of the record. Raises InvalidArgument if the stiffness is unknown.
    """
    if weights.stiffness is None:
        raise invalid("weights.stiffness", "= None: chi depends on the stiffness. Use weights of hertz_weights or of a computed contact.")
    slope = float(np.mean((np.diff(record.heights, axis=1) / record.spacing) ** 2))
    if len(record.y) > 1:
        slope += float(np.mean((np.diff(record.heights, axis=0) / np.diff(record.y)[:, None]) ** 2))
    elif across == "isotropic":
        slope *= 2
    a, b = weights.semi_axes
    modulus = weights.stiffness * ellipse_of_axes(a, b, Load(1.0, True, 1.0)).approach / 1.5
    chi = modulus * math.sqrt(slope) * math.pi * a * b / (2 * Fn)
    if chi > _LARGEST_CHI:
        sentence = f"chi = {chi:.2g}: the filter to first order errs by 1 dB and more above {_LARGEST_CHI}. Solve the contact at each place with roll_over."
        warnings.warn(ContactWarning(sentence), stacklevel=2)
    return chi


def roll_over(
    client: Client,
    problem: ContactProblem,
    surface: Surface,
    places: npt.ArrayLike,
    *,
    on_progress: Callable[[float, str], None] | None = None,
) -> RoughRun:
    """Solves a contact with a rough surface at each place, at the force Fn of the problem, as steps of one session.

    The gap is h = h0 - r. `surface` is a record or map, before the circle of EN 15610 is rolled over it, or a function
    that returns heights (mm) at x and y of the same shape. The surface at the middle of the contact is that at each of
    the `places` (mm). Elements of 0.5 mm resolve waves down to 4 mm. One line is taken as alike across. Heights are
    exact for waves of a record longer than about three samples, linear across between lines, and constant beyond them.

    `on_progress` receives the fraction done and a text after each step; an exception in it ends the run. Raises
    InvalidArgument if the problem prescribes no force, and if places are too close to the ends of a record.
    """
    along = np.atleast_1d(np.asarray(places, dtype=float))
    if along.ndim != 1 or not np.isfinite(along).all():
        raise invalid("places", "= an array that is not a list of finite numbers: give one x for each solve (mm).")
    if problem.Fn is None:
        raise invalid("problem.Fn", "= None: the force is kept while the surface moves. Give Fn instead of an approach.")
    x, y = np.meshgrid(problem.grid.x, problem.grid.y)
    smooth = _smooth_gap(problem, x, y)
    found = np.empty((2, len(along)))
    normal = ContactProblem(
        problem.grid, problem.upper, smooth, lower=problem.lower, ics=problem.ics, upper_ics=problem.upper_ics, lower_ics=problem.lower_ics,
        columns=problem.columns, sheet_flexibility=problem.sheet_flexibility, normal=problem.normal, Fn=problem.Fn,
    )  # fmt: skip
    with client.session(normal) as session:
        level = session.step()
        for i, place in enumerate(along):
            heights = heights_at(surface, problem.grid.x + place, problem.grid.y) if isinstance(surface, Record) else surface(x + place, y)
            # A gap must not be negative; the constant is part of the approach.
            gap = smooth - np.asarray(heights, dtype=float)
            lowest = float(gap.min())
            step = session.step(gap=gap - lowest)
            if step.elements.border:
                raise invalid("problem.grid", f"= a contact that reaches its border at x = {place:g} mm: the grid must contain the contact. Use a larger grid.")
            found[:, i] = level.approach - step.approach - lowest, step.area.contact / level.area.contact
            if on_progress is not None:
                on_progress((i + 1) / len(along), f"place {i + 1} of {len(along)}")
    return RoughRun(along, found[0], found[1])


def heights_at(record: Record, x: Array, y: Array) -> Array:
    """Returns the heights of a record at x and y (mm), shape [y, x]. Raises InvalidArgument beyond its ends."""
    place = (np.asarray(x) - record.start) / record.spacing
    first = np.floor(place).astype(int) - _TAPS + 1
    if first.min() < 0 or first.max() + 2 * _TAPS > record.heights.shape[1]:
        margin = _TAPS * record.spacing
        raise invalid("places", f"= {x.min():g} to {x.max():g} mm with the contact: the record must extend {margin:g} mm beyond. Use places between its ends.")
    # Lines of a map beyond the contact cost time only.
    low, high = np.searchsorted(record.y, [y.min(), y.max()])
    near = slice(max(0, low - 1), high + 1)
    taps = first[:, None] + np.arange(2 * _TAPS)
    offset = place[:, None] - taps
    weights = np.sinc(offset) * np.sinc(offset / _TAPS)
    weights /= weights.sum(axis=1, keepdims=True)
    lines = np.einsum("lxt,xt->lx", record.heights[near][:, taps], weights)
    shares = np.stack([np.interp(y, record.y[near], line) for line in np.eye(len(lines))])
    return np.asarray(shares.T @ lines)


def _smooth_gap(problem: ContactProblem, x: Array, y: Array) -> Array:
    if isinstance(problem.gap, Paraboloid):
        curves = [0.0 if radius is None else 0.5 / radius for radius in (problem.gap.Rx, problem.gap.Ry)]
        return np.asarray(curves[0] * x**2 + curves[1] * y**2)
    gap = np.asarray(problem.gap)
    if gap.dtype.kind not in "fiu" or gap.shape != problem.grid.shape:
        raise invalid("problem.gap", "= neither a paraboloid nor an array: heights cannot be subtracted from it. Give radii or distances in each element.")
    return gap.astype(float)

"""Element arrays for output files, for basic contact and for patches on rails."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from ...values.generated.friction import InterfacialLayer
from ...values.generated.grid import Grid
from ...values.generated.motion import TemperatureFriction
from ...values.solution import Solution

__all__ = ["Elements", "ahead", "displacement_of", "division_of", "friction_at", "law_of", "layer_of", "plastic_elements", "rigid_slip_on", "temperature_of"]

Floats = npt.NDArray[np.float64]
Pair = tuple[Floats, Floats]
#: Change, reference and range of friction by temperature: numbers, or a column by rows.
Law = tuple[Any, Any, Any]

_ADHESION, _SLIP, _PLASTIC = 1, 2, 3
_SHIFT, _TRANSIENT, _STEADY = 1, 2, 3  #: T


@dataclass(frozen=True, eq=False)
class Elements:
    """Arrays over the grid, shape [ny, nx].

    Attributes:
        grid: The elements.
        tangential: The digit T.
        is_frictionless: Whether the case has no adhesion and slip.
        chi: Rolling direction (rad).
        division: 0 exterior, 1 adhesion, 2 slip, 3 plastic; without friction all elements adhere.
        h: Undeformed distance without the approach (mm).
        approach: The approach (mm).
        mu: Friction coefficient, at the temperature if it depends on that, otherwise the static one.
        pressure: Pressure (N/mm^2).
        traction: Tractions along x and y (N/mm^2).
        slip: Slip along x and y: the distance in a shift (mm), the relative slip in rolling.
        rigid_slip: The same for undeformed bodies, without the motion that prescribed forces require.
        displacement: Displacements of body 1 minus those of body 2, shape [3, ny, nx] (mm).
        layer: Yield stress (N/mm^2) and plastic slip along x and y (mm) of a yielding layer, accumulated by its particles.
        temperature: Surface temperatures of body 1 and body 2 (degrees Celsius); None if not requested.
        found: The creepages or the shift (mm) that prescribed forces require, in addition to rigid_slip.
    """

    grid: Grid
    tangential: int
    is_frictionless: bool
    chi: float
    division: npt.NDArray[np.uint8]
    h: Floats
    approach: float
    mu: Floats
    pressure: Floats
    traction: Pair
    slip: Pair
    rigid_slip: Pair
    displacement: Floats
    layer: tuple[Floats, Floats, Floats] | None = None
    temperature: Pair | None = None
    found: tuple[float, float] = (0.0, 0.0)

    @cached_property
    def traction_size(self) -> Floats:
        """Returns the size of the tangential traction (N/mm^2)."""
        return np.hypot(*self.traction)

    @cached_property
    def bound(self) -> Floats:
        """Returns the traction bound (N/mm^2). The traction of a slipping element equals it for every friction law."""
        return np.where(self.division >= _SLIP, self.traction_size, self.mu * self.pressure)


def division_of(solution: Solution[Any, Any], shape: tuple[int, int], rubs: bool = True) -> npt.NDArray[np.uint8]:
    """Returns the division of the program, in which slipping elements are not plastic even if the layer has flowed
    before, and all elements adhere without friction.
    """
    division: npt.NDArray[np.uint8] | None = solution.element_division
    if division is None:
        return np.zeros(shape, np.uint8)
    if not rubs:
        return np.minimum(division, _ADHESION).astype(np.uint8)
    if solution.slip_x is None or solution.slip_y is None:
        return division
    slips = np.hypot(solution.slip_x, solution.slip_y) > 0
    return np.where((division == _PLASTIC) & slips, _SLIP, division).astype(np.uint8)


def layer_of(
    solution: Solution[Any, Any], layer: InterfacialLayer | None, grid: Grid, tangential: int, chi: float, dq: float,
    before: Pair | None = None,
) -> tuple[Floats, Floats, Floats] | None:  # fmt: skip
    """Returns yield stress and plastic slip as in Elements; None without a yielding layer. `before` is the plastic slip
    at the start of the step.
    """
    if layer is None or solution.flow_x is None or solution.flow_y is None:
        return None
    stress = solution.yield_stress
    if stress is None:
        stress = np.full(grid.shape, layer.yield_stress or 0.0)
    upstream = -1 if math.cos(chi) > 0 else 1
    if tangential == _STEADY and solution.element_division is not None:
        stress = _carried(stress, solution.element_division > 0, layer.yield_stress or 0.0, upstream)

    def accumulated(flow: Floats, brought: Floats) -> Floats:
        if tangential == _STEADY:
            return np.asarray(np.cumsum(flow[:, ::upstream], axis=1)[:, ::upstream] * grid.dx)
        if tangential == _TRANSIENT:
            brought = _one_step_ahead(brought, grid, dq * math.cos(chi), dq * math.sin(chi))
        sums = brought + flow * (1.0 if tangential == _SHIFT else dq)
        return sums if solution.element_division is None else np.where(solution.element_division > 0, sums, 0.0)

    before = before or (np.zeros(grid.shape), np.zeros(grid.shape))
    return stress, accumulated(solution.flow_x, before[0]), accumulated(solution.flow_y, before[1])


def _carried(stress: Floats, inside: npt.NDArray[np.bool_], entering: float, upstream: int) -> Floats:
    """Returns the yield stress in steady rolling. Particles keep theirs behind the contact."""
    carried = np.array(stress, dtype=float)
    columns = range(carried.shape[1])[::upstream]
    brought: Floats = np.full(carried.shape[0], entering)
    for column in columns:
        brought = np.where(inside[:, column], carried[:, column], brought)
        carried[:, column] = brought
    return carried


def _one_step_ahead(values: Floats, grid: Grid, step_x: float, step_y: float) -> Floats:
    """Returns values at the places of particles one step ago, by bilinear interpolation; 0 beyond the grid."""
    ny, nx = values.shape
    x, y = np.arange(nx) + step_x / grid.dx, np.arange(ny) + step_y / grid.dy
    left, below = np.floor(x).astype(int), np.floor(y).astype(int)
    padded = np.zeros((ny + 2, nx + 2))
    padded[:ny, :nx] = values

    def at(rows: npt.NDArray[np.int_], columns: npt.NDArray[np.int_]) -> Floats:
        inside = [np.where((i < 0) | (i >= size), size, i) for i, size in ((rows, ny), (columns, nx))]
        return np.asarray(padded[np.ix_(*inside)])

    u, v = (x - left)[None, :], (y - below)[:, None]
    lower = (1 - u) * at(below, left) + u * at(below, left + 1)
    upper = (1 - u) * at(below + 1, left) + u * at(below + 1, left + 1)
    return np.asarray((1 - v) * lower + v * upper)


def friction_at(mu: Floats, law: Law | None, temperature: Floats | None) -> Floats:
    """Returns the coefficients at the surface temperature of body 1 (degrees Celsius)."""
    if law is None or temperature is None:
        return mu
    change, reference, span = law
    return np.asarray(mu + change * np.clip((temperature - reference) / span, 0.0, 1.0))


def law_of(friction: TemperatureFriction | None) -> Law | None:
    """Returns the law that friction follows."""
    return None if friction is None else (friction.change, friction.reference, friction.range)


def plastic_elements(solution: Solution[Any, Any]) -> tuple[int, int]:
    """Returns the numbers of slipping and of plastic elements."""
    if not solution.elements.flow:
        return solution.elements.slip, 0
    assert solution.element_division is not None
    plastic = int(np.count_nonzero(division_of(solution, solution.element_division.shape) == _PLASTIC))
    return solution.elements.slip + solution.elements.flow - plastic, plastic


def rigid_slip_on(grid: Grid, creepage: tuple[float, float], phi: float, centre: tuple[float, float]) -> Pair:
    """Returns the rigid slip of a plane that moves by `creepage` at `centre` and rotates by `phi`."""
    x, y = grid.x[None, :] - centre[0], grid.y[:, None] - centre[1]
    none = np.zeros(grid.shape)
    return creepage[0] - phi * y + none, creepage[1] + phi * x + none


def ahead(dq: float, chi: float, spin_offset: float) -> tuple[float, float]:
    """Returns the distance ahead of an element's centre at which its spin is evaluated (mm)."""
    return spin_offset * dq * math.cos(chi), spin_offset * dq * math.sin(chi)


def temperature_of(solution: Solution[Any, Any]) -> Pair | None:
    """Returns the surface temperatures of body 1 and body 2 (degrees Celsius)."""
    upper, lower = solution.upper_temperature, solution.lower_temperature
    return None if upper is None or lower is None else (upper, lower)


def displacement_of(solution: Solution[Any, Any]) -> Floats:
    """Returns the displacements of body 1 minus those of body 2, shape [3, ny, nx] (mm); zero if the solution has
    none.
    """
    arrays = (solution.displacement_x, solution.displacement_y, solution.displacement_z)
    assert solution.pressure is not None
    none = np.zeros(solution.pressure.shape)
    return np.stack([none if array is None else array for array in arrays])

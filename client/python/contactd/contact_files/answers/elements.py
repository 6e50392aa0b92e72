"""Element arrays for output files, for basic contact and for patches on rails."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from ...values.friction import InterfacialLayer
from ...values.grid import Grid
from ...values.solution import Solution

__all__ = ["Elements", "ahead", "displacement_of", "division_of", "layer_of", "plastic_elements", "rigid_slip_on", "temperature_of"]

Floats = npt.NDArray[np.float64]
Pair = tuple[Floats, Floats]

_ADHESION, _SLIP, _PLASTIC = 1, 2, 3
_SHIFT, _STEADY = 1, 3  #: T


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
        mu: Static coefficient of friction.
        pressure: Pressure (N/mm^2).
        traction: Tractions along x and y (N/mm^2).
        slip: Slip along x and y: the distance in a shift (mm), the relative slip in rolling.
        rigid_slip: The same for undeformed bodies.
        displacement: Displacements of body 1 minus those of body 2, shape [3, ny, nx] (mm).
        layer: Yield stress (N/mm^2) and plastic slip along x and y (mm) of a yielding layer: in steady rolling
            accumulated since particles entered the contact, otherwise that of the step.
        temperature: Surface temperatures of body 1 and body 2 (degrees Celsius); None if not requested.
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
    solution: Solution[Any, Any], layer: InterfacialLayer | None, grid: Grid, tangential: int, chi: float, dq: float
) -> tuple[Floats, Floats, Floats] | None:
    """Returns yield stress and plastic slip as in Elements; None without a yielding layer."""
    if layer is None or solution.flow_x is None or solution.flow_y is None:
        return None
    stress = solution.yield_stress
    if stress is None:
        stress = np.full(grid.shape, layer.yield_stress or 0.0)
    upstream = -1 if math.cos(chi) > 0 else 1

    def accumulated(flow: Floats) -> Floats:
        if tangential != _STEADY:
            return flow if tangential == _SHIFT else flow * dq
        return np.asarray(np.cumsum(flow[:, ::upstream], axis=1)[:, ::upstream] * grid.dx)

    return stress, accumulated(solution.flow_x), accumulated(solution.flow_y)


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

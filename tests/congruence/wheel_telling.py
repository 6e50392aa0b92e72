"""Defines the output of every driver for a wheel on its rail.

After the case's name and that of the call, and the step's number in a session: height, pitch rate, clearance; forces in
track, rail and wheelset coordinates; derivatives by y, z, roll, yaw and by x, y, z, roll, yaw, pitch; whether it
converged; the deflection of a flexible rail; iterations, residual and whether that is enough, of the searches for z, for
the pitch rate and for the deflection; number and digest of warnings; number of patches. Of each its reference and angle; grid; creepages and velocity; radii; Fn, Fx, Fs,
Mn; forces in the three coordinates; approach, pmax; areas; counts; digests of the arrays, the gap behind them.

The search alone: height, clearance, warnings, places. Of each reference and angle, grid, approach, creepages, radii.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from congruence.telling import ARRAYS, bits, digest, halves, whole

__all__ = ["told", "told_geometry"]

WRENCH = ("Fx", "Fy", "Fz", "Mx", "My", "Mz")
BY = (("position", ("y", "z", "roll", "yaw")), ("velocity", ("x", "y", "z", "roll", "yaw", "pitch")))


def of_wrenches(wrenches: list[Any]) -> Iterator[str]:
    for wrench in wrenches:
        yield from (bits(None if wrench is None else getattr(wrench, name)) for name in WRENCH)


def warnings(said: tuple[str, ...]) -> Iterator[str]:
    yield whole(len(said))
    yield str(digest(iter("".join(said).encode())))


def corner(at: float | None, count: int, size: float) -> float:
    """Of the grid, only the position of element 0 is printed; that of a centred grid is omitted."""
    return -0.5 * count * size if at is None else at


def of_place(place: Any) -> Iterator[str]:
    at, grid, creep, radii = place.reference, place.grid, place.creepages, place.radii
    yield from map(bits, (at.x, at.y, at.z, at.angle))
    yield from map(whole, (grid.nx, grid.ny))
    yield from map(bits, (grid.dx, grid.dy, corner(grid.x0, grid.nx, grid.dx), corner(grid.y0, grid.ny, grid.dy)))
    yield from map(bits, (creep.xi, creep.eta, creep.phi, creep.velocity))
    for radius in (radii.wheel_along, radii.wheel_across, radii.rail_along, radii.rail_across):
        yield bits(math.inf if radius is None else radius)


def told(wheel: Any) -> Iterator[str]:
    yield from map(bits, (wheel.z, wheel.pitch_rate, wheel.clearance))
    yield from of_wrenches([wheel.forces.track, wheel.forces.rail, wheel.forces.wheelset])
    derived = wheel.derivatives
    yield from of_wrenches([None if derived is None else getattr(getattr(derived, by), x) for by, names in BY for x in names])
    yield whole(wheel.converged)
    deflection = wheel.rail_deflection
    yield from map(bits, (None, None) if deflection is None else (deflection.y, deflection.z))
    for evidence in (wheel.force, wheel.pitch_search, wheel.rail_search):
        if evidence is None:
            yield from "---"
        else:
            yield from (whole(evidence.iterations), bits(evidence.residual), whole(evidence.converged))
    yield from warnings(wheel.warnings)
    yield whole(len(wheel.patches))
    for patch in wheel.patches:
        solution = patch.solution
        yield from of_place(patch.place)
        yield from map(bits, (solution.Fn, solution.Fx, solution.Fy, solution.Mz))
        yield from of_wrenches([patch.forces.track, patch.forces.rail, patch.forces.wheelset])
        yield from map(bits, (solution.approach, solution.pmax))
        yield from map(bits, (solution.area.contact, solution.area.adhesion, solution.area.slip, solution.area.flow))
        counts = solution.elements
        yield from map(whole, (counts.contact, counts.adhesion, counts.slip, counts.border))
        yield str(digest(iter(solution.element_division.ravel().tolist())))
        zero = np.zeros(patch.place.grid.shape)
        for array in (*(getattr(solution, name) for name in ARRAYS[1:]), patch.gap):
            yield str(digest(halves(zero if array is None else array)))


def told_geometry(geometry: Any) -> Iterator[str]:
    yield from map(bits, (geometry.z, geometry.clearance))
    yield from warnings(geometry.warnings)
    yield whole(len(geometry.places))
    for place in geometry.places:
        yield from of_place(place)
        yield bits(place.approach)

"""Defines the output of every driver for a case: a line for each call (start, step, again, save, restore, forget),
with the case, the call, and

* of one that was refused: "refused", the code, the reason, and the field;
* of a step: its number; Fn, Fx, Fy, Mz; approach; pmax; areas in contact, adhesion, slip; the elements of these, and at the
  border; creepages or shift; frictional work, and power; whether it converged; of each solver (normal, tangential, outer,
  force) iterations, residual, converged; elements across, errors of force, pmax, rolling; derivatives of Fx, Fy, Mz, Fn,
  approach by x, y, turn, load, mu; the number and digest of warnings; digests of the arrays;
  the resultant on curved columns.

Numbers are the 16 digits of their bits, "-" represents a missing value.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from typing import Any

import numpy as np

from contactd import Rolling

__all__ = ["ARRAYS", "told"]

ARRAYS = ("element_division", "pressure", "traction_x", "traction_y", "slip_x", "slip_y", "pressure_by_approach")
#: Inputs by which an answer may have derivatives, in order; shifts are pairs, and treated separately.
INPUTS = (("xi",), ("eta",), ("phi", "rotation"), ("approach", "Fn"), ("mu",))


def digest(values: Iterator[int]) -> int:
    total = 0
    for value in values:
        total = (total * 65599 + value) % 4294967291
    return total


def bits(value: float | None) -> str:
    return "-" if value is None else struct.pack(">d", value).hex().upper()


def whole(value: int | None) -> str:
    return "-" if value is None else str(int(value))


def halves(array: Any) -> Iterator[int]:
    for word in np.ascontiguousarray(array, "<f8").view("<u8").ravel().tolist():
        yield from (word >> 32, word & 0xFFFFFFFF)


def told(step: Any) -> Iterator[str]:
    yield whole(step.step)
    yield from map(bits, (step.Fn, step.Fx, step.Fy, step.Mz, step.approach, step.pmax))
    yield from map(bits, (step.area.contact, step.area.adhesion, step.area.slip, step.area.flow))
    yield from map(whole, (step.elements.contact, step.elements.adhesion, step.elements.slip, step.elements.border))
    match step.motion:
        case Rolling(xi=xi, eta=eta, phi=phi):
            yield from map(bits, (xi, eta, phi))
        case None:
            yield from "---"
        case shift:
            yield from map(bits, (*shift.rigid_shift, shift.rotation))
    yield from map(bits, (step.frictional_work, step.frictional_power))
    yield whole(step.converged)
    for solver in ("normal", "tangential", "outer", "force"):
        if (evidence := getattr(step.evidence, solver)) is None:
            yield from "---"
        else:
            yield from (whole(evidence.iterations), bits(evidence.residual), whole(evidence.converged))
    if (fine := step.evidence.discretisation) is None:
        yield from "----"
    else:
        yield whole(fine.elements_across)
        yield from map(bits, (fine.force_error, fine.pmax_error, fine.rolling_error or 0.0))
    yield from map(bits, derivatives(step))
    yield whole(len(step.warnings))
    yield str(digest(iter("".join(step.warnings).encode())))
    yield str(digest(iter(step.element_division.ravel().tolist())))
    for name in ARRAYS[1:]:
        array = getattr(step, name)
        yield str(digest(halves(np.zeros(step.pressure.shape) if array is None else array)))
    for name in ("Fx", "Fy", "Fz", "Mx", "My", "Mz"):
        yield bits(getattr(step.resultant, name, None))


def derivatives(step: Any) -> Iterator[float | None]:
    for of in ("Fx", "Fy", "Mz", "Fn", "approach"):
        by = getattr(step.derivatives, of, None)
        shift = getattr(by, "rigid_shift", None) or (None, None)
        for names, other in zip(INPUTS, (*shift, None, None, None)):
            found = [value for name in names if (value := getattr(by, name, None)) is not None]
            yield found[0] if found else other

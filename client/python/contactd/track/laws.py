"""Defines laws of the contact force: Hertz's, contactd's normal solution, and contactd's wheel on a rail.

A law returns the force (N) for an approach (m) at a position, and its derivative (N/m) or None. Forces must not decrease
with the approach.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from ..errors import invalid
from ..values.generated.wheel_rail.state import WheelRailState
from .checks import check_number, refused
from .irregularities import Irregularity, height_at

__all__ = ["ContactLaw", "Hertz", "Law", "WheelRailLaw"]

_MM = 1000.0
_FLATTEST = 0.005  #: Smallest variation of a gap (mm) over the grid.


class Law(Protocol):
    """The force of a contact."""

    has_energy: bool  #: Whether the force depends on the approach only, and `energy` is its integral.

    def force(self, approach: float, x: float, again: bool) -> tuple[float, float | None]:
        """Returns force (N) and derivative (N/m) at an approach (m) and a position (m); `again`: another trial of the
        same step.
        """

    def energy(self, approach: float) -> float:
        """Returns the elastic energy (J)."""


@dataclass(frozen=True)
class Hertz:
    """F = constant approach^1.5.

    Attributes:
        constant: C (N/m^1.5); steel wheels on rails have about 9e10.
    """

    constant: float

    has_energy = True

    def __post_init__(self) -> None:
        """Raises InvalidArgument for an invalid constant."""
        check_number("law.constant", self.constant, "N/m^1.5", 1e6, 1e14, "Steel has about 9e10; did you give N/mm^1.5?")

    def force(self, approach: float, x: float = 0.0, again: bool = False) -> tuple[float, float | None]:
        """Returns force (N) and derivative (N/m)."""
        if approach <= 0:
            return 0.0, 0.0
        root = approach**0.5
        return self.constant * root * approach, 1.5 * self.constant * root

    def energy(self, approach: float) -> float:
        """Returns the elastic energy (J)."""
        return float(0.4 * self.constant * max(approach, 0.0) ** 2.5)


class ContactLaw:
    """Solves the normal contact in each step, with a session of a contact (contactd.Session) without friction.

    Args:
        session: The session. Its bodies, grid and gap are those of the contact; x points in the direction of rolling.
        gap: Distance of the undeformed smooth surfaces [ny, nx] (mm), or None for the gap of the session. A gap is
            required with roughness.
        roughness: Irregularities whose heights lie along the middle of the contact, alike across. Each element gets the
            height at its own x, so that the contact filters the roughness itself; do not give these to `roll`, too.
        gap_at: Instead of both: a function that returns the gap [ny, nx] (mm) at a position (m), for maps of roughness.
    """

    has_energy = False

    def __init__(self, session: Any, gap: npt.ArrayLike | None = None, roughness: Sequence[Irregularity] = (),
                 gap_at: Callable[[float], npt.NDArray[np.float64]] | None = None) -> None:  # fmt: skip
        if not hasattr(session, "step") or not hasattr(session, "grid"):
            raise refused("session", session, "it must be a session of a contact. Open one by client.session().")
        if roughness and gap is None:
            raise invalid("gap", "is missing. Roughness requires the gap of the smooth surfaces.")
        if gap_at is not None and (gap is not None or roughness):
            raise invalid("gap_at", "is given beside gap or roughness. Give one of them.")
        shape = (session.grid.ny, session.grid.nx)
        self._smooth = None if gap is None else np.asarray(gap, dtype=np.float64)
        if self._smooth is not None and self._smooth.shape != shape:
            raise invalid("gap", f"has the shape {list(self._smooth.shape)}. The grid of the session requires {list(shape)}.")
        if self._smooth is not None and not np.ptp(self._smooth) > _FLATTEST:
            raise refused("gap", float(np.ptp(self._smooth)), f"it must vary by more than {_FLATTEST:g} mm. Gaps are in mm; did you give m?")
        self._session, self._roughness, self._gap_at = session, tuple(roughness), gap_at
        self._along = np.asarray(session.grid.x, dtype=np.float64) / _MM
        self._position, self._gap = float("nan"), self._smooth

    def force(self, approach: float, x: float, again: bool) -> tuple[float, float | None]:
        """Returns force (N) and derivative (N/m)."""
        gap = self._gap_of(x)
        if approach * _MM <= (0.0 if gap is None else float(gap.min())):
            return 0.0, 0.0
        given = {} if gap is None else {"gap": gap}
        solution = self._session.step(approach=approach * _MM, derivatives=True, **given)
        slope = solution.derivatives.Fn.approach
        return float(solution.Fn), None if slope is None else _MM * float(slope)

    def energy(self, approach: float) -> float:
        """Raises NotImplementedError: has_energy is False."""
        raise NotImplementedError

    def _gap_of(self, x: float) -> npt.NDArray[np.float64] | None:
        if x != self._position and (self._roughness or self._gap_at is not None):
            self._position = x
            if self._gap_at is not None:
                self._gap = np.asarray(self._gap_at(x), dtype=np.float64)
            elif self._smooth is not None:
                self._gap = self._smooth - _MM * height_at(self._roughness, x + self._along)
        return self._gap


class WheelRailLaw:
    """Solves a wheel on its rail in each step, with a session of contactd.wheel_rail, friction included.

    Args:
        session: The session (contactd.WheelRailSession).
        state: The state of the wheelset. Its `position.z` (mm) is that of an approach of 0; the approach is added to it.
    """

    has_energy = False

    def __init__(self, session: Any, state: WheelRailState) -> None:
        if not hasattr(session, "step") or not hasattr(session, "side"):
            raise refused("session", session, "it must be a session of a wheel on its rail. Open one by client.wheel_rail_session().")
        if state.position.z is None or state.Fz is not None:
            raise refused("state.position.z", state.position.z, "the height is prescribed. Give the z (mm) of an approach of 0, and no Fz.")
        self._session, self._state = session, state

    def force(self, approach: float, x: float, again: bool) -> tuple[float, float | None]:
        """Returns the vertical force (N) on the rail. Its derivative would take longer than a second solve."""
        z = (self._state.position.z or 0.0) + _MM * approach
        state = replace(self._state, position=replace(self._state.position, z=z))
        solution = self._session.step(state, patches=False, again=again and self._session.step_number > 0)
        return float(solution.forces.track.Fz), None if solution.contacts else 0.0

    def energy(self, approach: float) -> float:
        """Raises NotImplementedError: has_energy is False."""
        raise NotImplementedError

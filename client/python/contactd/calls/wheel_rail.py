"""Wheels on rails."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Literal

from ..errors import ProtocolError
from ..partial import Fields, names_of
from ..reading import read
from ..wheel_rail import WheelRailSetup, WheelRailState
from ..wheel_rail_params import setup_params, state_params
from ..wheel_rail_places import EquivalentConicity, WheelRailGeometry
from ..wheel_rail_solution import WheelRailSolution, read_wheel_rail
from .asking import Answering, asks
from .caller import Caller, ProgressCallback

__all__ = ["WheelRailCalls"]


class WheelRailCalls(Caller):
    """The methods wheelrail.* of the daemon."""

    @asks
    def wheel_rail(
        self,
        setup: WheelRailSetup,
        state: WheelRailState,
        *,
        fields: Fields | None = None,
        gap: bool = False,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[WheelRailSolution]:
        """The contact of a wheel with its rail: patches, and forces on the rail. `contactd.wheel_rail` says how to ask.

        `fields` names the arrays wanted back of each patch, as for `solve`; `gap` asks for the undeformed distances.
        A set-up that was asked for before costs less: the daemon keeps its profiles and operators. Raises InvalidArgument
        naming ``setup.track.gauge``, ``state.position.z``, ...
        """
        names = None if fields is None else names_of(fields)
        params: dict[str, Any] = {"setup": setup_params(setup), "state": state_params(state, "state")}
        if names is not None:
            params["fields"] = names
        if gap:
            params["gap"] = True
        result = yield from self.asked("wheelrail.solve", params, timeout=timeout, on_progress=on_progress, progress=progress)
        return read_wheel_rail(names, gap, result)

    @asks
    def wheel_rail_geometry(
        self,
        setup: WheelRailSetup,
        states: Iterable[WheelRailState],
        *,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[list[WheelRailGeometry]]:
        """Where a wheel touches its rail in 1 to 1000 states, without a solve: contact points, angles, radii, creepages.

        Where a state has Fz the wheelset stands at the height at which Hertz's theory expects that force.
        """
        listed = list(states)
        if not listed:
            return []
        given = [state_params(state, f"states[{index}]") for index, state in enumerate(listed)]
        params = {"setup": setup_params(setup), "states": given}
        result = yield from self.asked("wheelrail.geometry", params, timeout=timeout, on_progress=on_progress, progress=progress)
        geometries = result.get("geometries")
        if not isinstance(geometries, list) or len(geometries) != len(given):
            raise ProtocolError("The answer to wheelrail.geometry lacks a geometry for each state.")
        return [read(WheelRailGeometry, item, f"result.geometries[{i}]") for i, item in enumerate(geometries)]

    @asks
    def equivalent_conicity(
        self,
        setup: WheelRailSetup,
        amplitudes: Iterable[float],
        *,
        roll: Literal["demanded", "neglected"] | None = None,
        contact_distance: float | None = None,
        tolerance: float | None = None,
        timeout: float | None = None,
    ) -> Answering[list[EquivalentConicity]]:
        """The equivalent conicity of a wheelset with the profiles of the set-up on both sides, for 1 to 100 amplitudes
        (mm): integrated over the kinematic motion (EN 15302), and by the harmonic approximation.

        `roll` is "neglected" (default), by which a cone has its own conicity, or as both contacts demand. `contact_distance`
        is that between the contact points of both wheels (mm, default 1500), `tolerance` that of the radius difference
        (mm, default 1e-3).
        """
        given = {"roll": roll, "contact_distance": contact_distance, "tolerance": tolerance}
        wanted = {"amplitudes": list(amplitudes), **{name: v for name, v in given.items() if v is not None}}
        params = {"setup": setup_params(setup), "conicity": wanted}
        conicities = (yield from self.asked("wheelrail.geometry", params, timeout=timeout)).get("conicities")
        if not isinstance(conicities, list):
            raise ProtocolError("The answer to wheelrail.geometry lacks the conicities.")
        return [read(EquivalentConicity, item, f"result.conicities[{i}]") for i, item in enumerate(conicities)]

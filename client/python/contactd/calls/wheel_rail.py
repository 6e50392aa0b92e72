"""Wheels on rails."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from ..errors import ContactdError, ProtocolError
from ..transport.shared_client import shared_client
from ..values.answers import read
from ..values.solution import Fields, names_of
from ..values.wheel_rail.origins import Origin, remember
from ..values.wheel_rail.params import setup_params, state_params, wheelset_state_params
from ..values.wheel_rail.places import WheelRailGeometry
from ..values.wheel_rail.rigid_wheelset import (
    EquivalentConicity,
    PlacedProfiles,
    ProfilesOfSides,
    WheelsetContacts,
    WheelsetRoll,
)
from ..values.wheel_rail.setup import WheelRailSetup
from ..values.wheel_rail.solution import WheelRailSolution, WheelsetSolution, read_wheel_rail, read_wheelset
from ..values.wheel_rail.solved_states import remember_state
from ..values.wheel_rail.state import WheelRailState, WheelsetState
from .call import Answering, Waits, asks
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
        params = {"setup": setup_params(setup), "state": state_params(state, "state"), **_of_patches(names, gap)}
        result = yield from self.asked("wheelrail.solve", params, timeout=timeout, on_progress=on_progress, progress=progress)
        solution = read_wheel_rail(names, gap, result)
        remember(solution, Origin.of(setup, state, _profiles_by(self, setup)))
        remember_state(solution, state)
        return solution

    @asks
    def wheelset(
        self,
        setup: WheelRailSetup,
        state: WheelsetState,
        *,
        left: WheelRailSetup | None = None,
        fields: Fields | None = None,
        gap: bool = False,
        timeout: float | None = None,
        on_progress: ProgressCallback | None = None,
        progress: bool = False,
    ) -> Answering[WheelsetSolution]:
        """Both wheels of a wheelset that is free to roll: its height and its roll, at which each presses on its rail as the
        state says, with patches and forces of both.

        `setup` is that of both wheels, whatever its side; `left` that of the left wheel, where it differs. `fields` and `gap`
        are as for `wheel_rail`. Raises InvalidArgument naming ``setup.track.gauge``, ``left.rail.points``,
        ``state.left_rail.y``, ...
        """
        names = None if fields is None else names_of(fields)
        params = {"setup": setup_params(setup), "state": wheelset_state_params(state), **_of_patches(names, gap)}
        if left is not None:
            params["left"] = setup_params(left, "left")
        result = yield from self.asked("wheelrail.wheelset", params, timeout=timeout, on_progress=on_progress, progress=progress)
        return read_wheelset(names, gap, result)

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
    def wheelset_contacts(
        self,
        setup: WheelRailSetup,
        shifts: Iterable[float],
        *,
        left: WheelRailSetup | None = None,
        roll: WheelsetRoll | None = None,
        timeout: float | None = None,
    ) -> Answering[list[WheelsetContacts]]:
        """Where a rigid wheelset touches rigid rails at 1 to 1000 lateral shifts (mm): contact points, angles and rolling
        radii of both wheels. `left` is the set-up of the left side, where it differs.

        `roll` is "neglected" (default), where each wheel finds its own height, or "demanded" by both contacts. Raises
        InvalidArgument naming ``contacts.shifts[3]``, ``setup.track.gauge``, ``left.rail.points``, ...
        """
        requested: dict[str, Any] = {"shifts": [float(shift) for shift in shifts]}
        if roll is not None:
            requested["roll"] = roll
        contacts = yield from self._of_wheelset(setup, left, "contacts", requested, "contacts", timeout)
        return [read(WheelsetContacts, item, f"result.contacts[{i}]") for i, item in enumerate(contacts)]

    @asks
    def equivalent_conicity(
        self,
        setup: WheelRailSetup | Mapping[str, Any],
        amplitudes: Iterable[float],
        *,
        left: WheelRailSetup | None = None,
        roll: WheelsetRoll | None = None,
        contact_distance: float | None = None,
        tolerance: float | None = None,
        timeout: float | None = None,
    ) -> Answering[list[EquivalentConicity]]:
        """The equivalent conicity of a rigid wheelset for 1 to 100 amplitudes (mm): integrated over the kinematic motion
        (EN 15302), and by the harmonic approximation. `left` is the set-up of the left side, where it differs.

        `roll` is "neglected" (default), by which a cone has its own conicity, or as both contacts demand. `contact_distance`
        is that between the contact points of both wheels (mm, default 1500), `tolerance` that of the radius difference
        (mm, default 1e-3). The set-up may also be its parameters in the words of the wire.
        """
        given = {"roll": roll, "contact_distance": contact_distance, "tolerance": tolerance}
        requested = {"amplitudes": list(amplitudes), **{name: v for name, v in given.items() if v is not None}}
        conicities = yield from self._of_wheelset(setup, left, "conicity", requested, "conicities", timeout)
        return [read(EquivalentConicity, item, f"result.conicities[{i}]") for i, item in enumerate(conicities)]

    @asks
    def placed_profiles(
        self, setup: WheelRailSetup | Mapping[str, Any], *, left: WheelRailSetup | None = None, timeout: float | None = None
    ) -> Answering[ProfilesOfSides]:
        """The profiles of both sides as the daemon has read them, and where they lie: for whoever draws them, or wears them.
        The set-up may also be its parameters in the words of the wire."""
        profiles = yield from self._of_wheelset(setup, left, "profiles", True, "profiles", timeout)
        found = read(ProfilesOfSides, profiles, "result.profiles")
        if any(points.ndim != 2 or points.shape[1] != 2 for side in (found.left, found.right) for points in (side.wheel, side.rail)):
            raise ProtocolError("The answer to wheelrail.geometry has profiles whose points are no pairs.")
        return found

    def _of_wheelset(
        self,
        setup: WheelRailSetup | Mapping[str, Any],
        left: WheelRailSetup | None,
        question: str,
        requested: Any,
        answer: str,
        timeout: float | None,
    ) -> Answering[Any]:
        given = dict(setup) if isinstance(setup, Mapping) else setup_params(setup)
        params = {"setup": given, question: requested}
        if left is not None:
            params["left"] = setup_params(left, "left")
        result = yield from self.asked("wheelrail.geometry", params, timeout=timeout)
        if answer not in result:
            raise ProtocolError(f"The answer to wheelrail.geometry lacks the {answer}.")
        return result[answer]


def _profiles_by(client: WheelRailCalls, setup: WheelRailSetup) -> Callable[[], PlacedProfiles | None]:
    """Asks the client for the profiles of the side, or that of the package where it is gone, closed or must be awaited."""
    asked = weakref.ref(client)

    def profiles() -> PlacedProfiles | None:
        there: Any = asked()
        if there is None or there.is_closed or not isinstance(there, Waits):  # an AsyncClient must be awaited
            there = _shared_client()
        if there is None:
            return None
        both: ProfilesOfSides = there.placed_profiles(setup)
        return both.left if setup.side == "left" else both.right

    return profiles


def _shared_client() -> Any:
    """Returns the client of the package; None where nothing is installed that solves, or it may not be opened."""
    try:
        return shared_client()
    except ContactdError:
        return None


def _of_patches(names: list[str] | None, gap: bool) -> dict[str, Any]:
    """`fields` and `gap` of wheelrail.solve and wheelrail.wheelset."""
    return {**({} if names is None else {"fields": names}), **({"gap": True} if gap else {})}

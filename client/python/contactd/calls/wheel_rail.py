"""Calls for wheels on rails."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from ..errors import ContactdError, ProtocolError
from ..transport.shared_client import shared_client
from ..values.answers import read
from ..values.generated.wheel_rail.places import WheelRailGeometry
from ..values.generated.wheel_rail.rigid_wheelset import (
    EquivalentConicity,
    PlacedProfiles,
    ProfilesOfSides,
    WheelsetContacts,
    WheelsetRoll,
)
from ..values.generated.wheel_rail.setup import WheelRailSetup
from ..values.generated.wheel_rail.state import WheelRailState, WheelsetState
from ..values.solution import Fields, names_of
from ..values.wheel_rail.origins import Origin, remember
from ..values.wheel_rail.params import setup_params, state_params, wheelset_state_params
from ..values.wheel_rail.solution import WheelRailSolution, WheelsetSolution, read_wheel_rail, read_wheelset
from ..values.wheel_rail.solved_states import remember_state
from .call import Answering, Waits, asks
from .caller import Caller, ProgressCallback

__all__ = ["WheelRailCalls"]


class WheelRailCalls(Caller):
    """Calls the methods wheelrail.* of the daemon."""

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
        """Solves the contact of a wheel with its rail: patches, and forces on the rail. See `contactd.wheel_rail` for
        the arguments.

        `fields` names the arrays to return for each patch, as for `solve`; `gap` requests the undeformed distances.
        Repeated requests with the same set-up are faster, because the daemon keeps its profiles and operators. Raises
        InvalidArgument naming the field, such as ``setup.track.gauge`` or ``state.position.z``.
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
        """Solves both wheels of a wheelset with free roll. Computes the height and roll at which each wheel has its
        prescribed vertical force, with patches and forces of both.

        `setup` is that of both wheels, whatever its side; `left` is the set-up of the left wheel if it differs.
        `fields` and `gap` are as for `wheel_rail`. Raises InvalidArgument naming the field, such as
        ``setup.track.gauge``, ``left.rail.points`` or ``state.left_rail.y``.
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
        """Computes the contact geometry of 1 to 1000 states without a solve: contact points, angles, radii, creepages.

        If a state has Fz, the height is that at which Hertz's theory yields this force.
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
        """Computes the contacts of a rigid wheelset on rigid rails at 1 to 1000 lateral shifts (mm): contact points,
        angles and rolling radii of both wheels. `left` is the set-up of the left side if it differs.

        `roll` is "neglected" (default: each wheel has its own height) or "demanded" by both contacts. Raises
        InvalidArgument naming the field, such as ``contacts.shifts[3]``, ``setup.track.gauge`` or ``left.rail.points``.
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
        """Computes the equivalent conicity of a rigid wheelset for 1 to 100 amplitudes (mm), by integration of the
        kinematic motion (EN 15302) and by the harmonic approximation. `left` is the set-up of the left side if it
        differs.

        `roll` is "neglected" (default: the conicity of a cone is exact) or "demanded" by both contacts.
        `contact_distance` is the distance between the contact points of both wheels (mm, default 1500), `tolerance`
        that of the radius difference (mm, default 1e-3). The set-up may also be given as parameters on the wire.
        """
        given = {"roll": roll, "contact_distance": contact_distance, "tolerance": tolerance}
        requested = {"amplitudes": list(amplitudes), **{name: v for name, v in given.items() if v is not None}}
        conicities = yield from self._of_wheelset(setup, left, "conicity", requested, "conicities", timeout)
        return [read(EquivalentConicity, item, f"result.conicities[{i}]") for i, item in enumerate(conicities)]

    @asks
    def placed_profiles(
        self, setup: WheelRailSetup | Mapping[str, Any], *, left: WheelRailSetup | None = None, timeout: float | None = None
    ) -> Answering[ProfilesOfSides]:
        """Returns the profiles of both sides as read by the daemon, and their positions, for plots and wear. The set-up
        may also be given as parameters on the wire.
        """
        profiles = yield from self._of_wheelset(setup, left, "profiles", True, "profiles", timeout)
        found = read(ProfilesOfSides, profiles, "result.profiles")
        if any(points.ndim != 2 or points.shape[1] != 2 for side in (found.left, found.right) for points in (side.wheel, side.rail)):
            raise ProtocolError("The answer to wheelrail.geometry has profiles whose points are not pairs.")
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
    """Requests the profiles of the side from the client, or from the default client if that one is gone, closed or
    asyncio.
    """
    asked = weakref.ref(client)

    def profiles() -> PlacedProfiles | None:
        there: Any = asked()
        if there is None or there.is_closed or not isinstance(there, Waits):  # Calls of an AsyncClient must be awaited.
            there = _shared_client()
        if there is None:
            return None
        both: ProfilesOfSides = there.placed_profiles(setup)
        return both.left if setup.side == "left" else both.right

    return profiles


def _shared_client() -> Any:
    """Returns the default client; None if no solver is installed, or it may not be opened."""
    try:
        return shared_client()
    except ContactdError:
        return None


def _of_patches(names: list[str] | None, gap: bool) -> dict[str, Any]:
    """Returns `fields` and `gap` of wheelrail.solve and wheelrail.wheelset."""
    return {**({} if names is None else {"fields": names}), **({"gap": True} if gap else {})}

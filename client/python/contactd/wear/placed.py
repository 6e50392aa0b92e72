"""Keeps positions of the profiles of a study, computed by the daemon for the new ones; they are not changed later."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from ..values.generated.profile_shapes import ProfilePoints
from ..values.generated.wheel_rail.rigid_wheelset import ProfilesOfSides
from ..values.params import params_of
from ..values.wheel_rail.params import STEEL

__all__ = ["StudyPlace", "WheelRailClient"]

Array = npt.NDArray[np.float64]

_RADIUS = 460.0  #: Default nominal radius (mm).


class WheelRailClient(Protocol):
    """The calls of a client that wear needs: a Client, or any object with these calls."""

    @property
    def call(self) -> Any: ...
    @property
    def placed_profiles(self) -> Any: ...
    @property
    def equivalent_conicity(self) -> Any: ...


class StudyPlace:
    """Holds new profiles, and the positions of their origins.

    Attributes:
        points: (y, z) of the new wheel and rail (mm).
        wheel_origin, rail_origin: Origins of the profiles, from the middle of the axle and in the track (mm).
    """

    def __init__(self, profiles: ProfilesOfSides, setup: Mapping[str, Any]) -> None:
        """Reads the answer to `placed_profiles` for a set-up as on the wire."""
        placed = getattr(profiles, setup.get("side", "right"))
        self._track = dict(setup.get("track", {}))
        self.points: dict[str, Array] = {part: np.asarray(getattr(placed, part), dtype=np.float64) for part in ("wheel", "rail")}
        self.left = setup.get("side") == "left"
        self.wheel_origin = float(placed.wheel_origin)
        self.rail_origin = (float(placed.rail_origin.y), float(placed.rail_origin.z))
        self.radius = float(setup.get("wheelset", {}).get("nominal_radius", _RADIUS))
        self.modulus = _modulus(setup.get("bodies", {}))

    def profiles(self, points: Mapping[str, Array]) -> dict[str, Any]:
        """Returns the fields of a set-up with sections of these points."""
        fields: dict[str, Any] = {}
        if "wheel" in points:
            fields["wheel"] = params_of(ProfilePoints(points["wheel"]))
        if "rail" in points:
            y, z = self.rail_origin
            track = {**self._track, "rail_origin": {"y": y, "z": z}, "cant": 0.0}
            fields.update(rail=params_of(ProfilePoints(points["rail"])), track=track)
        return fields


def _modulus(bodies: Mapping[str, Any]) -> float:
    """Returns E*, with 1/E* = sum (1 - nu)/(2 G)."""
    upper = bodies.get("upper", params_of(STEEL))
    both = (upper, bodies.get("lower", upper))
    return 1 / sum(float((1 - body["nu"]) / (2 * body["G"])) for body in both if "G" in body)

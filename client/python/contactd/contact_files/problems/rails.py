"""A case of a wheel on a rail (module 1) as a set-up and a state of contactd, by the conventions of the CONTACT program."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ...values.generated.evidence import SolverSettings
from ...values.generated.grid import Grid
from ...values.generated.profile_shapes import Profile
from ...values.generated.wheel_rail.setup import (
    PatchRules,
    RailSprings,
    SlopeForces,
    Track,
    WheelRailFriction,
    WheelRailSetup,
    Wheelset,
    WheelSurface,
)
from ...values.generated.wheel_rail.state import (
    RailDeviation,
    WheelDeviation,
    WheelRailState,
    WheelsetPosition,
    WheelsetVelocity,
)
from .bodies import pair_of, sheet_of
from .features import Missing, missing
from .frictions import coefficients_of_sets, layer
from .heat import temperature_by_angle, temperature_friction, thermal_bodies
from .models import models_of, without_memory
from .solvers import solver_settings

if TYPE_CHECKING:
    from ...values.generated.contact_files import ContactCase as Case

__all__ = ["Profiles", "RailContact", "Slices"]

Slices = Sequence[tuple[Any, ...]]
#: The profile that a case names, or its slices and their spline: of "RAIL" or "WHEEL", by its values.
Profiles = Callable[["Case", str], "Profile | tuple[Slices, str]"]

_ROLLER, _RIGHT = 4, 1
_SHIFT, _TRANSIENT = 1, 2
_OF_DISPLACEMENTS = 3  # variants of half-spaces that turn
_HALF_PLANE = 4  #: D: contact that follows the surfaces
_BY_ELEMENTS = (3, 4)  #: D: slip by the motion of both surfaces
_OF_FORCE = 1e-6  #: contactd's own tolerance of the search for a force
_NEAR = 1e-6  #: by how much distances that are the same to the program are apart here (mm)
_OF_DEVIATION = {
    "x": "DXWHL", "y": "DYWHL", "z": "DZWHL", "roll": "DROLLW", "yaw": "DYAWW",
    "x_velocity": "VXWHL", "y_velocity": "VYWHL", "z_velocity": "VZWHL",
    "roll_velocity": "VROLLW", "yaw_velocity": "VYAWW", "pitch_velocity": "VPITCHW",
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class RailContact:
    """A case made ready.

    Attributes:
        case: What was read.
        setup: Profiles, track, friction and elements.
        state: Position and motion.
        friction_unit: The coefficient at rest that shares of forces are printed by; None where angles decide.
    """

    case: Case
    setup: WheelRailSetup
    state: WheelRailState
    friction_unit: float | None

    @classmethod
    def of(cls, case: Case, profiles: Profiles, wheel_surface: WheelSurface) -> RailContact:
        """Raises Missing for what contactd does not have, and OSError for a profile that cannot be read."""
        if names := missing(case):
            raise Missing(", ".join(names))
        values = case.values
        friction = _friction(case) if case.digits["T"] != 0 else None
        pair, surfaces = pair_of(values), _surfaces(case, profiles)
        setup = WheelRailSetup(
            side="right" if case.digits["C1"] % _ROLLER == _RIGHT else "left",
            upper=pair.upper, lower=pair.lower, track=_track(case), wheelset=_wheelset(values), friction=friction,
            dx=values["DX"], dy=values["DS"], patches=_patches(values), wheel_surface=wheel_surface,
            dq=_step(case), rigid_slip="elements" if values["DISCNS"] in _BY_ELEMENTS else None, conformal=_conformal(values),
            **surfaces, **_settings(values), **models_of(case), slope_forces=_slope_forces(case, surfaces),
            sheet_flexibility=sheet_of(case),
            temperature=thermal_bodies(case),
        )  # fmt: skip
        unit = friction.mu if friction is not None and isinstance(friction.mu, float) else None
        return cls(case, setup, _state(case), unit)

    @property
    def is_shift(self) -> bool:
        """Tells whether the step is one."""
        return self.state.motion == "shift"

    def step_on(self, grid: Grid) -> float:
        """The step rolls so far on the elements of a patch (mm); a shift has 1, as the program prints DQ."""
        if self.is_shift:
            return 1.0
        return grid.dx if self.setup.dq is None else float(self.setup.dq)


def _step(case: Case) -> float | None:
    """The step rolls so far (mm), where that is not an element, as steady rolling has it."""
    share = case.values["DQREL"]
    return share * case.values["DX"] if case.digits["T"] == _TRANSIENT and share != 1 else None


def _surfaces(case: Case, profiles: Profiles) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for name in ("rail", "wheel"):
        surface = profiles(case, name.upper())
        if isinstance(surface, tuple):
            found[f"{name}_slices"], found[f"{name}_spline"] = surface
        else:
            found[name] = surface
    return found


def _slope_forces(case: Case, surfaces: Mapping[str, Any]) -> SlopeForces | None:
    """The program's forces do not follow the slope of a rail or a roller along the track."""
    return "none" if case.digits["C1"] >= _ROLLER or "rail_slices" in surfaces else None


def _track(case: Case) -> Track:
    values = case.values
    outwards = 1 if case.digits["C1"] % _ROLLER == _RIGHT else -1
    places: dict[str, Any] = {}
    if values["GAUGHT"] > 0:
        places = {"gauge": values["GAUGWD"], "gauge_height": values["GAUGHT"]}
    else:
        places = {"rail_origin": (outwards * values["RAILY0"], values["RAILZ0"] + _sunk(case))}
    cant = values.get("CANT", 0.0)
    if case.digits["C1"] >= _ROLLER:
        return Track(cant=cant, roller_radius=values["NOMRADR"], roller_leans=_leans(case) or None, **places)
    springs = None
    if case.digits["F"] == 3 and (values["KYRAIL"] > 0 or values["KZRAIL"] > 0):
        springs = RailSprings(y=values["KYRAIL"] or None, z=values["KZRAIL"] or None)
    return Track(cant=cant, springs=springs, **places)


def _leans(case: Case) -> bool:
    """Tells whether a roller's surface leans, by its deviation or its cant; what it turns about does not."""
    return case.digits["C1"] >= _ROLLER and any(case.values.get(name, 0) != 0 for name in ("DROLLR", "CANT"))


def _sunk(case: Case) -> float:
    """By how much a roller lies deeper, whose axle goes along with its deviation (mm)."""
    is_whole = case.digits["C1"] >= _ROLLER and case.values["GAUGHT"] <= 0 and not _leans(case)
    return float(case.values["DZRAIL"]) if is_whole else 0.0


def _wheelset(values: Any) -> Wheelset:
    """Only where the wheel's profile lies along the axle matters, so that distances that no flanges have become others."""
    distance, position = values["FBDIST"], values["FBPOS"]
    if distance <= 0:
        distance, position = 1.0, 0.5 - max(distance / 2 - position, _NEAR)
    return Wheelset(flange_back_distance=distance, flange_back_position=position, nominal_radius=values["NOMRADW"])


def _patches(values: Any) -> PatchRules:
    """The rules of patches; distances and angles of 0 part all that can be parted."""
    combine = values["D_COMB"] or _NEAR
    separate = max(values["D_SEP"], combine + _NEAR)
    return PatchRules(
        angle_separate=min(values["A_SEP"] or _NEAR, math.pi), distance_combine=combine, distance_separate=separate,
        distance_turn=max(values["D_TURN"], separate + _NEAR), search="mesh" if values["DISCNS"] == 5 else None,
        history="whole", max_elements=values["NPOT_MAX"],
    )  # fmt: skip


def _conformal(values: Any) -> Any:
    if values["DISCNS"] != _HALF_PLANE:
        return None
    if values["INFLCF"] != _HALF_PLANE:
        return "half_space"
    return "rotated_displacements" if values["VARIANT"] == _OF_DISPLACEMENTS else "rotated"


def _settings(values: Any) -> dict[str, Any]:
    """The search for a force has the tolerance of the tractions."""
    force = {"force": SolverSettings(tolerance=values["EPS"])} if values["EPS"] < _OF_FORCE else {}
    return {**solver_settings(values), **force}


def _friction(case: Case) -> WheelRailFriction:
    values = case.values
    if values["VARFRC"] != 1:
        place = "X_WS" if case.digits["C1"] >= _ROLLER else "S_WS"
        sets = [_at_place(case.friction, values[place])] if values["VARFRC"] == 2 else case.friction[:1]
        (mu,), kinetic = coefficients_of_sets(values, sets)
        by_temperature = temperature_friction(values, sets)
        return WheelRailFriction(
            float(mu), kinetic=without_memory(case, kinetic), layer=layer(case), temperature=by_temperature
        )
    mus, kinetic = coefficients_of_sets(values, case.friction)
    angles = [one["ALPHVF"] + _angle_offset(case) for one in case.friction]
    return WheelRailFriction(
        list(zip(angles, mus)), along_profile=values["DISCNS"] == _HALF_PLANE or None,
        kinetic=without_memory(case, kinetic), layer=layer(case),
        **temperature_by_angle(values, angles, case.friction),
    )  # fmt: skip


def _angle_offset(case: Case) -> float:
    """Angles are those against the wheel's profile where the contact is a plane, and else against the track; contactd's are
    against the track, and of left wheels those of the mirror image."""
    if case.values["DISCNS"] == _HALF_PLANE:
        return 0.0
    roll = case.values["ROLL"]
    return float(roll if case.digits["C1"] % _ROLLER == _RIGHT else -roll)


def _at_place(sets: Sequence[Mapping[str, float]], place: float) -> dict[str, float]:
    """Between sets along the track, on straight lines; constant beyond."""
    along = [one["SVF"] for one in sets]
    return {name: float(np.interp(place, along, [one[name] for one in sets])) for name in sets[0] if name != "SVF"}


def _state(case: Case) -> WheelRailState:
    values, is_roller = case.values, case.digits["C1"] >= _ROLLER
    position = WheelsetPosition(
        x=0.0 if is_roller else values["S_WS"], y=values["Y_WS"], z=values.get("Z_WS", 0.0), roll=values["ROLL"],
        yaw=values["YAW"], pitch=values["PITCH"],
    )  # fmt: skip
    forwards = 0.0 if is_roller else values["VS"]
    velocity = WheelsetVelocity(
        x=forwards, y=values["VY"], z=values["VZ"], roll=values["VROLL"], yaw=values["VYAW"] + forwards * values["CURV"],
        pitch=values["VPITCH"] if "VPITCH" in values else _free_pitch_rate(values, forwards, is_roller),
    )  # fmt: skip
    others = {"Fy": values["FYRAIL"], "Fz": values["FZRAIL"]} if case.digits["F"] == 3 else {}
    rail = RailDeviation(
        y=values["DYRAIL"], z=values["DZRAIL"] - _sunk(case), roll=values["DROLLR"], y_velocity=values["VYRAIL"],
        z_velocity=values["VZRAIL"], roll_velocity=values["VROLLR"], **others,
    )  # fmt: skip
    return WheelRailState(
        position=position, velocity=velocity, wheel=_deviation(values, velocity), rail=rail, roller_pitch=values["RPITCH"] if is_roller else 0.0,
        Fz=values.get("FZ"), Fx=values.get("FX") if case.digits["F"] == 1 else None, **_motion(case.digits["T"]),
    )  # fmt: skip


def _motion(tangential: int) -> dict[str, Any]:
    """Velocities of a shift are increments, those of a second."""
    if tangential == _SHIFT:
        return {"motion": "shift", "time_step": 1.0}
    return {"motion": "transient_rolling"} if tangential == _TRANSIENT else {}


def _deviation(values: Any, velocity: WheelsetVelocity) -> WheelDeviation:
    """That of a flexible wheelset. Those of an earlier case stay in force, whatever E says; DPITCHW has no effect. In a
    plane a wheel that is displaced along the track turns about the axle of the rigid wheelset; contactd's turns about an
    axle that goes along with it."""
    by = {field: values.get(name, 0.0) for field, name in _OF_DEVIATION.items()}
    if by["x"] != 0 and values["DISCNS"] not in _BY_ELEMENTS:
        by["y_velocity"] += by["x"] * velocity.yaw
        by["z_velocity"] -= by["x"] * velocity.pitch
    return WheelDeviation(**by)


def _free_pitch_rate(values: Any, forwards: float, is_roller: bool) -> float:
    """Where the search for the pitch rate that brings Fx starts."""
    if is_roller:
        return float(-values["RPITCH"] * values["NOMRADR"] / values["NOMRADW"])
    return float(-forwards / values["NOMRADW"])

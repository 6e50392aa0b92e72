"""A wheel on a rail: what all steps of a simulation have in common. Lengths in mm, angles in rad, forces in N on the rail.

What is None takes the daemon's default.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal, TypedDict

from ...refusals import public
from ..dictionaries import Saved
from ..evidence import Model, SolverSettings
from ..friction import KineticFriction
from ..materials import Material, RigidBody
from ..profiles import Profile

if TYPE_CHECKING:
    from typing_extensions import Unpack


__all__ = ["PatchRules", "RailSprings", "Track", "WheelRailFields", "WheelRailFriction", "WheelRailSetup", "Wheelset"]

Side = Literal["left", "right"]
WheelSurface = Literal["exact", "bilinear"]
RigidSlipKind = Literal["plane", "surfaces"]
Conformal = Literal["off", "half_space", "rotated", "fem", "auto"]


@dataclass(frozen=True)
class RailSprings:
    """Between a rail without mass and the ground; it is rigid in a direction that has none.

    Attributes:
        y: Stiffness sideways (N/mm).
        z: Stiffness downwards (N/mm).
    """

    y: float | None = None
    z: float | None = None


@dataclass(frozen=True)
class Track:
    """Where the rails lie.

    Attributes:
        gauge: Between the gauge faces (mm); default 1435.
        gauge_height: How far below the tops the gauge is measured (mm); default 14.
        cant: Of the rail's profile as given, leaning inwards where positive (rad); default 0.
        rail_origin: (y, z) of the origin of the rail's profile, y to the field side from the centre of the track (mm);
            gauge and gauge_height mean nothing then.
        roller_radius: A roller turns under the wheel in place of the rail: its radius where the profile has z = 0 (mm).
        springs: On which the rail gives way to the forces on it; None: it is rigid.
    """

    gauge: float | None = None
    gauge_height: float | None = None
    cant: float | None = None
    rail_origin: tuple[float, float] | None = None
    roller_radius: float | None = None
    springs: RailSprings | None = None


@dataclass(frozen=True)
class Wheelset:
    """Where the wheels sit on their axle.

    Attributes:
        flange_back_distance: Between the backs of the flanges (mm); default 1360.
        flange_back_position: y of the flange's back in the wheel's profile (mm); default -70.
        nominal_radius: Of the wheel where its profile has z = 0 (mm); default 460.
    """

    flange_back_distance: float | None = None
    flange_back_position: float | None = None
    nominal_radius: float | None = None


@dataclass(frozen=True)
class PatchRules:
    """What becomes of regions of overlap that lie close to each other (mm, rad): docs/wheel-rail.md.

    Attributes:
        angle_separate: Patches of their own where the planes' angles differ by more; default pi/2.
        distance_separate: Parts of one patch, which feel a share of each other, below; default 8.
        distance_combine: One patch below; default 4.
        distance_turn: Planes that turn towards each other below; default 12.
        locus_step: Of the locus across the track, in elements dy; default 0.3.
        search: How regions of overlap are found: along the locus, where the distance along the track is least, or on a
            mesh seen from above, for rails that curve along the track, too; default "locus".
    """

    angle_separate: float | None = None
    distance_separate: float | None = None
    distance_combine: float | None = None
    distance_turn: float | None = None
    locus_step: float | None = None
    search: Literal["locus", "mesh"] | None = None


@dataclass(frozen=True)
class WheelRailFriction:
    """Coulomb friction, the same everywhere or by the angle of the rail's surface.

    ::

        WheelRailFriction(0.3)
        WheelRailFriction([(-1.2, 0.1), (-0.4, 0.3)])  # less at the gauge face

    Attributes:
        mu: (Static) coefficient, or pairs (angle from the horizontal, coefficient), ascending, with straight lines
            between; angles are negative on the gauge side (rad).
        along_profile: Whether the angle is that of the rail at each row of elements; default: that of the patch.
        kinetic: How it falls with the slip velocity; None: it does not.
    """

    mu: float | Sequence[tuple[float, float]] = 0.3
    along_profile: bool | None = None
    kinetic: KineticFriction | None = None


@dataclass(frozen=True, eq=False, kw_only=True)
class WheelRailSetup(Saved):
    """A wheel on a rail: what all steps of a simulation have in common. The daemon keeps what it prepared for one, so
    that the next step with an equal set-up costs less.

    Attributes:
        side: Which wheel of the wheelset, seen in the direction of travel: "right" (default) or "left".
        wheel: The wheel's profile; default S1002().
        rail: The rail's profile; default Rail60E1(1 / 40).
        rail_slices: In place of `rail` where it varies along the track: pairs (x, profile), by ascending x (mm), in the
            same coordinates. Needs Track.rail_origin.
        wheel_slices: In place of `wheel` where it is not round: pairs (angle, profile), by ascending angles within a turn
            (rad), in the same coordinates; at pitch p the slice of angle -p is lowest.
        track: Where the rails lie.
        wheelset: Where the wheels sit.
        upper: Material of the rail; default steel (G 82000, nu 0.28).
        lower: Material of the wheel; None: as the rail.
        model: "full" (default): boundary elements; "hertz", "fastsim".
        friction: Default 0.3; None: frictionless.
        dx: Size of the elements along x, in the plane of a contact (mm); default 0.2.
        dy: Size of the elements across (mm); default 0.2.
        dq: Step of rolling (mm); default: dx.
        patches: How regions of overlap are merged.
        wheel_surface: "exact" (default), or "bilinear" between corners of a mesh as large as the elements.
        rigid_slip: By the creepages of the reference, as in a "plane" (default), or by the motion of both "surfaces" at
            each row of elements: for conformal contact, of model "full".
        conformal: "off" (default): a contact lies in a plane. Otherwise it is curved across the track, half-way between
            wheel and rail, with the coefficients of half-spaces, flat ("half_space") or turned from row to row
            ("rotated"), or of both cross-sections by finite elements ("fem", whose tables are built when they are first
            needed); "auto": rotated where a plane would be left by more than 0.24 rad, else off. Of model "full".
        normal: Stop test of NORM, for the pressures.
        tangential: Stop test for the tractions.
        outer: Stop test of the loop that bodies that differ and kinetic friction need.
        force: Of the search for a height that brings Fz: |F - Fz|/Fz, default 1e-6, and solves, default 40.
    """

    side: Side | None = None
    wheel: Profile | None = None
    rail: Profile | None = None
    rail_slices: Sequence[tuple[float, Profile]] | None = None
    wheel_slices: Sequence[tuple[float, Profile]] | None = None
    track: Track | None = None
    wheelset: Wheelset | None = None
    upper: Material | RigidBody | None = None
    lower: Material | RigidBody | None = None
    model: Model | None = None
    friction: WheelRailFriction | None = WheelRailFriction()
    dx: float | None = None
    dy: float | None = None
    dq: float | None = None
    patches: PatchRules | None = None
    wheel_surface: WheelSurface | None = None
    rigid_slip: RigidSlipKind | None = None
    conformal: Conformal | None = None
    normal: SolverSettings | None = None
    tangential: SolverSettings | None = None
    outer: SolverSettings | None = None
    force: SolverSettings | None = None

    @public
    def replace(self, **changes: Unpack[WheelRailFields]) -> WheelRailSetup:
        """A copy with some fields changed."""
        return replace(self, **changes)


class WheelRailFields(TypedDict, total=False):
    """Of WheelRailSetup."""

    side: Side | None
    wheel: Profile | None
    rail: Profile | None
    rail_slices: Sequence[tuple[float, Profile]] | None
    wheel_slices: Sequence[tuple[float, Profile]] | None
    track: Track | None
    wheelset: Wheelset | None
    upper: Material | RigidBody | None
    lower: Material | RigidBody | None
    model: Model | None
    friction: WheelRailFriction | None
    dx: float | None
    dy: float | None
    dq: float | None
    patches: PatchRules | None
    wheel_surface: WheelSurface | None
    rigid_slip: RigidSlipKind | None
    conformal: Conformal | None
    normal: SolverSettings | None
    tangential: SolverSettings | None
    outer: SolverSettings | None
    force: SolverSettings | None

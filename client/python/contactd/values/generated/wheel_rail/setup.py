"""A wheel on a rail: the common part of all steps of a simulation. Lengths are in mm, angles in rad, forces in N on the
rail. None is the daemon's default.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Literal, TypedDict

from ....refusals import public
from ...dictionaries import Saved
from ..evidence import Model, NormalModel, SimplifiedSettings, SolverSettings
from ..fatigue import FatigueRequest
from ..friction import InterfacialLayer
from ..materials import Material, RigidBody
from ..motion import FrictionMemory, KineticFriction, TemperatureFriction
from ..profile_shapes import Profile
from ..thermal import ThermalBodies
from ..wear_laws import WearRequest

if TYPE_CHECKING:
    from typing_extensions import Unpack

__all__ = [
    "Conformal",
    "ContactSearch",
    "PatchHistory",
    "PatchRules",
    "RailSprings",
    "RigidSlipKind",
    "Side",
    "SliceSpline",
    "SlopeForces",
    "Track",
    "WheelRailFields",
    "WheelRailFriction",
    "WheelRailSetup",
    "WheelSurface",
    "Wheelset",
]

Side = Literal["left", "right"]
ContactSearch = Literal["locus", "mesh"]
PatchHistory = Literal["own", "whole"]
SliceSpline = Literal["shape_preserving", "cubic", "approximating"]
WheelSurface = Literal["exact", "bilinear"]
RigidSlipKind = Literal["plane", "surfaces", "elements"]
SlopeForces = Literal["pressure", "all", "none"]
Conformal = Literal["off", "half_space", "rotated", "fem", "auto", "rotated_displacements"]


@dataclass(frozen=True)
class WheelRailFriction:
    """Coulomb friction of a wheel on its rail: uniform, or by the angle of the rail's surface.

    ::

        WheelRailFriction(0.3)
        WheelRailFriction([(-1.2, 0.1), (-0.4, 0.3)])  # less at the gauge face

    Attributes:
        mu: (Static) coefficient of friction (>= 0): a single value, or values by the angle of the rail's surface from
            the horizontal (rad), ascending, with linear interpolation. Angles are negative on the gauge side.
        along_profile: True if the angle is that of the rail at each row of elements (model full), false if it is that
            of the patch. Default False.
        kinetic: Velocity-weakening (falling) friction, by the slip velocity v. If None, the coefficient is constant.
            linear: mu_k + m max(0, 1 - v / v_c); rational: mu_k + m / (1 + v / v_c); exponential: mu_k + m exp(-v /
            v_c). Here m = friction.mu - mu_k, minus the share of a second term.
        layer: A layer of a third body between the surfaces, for model full. Its shear deformation is flexibility times
            the traction. Where its yield stress is below the friction bound, it flows before the surfaces slip. The
            layer does not affect the normal problem.
        temperature: Temperature-dependent friction: mu + change min(1, max(0, (T - reference)/range)), where T is the
            surface temperature and mu is friction.mu. Requires temperature in the problem and model full. If None, the
            coefficient does not depend on temperature.
        temperature_by_angle: Replaces temperature if temperature-dependent friction varies over the rail: by the angle
            of the rail's surface like mu, ascending, with linear interpolation; for a patch, or for each row if
            along_profile is set.
        memory: Friction with memory for temperature_by_angle, the same at all angles. The coefficient of a particle
            follows the temperature law of its row over a slip distance, d mu/dt = -max(v, v_0) / d (mu - mu(T)), and
            starts from that of unheated surfaces where the particle enters the contact. If None, it follows at once.
            The memory of a single law is a part of the law.
    """

    mu: float | Sequence[tuple[float, float]] = field(default=0.3, metadata={"keys": ("angle", "mu")})
    along_profile: bool | None = None
    kinetic: KineticFriction | None = None
    layer: InterfacialLayer | None = None
    temperature: TemperatureFriction | None = None
    temperature_by_angle: Sequence[tuple[float, float, float, float]] | None = field(
        default=None, metadata={"keys": ("angle", "change", "reference", "range")}
    )
    memory: FrictionMemory | None = None


@dataclass(frozen=True)
class RailSprings:
    """Springs between a massless rail and the ground. The rail is rigid in a direction without a spring. If None, a
    rigid rail.

    Attributes:
        y: Stiffness sideways (N/mm), >= 0.001.
        z: Stiffness downwards (N/mm), >= 0.001.
    """

    y: float | None = None
    z: float | None = None


@dataclass(frozen=True)
class Track:
    """Position of the rails.

    Attributes:
        gauge: Distance between the gauge faces of the rails (mm), > 0. Default 1435.
        gauge_height: Distance below the tops of the rails at which the gauge is measured (mm), >= 0. Default 14.
        cant: Cant of the rail's profile, positive if leaning inwards (rad), -0.5 to 0.5. Default 0.
        rail_origin: Position of the origin of the rail's profile: y and z (mm) from the centre of the track to the
            field side, and down. With it, gauge and gauge_height are ignored. If None, they determine the position.
        roller_radius: Radius, at z = 0 of the profile, of a roller that turns under the wheel instead of a rail (mm), >
            0. If None, a rail.
        roller_leans: True if the surface of a roller has an axle that leans and moves with its profile, by rail.roll,
            rail.z and cant, while the roller turns about a level axle. Use it to compare with other programs. Otherwise
            only the profile leans, and the axle is level. Default False.
        springs: Springs between a massless rail and the ground. The rail is rigid in a direction without a spring. If
            None, a rigid rail.
    """

    gauge: float | None = None
    gauge_height: float | None = None
    cant: float | None = None
    rail_origin: tuple[float, float] | None = field(default=None, metadata={"keys": ("y", "z")})
    roller_radius: float | None = None
    roller_leans: bool | None = None
    springs: RailSprings | None = None


@dataclass(frozen=True)
class Wheelset:
    """Positions of the wheels on their axle.

    Attributes:
        flange_back_distance: Distance between the backs of the flanges (mm), > 0. Default 1360.
        flange_back_position: y of the flange's back in the wheel's profile (mm). Default -70.
        nominal_radius: Radius of the wheel at z = 0 of its profile (mm), > 0. Default 460.
    """

    flange_back_distance: float | None = None
    flange_back_position: float | None = None
    nominal_radius: float | None = None


@dataclass(frozen=True)
class PatchRules:
    """Rules for combining nearby regions of overlap by their distance. distance_combine < distance_separate <
    distance_turn.

    Attributes:
        angle_separate: Angle between the planes of two regions above which they are separate patches (rad), > 0, <=
            3.14159. Default 1.5707963267948966.
        distance_separate: Distance below which regions are parts of one patch with weighted interaction (mm), > 0.
            Default 8.
        distance_combine: Distance below which regions become one patch (mm), > 0. Default 4.
        distance_turn: Distance below which the planes of two patches are rotated towards each other (mm), > 0. Default
            12.
        locus_step: Step of the locus across the track, in elements dy (> 0, <= 1). Default 0.3.
        search: Search for regions of overlap: along the locus of smallest distance along the track, or on a mesh seen
            from above, for rails that curve along the track. Default "locus".
        history: Initial tractions of the parts of a patch that splits in a step that is not steady. own: each part
            starts with the tractions on its own elements. whole: each part starts with the tractions of the complete
            earlier patch, whose displacements act on it before the step and not behind it; for parts in planes, only
            the first part. Use whole to compare with other programs. Default "own".
        max_elements: Limit of elements of a patch of steady rolling. At or above it, elements become twice as long and
            as wide, in the directions with more than ten, until there are fewer. Use it to compare with other programs.
            0: elements keep their size, and too many are refused. Default 0.
    """

    angle_separate: float | None = None
    distance_separate: float | None = None
    distance_combine: float | None = None
    distance_turn: float | None = None
    locus_step: float | None = None
    search: ContactSearch | None = None
    history: PatchHistory | None = None
    max_elements: int | None = None


@dataclass(frozen=True, eq=False, kw_only=True)
class WheelRailSetup(Saved):
    """A wheel on a rail: the set-up that all steps of a simulation share. The daemon keeps its preparations for a
    set-up, so that the next step with an equal one costs less. Lengths in mm, angles in rad. Track coordinates have x
    forwards, y to the right, z down (drawn in docs/wheel-rail.md).

    Attributes:
        side: Side of the wheelset, seen in the direction of travel. Default "right".
        wheel: The wheel's profile, by default S1002.
        rail: The rail's profile, by default 60E1 with an inclination of 1/40.
        rail_slices: Profiles by ascending x, instead of rail, for a rail that varies along the track, in the same
            coordinates. Points at equal fractions of the length between features are connected, or between kinks if
            slices have no features; slices must all have the same number of them. Requires track.rail_origin. At most
            200000 points in total.
        wheel_slices: Profiles by ascending angles, instead of wheel, for an out-of-round wheel: in the same coordinates
            and cut at the same y. The angles lie within one revolution, after which the first profile follows again.
            Radii are interpolated with continuous curvature and without overshoot. At most 200000 points in total.
        track: Position of the rails.
        wheelset: Positions of the wheels on their axle.
        upper: Material of the rail; without bodies it is steel, G = 82000 and nu = 0.28.
        lower: Material of the wheel. If None, that of the rail.
        model: full: boundary elements. hertz: closed forms of elliptic contact. The models of vehicle codes, for steady
            rolling: fastsim, Kalker's simplified theory; fastrip, strip theory with FASTSIM in the slip area; polach,
            Polach's forces, without tractions and spin moment. Default "full".
        normal_model: Model of the pressures, as in contact.solve: of_model according to model; kp, kpec, analyn from
            the overlap of the undeformed surfaces, with model full, fastsim, fastrip or polach. Default "of_model".
        simplified: Options of the models fastsim, fastrip and polach, as in contact.solve.
        temperature: Thermal properties of rail (upper) and wheel (lower); requests surface temperatures in each patch
            separately. Requires steady rolling. None: no temperatures.
        wear: Laws of wear of rail (upper) and wheel (lower); requests wear of each patch separately. Requires steady
            rolling. None: no wear.
        fatigue: Requests rolling contact fatigue of rail (upper) or wheel (lower) in each patch separately. Requires
            steady rolling. None: no fatigue.
        sheet_flexibility: Flexibility of a thin sheet between rail and wheel, as in contact.solve (mm^3/N), >= 0.
            Requires model full. Default 0.
        friction: Coulomb friction, by default 0.3 everywhere; None: frictionless.
        dx: Size of the elements along x, in the plane of a contact (mm), 0.0001 to 100. Default 0.2.
        dy: Size of the elements across (mm), 0.0001 to 100. Default 0.2.
        dq: Step of rolling (mm), 0 to 100; 0: dx. Default 0.
        patches: Rules for combining nearby regions of overlap by their distance. distance_combine < distance_separate <
            distance_turn.
        rail_spline: Interpolation of the rail from slice to slice. shape_preserving and cubic pass through the slices,
            the latter with the oscillations of natural cubic splines. approximating is the cubic B-spline with the
            slices as control points; it does not pass through them and smooths noise. Default "shape_preserving".
        wheel_spline: Interpolation of the wheel from slice to slice, as for the rail. cubic and approximating splines
            are periodic. Default "shape_preserving".
        wheel_surface: The wheel surface: its splines, or bilinear interpolation between the corners of a mesh with the
            size of the elements. Use bilinear to compare with other programs. Default "exact".
        rigid_slip: Rigid slip, before the bodies deform. plane: from the creepages of the reference, as in a plane.
            surfaces: from the motion of both surfaces at each row of elements, for conformal contact, with model full.
            elements: from the motion at the middle of each element, projected on the plane as the surfaces lean along
            x, with the creepages that fit it best; use it to compare with other programs. Default "plane".
        slope_forces: Forces that follow the slope of a rail, or a roller, along the track, in track, rail and wheelset
            coordinates. pressure: pressures act along the normal of the rail's surface, and friction along the track's
            x. all: friction acts along the surface, too. none: neither, as if the rail were level; use it to compare
            with other programs. All three are the same on a straight rail. Default "pressure".
        conformal: Contact that is curved across the track, half-way between wheel and rail. off: one plane. Otherwise
            each row of elements has its own normal: gaps are measured along it, tractions are rotated, and slip is that
            of the surfaces. half_space: coefficients as if the rows lay flat. rotated: half-spaces rotated from row to
            row. fem: wheel and rail by their cross-sections, whose tables are built when they are first needed. auto:
            rotated where the contact deviates from a plane by more than 0.24 rad, otherwise off. rotated_displacements:
            half-spaces along the loaded row, of which only the displacements are rotated; use it to compare with other
            programs. Requires model full. Default "off".
        normal: Stopping criterion of NORM for the pressures, which all other results depend on. The default tolerance
            is 1e-8.
        tangential: Stopping criterion for the tractions under friction, and the solver that computes them.
        outer: Stopping criterion of the outer (Panagiotopoulos) iterations around these, which dissimilar bodies,
            kinetic friction and prescribed tangential forces require. The default limit is 100 iterations.
        force: Search for a height that produces Fz. The default bound of |F - Fz|/Fz is 1e-6, and that of solves is 40.
        accuracy: Largest deviation of forces over the normal force, and of largest values over these, from those with
            tight tolerances at the same height (1e-08 to 0.01); 1e-4 suits real time. It replaces the tolerances of
            settings and force.
    """

    side: Side | None = None
    wheel: Profile | None = None
    rail: Profile | None = None
    rail_slices: Sequence[tuple[float, Profile] | tuple[float, Profile, Sequence[float]]] | None = field(
        default=None, metadata={"keys": ("x", "profile", "features")}
    )
    wheel_slices: Sequence[tuple[float, Profile]] | None = field(default=None, metadata={"keys": ("angle", "profile")})
    track: Track | None = None
    wheelset: Wheelset | None = None
    upper: Material | RigidBody | None = field(default=None, metadata={"within": "bodies"})
    lower: Material | RigidBody | None = field(default=None, metadata={"within": "bodies"})
    model: Model | None = None
    normal_model: NormalModel | None = None
    simplified: SimplifiedSettings | None = None
    temperature: ThermalBodies | None = None
    wear: WearRequest | None = None
    fatigue: FatigueRequest | None = None
    sheet_flexibility: float | None = None
    friction: WheelRailFriction | None = WheelRailFriction()
    dx: float | None = None
    dy: float | None = None
    dq: float | None = None
    patches: PatchRules | None = None
    rail_spline: SliceSpline | None = None
    wheel_spline: SliceSpline | None = None
    wheel_surface: WheelSurface | None = None
    rigid_slip: RigidSlipKind | None = None
    slope_forces: SlopeForces | None = None
    conformal: Conformal | None = None
    normal: SolverSettings | None = field(default=None, metadata={"within": "settings"})
    tangential: SolverSettings | None = field(default=None, metadata={"within": "settings"})
    outer: SolverSettings | None = field(default=None, metadata={"within": "settings"})
    force: SolverSettings | None = None
    accuracy: float | None = None

    @public
    def replace(self, **changes: Unpack[WheelRailFields]) -> WheelRailSetup:
        """A copy with some fields changed."""
        return replace(self, **changes)


class WheelRailFields(TypedDict, total=False):
    """Keywords of WheelRailSetup."""

    side: Side | None
    wheel: Profile | None
    rail: Profile | None
    rail_slices: Sequence[tuple[float, Profile] | tuple[float, Profile, Sequence[float]]] | None
    wheel_slices: Sequence[tuple[float, Profile]] | None
    track: Track | None
    wheelset: Wheelset | None
    upper: Material | RigidBody | None
    lower: Material | RigidBody | None
    model: Model | None
    normal_model: NormalModel | None
    simplified: SimplifiedSettings | None
    temperature: ThermalBodies | None
    wear: WearRequest | None
    fatigue: FatigueRequest | None
    sheet_flexibility: float | None
    friction: WheelRailFriction | None
    dx: float | None
    dy: float | None
    dq: float | None
    patches: PatchRules | None
    rail_spline: SliceSpline | None
    wheel_spline: SliceSpline | None
    wheel_surface: WheelSurface | None
    rigid_slip: RigidSlipKind | None
    slope_forces: SlopeForces | None
    conformal: Conformal | None
    normal: SolverSettings | None
    tangential: SolverSettings | None
    outer: SolverSettings | None
    force: SolverSettings | None
    accuracy: float | None

"""A wheel on a rail: what all steps of a simulation have in common. Lengths in mm, angles in rad, forces in N on the
rail. What is None takes the daemon's default.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Literal, TypedDict

from ...refusals import public
from ..dictionaries import Saved
from ..evidence import Model, NormalModel, SimplifiedSettings, SolverSettings
from ..fatigue import FatigueRequest
from ..friction import InterfacialLayer
from ..materials import Material, RigidBody
from ..motion import KineticFriction, TemperatureFriction
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
    """Coulomb friction of a wheel on its rail: the same everywhere, or by the angle of the rail's surface.

    ::

        WheelRailFriction(0.3)
        WheelRailFriction([(-1.2, 0.1), (-0.4, 0.3)])  # less at the gauge face

    Attributes:
        mu: (Static) coefficient of friction (>= 0): one, or some by the angle of the rail's surface from the horizontal
            (rad), ascending, with straight lines between; angles are negative on the gauge side.
        along_profile: Whether the angle is that of the rail at each row of elements, or that of the patch; for model
            full. Default False.
        kinetic: Velocity-weakening (falling) friction, by the slip velocity v; None, the coefficient is constant.
            linear: mu_k + m max(0, 1 - v / v_c); rational: mu_k + m / (1 + v / v_c); exponential: mu_k + m exp(-v /
            v_c), with m = friction.mu - mu_k, less what a second term takes of it.
        layer: A layer of a third body between the surfaces, of model full: it shears by flexibility times the traction
            and, where its yield stress is below what friction bears, flows before the surfaces slip. Normal contact
            does not know it.
        temperature: Friction by the temperature T of the surfaces, mu + change min(1, max(0, (T - reference)/range)),
            mu that of friction; where the problem has temperature, and in model full. None: the coefficient does not
            follow it.
        temperature_by_angle: In place of temperature, where friction by temperature is another one from place to place:
            by the angle of the rail's surface as mu, ascending, with straight lines between; of a patch, or of each row
            where along_profile is set.
    """

    mu: float | Sequence[tuple[float, float]] = field(default=0.3, metadata={"keys": ("angle", "mu")})
    along_profile: bool | None = None
    kinetic: KineticFriction | None = None
    layer: InterfacialLayer | None = None
    temperature: TemperatureFriction | None = None
    temperature_by_angle: Sequence[tuple[float, float, float, float]] | None = field(
        default=None, metadata={"keys": ("angle", "change", "reference", "range")}
    )


@dataclass(frozen=True)
class RailSprings:
    """Springs between a rail without mass and the ground; it is rigid in a direction that has none.

    Attributes:
        y: Stiffness sideways (N/mm), >= 0.001.
        z: Stiffness downwards (N/mm), >= 0.001.
    """

    y: float | None = None
    z: float | None = None


@dataclass(frozen=True)
class Track:
    """Where the rails lie.

    Attributes:
        gauge: Distance between the gauge faces of the rails (mm), > 0. Default 1435.
        gauge_height: How far below the tops of the rails the gauge is measured (mm), >= 0. Default 14.
        cant: Cant of the rail's profile as given, leaning inwards where positive (rad), -0.5 to 0.5. Default 0.
        rail_origin: Where the origin of the rail's profile is: y and z (mm) from the centre of the track to the field
            side, and down; gauge and gauge_height mean nothing then. None: as they say.
        roller_radius: Radius of a roller that turns under the wheel in place of the rail, where its profile has z = 0
            (mm), > 0. None: a rail.
        roller_leans: Whether a roller's surface is one about an axle that leans and moves with its profile, by
            rail.roll, rail.z and cant, while it turns about a level axle that does not, which comparisons with other
            programs want; else its profile leans and its axle is level. Default False.
        springs: Springs between a rail without mass and the ground; it is rigid in a direction that has none. None: a
            rigid rail.
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
    """Where the wheels sit on their axle.

    Attributes:
        flange_back_distance: Distance between the backs of the flanges (mm), > 0. Default 1360.
        flange_back_position: y of the flange's back in the wheel's profile (mm). Default -70.
        nominal_radius: Radius of the wheel where its profile has z = 0 (mm), > 0. Default 460.
    """

    flange_back_distance: float | None = None
    flange_back_position: float | None = None
    nominal_radius: float | None = None


@dataclass(frozen=True)
class PatchRules:
    """Rules by which regions of overlap that lie close to each other are combined, by their distance. distance_combine
    < distance_separate < distance_turn.

    Attributes:
        angle_separate: Angle between the planes of two regions above which they are patches of their own (rad), > 0, <=
            3.14159. Default 1.5707963267948966.
        distance_separate: Distance below which regions are parts of one patch and interact with a weight (mm), > 0.
            Default 8.
        distance_combine: Distance below which regions become one patch (mm), > 0. Default 4.
        distance_turn: Distance below which the planes of two patches turn towards each other (mm), > 0. Default 12.
        locus_step: Step of the locus across the track, in elements dy (> 0, <= 1). Default 0.3.
        search: Search for regions of overlap: along the locus, where the distance along the track is least, or on a
            mesh seen from above, for rails that curve along the track. Default "locus".
        history: What the parts of a patch go on from that splits in a step which is not steady: the tractions on their
            own elements; or whole, those of all the patch before, whose displacements a part feels before the step and
            not behind it, which comparisons with other programs want; of parts in planes the first one only. Default
            "own".
        max_elements: Patches of steady rolling that would have as many elements get them twice as long and as wide, in
            the directions in which they are more than ten, until they are fewer: what comparisons with other programs
            want. 0: elements stay as they are, and too many are refused. Default 0.
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
    """A wheel on a rail: what all steps of a simulation have in common. The daemon keeps what it prepared for one, so
    that the next step with an equal set-up costs less. Lengths in mm, angles in rad; track coordinates have x forwards,
    y to the right, z down (docs/wheel-rail.md draws them).

    Attributes:
        side: Which wheel of the wheelset, seen in the direction of travel. Default "right".
        wheel: The wheel's profile, by default S1002.
        rail: The rail's profile, by default 60E1 with an inclination of 1/40.
        rail_slices: Profiles by ascending x, in place of rail where the rail varies along the track, in the same
            coordinates. Points at equal shares of the length from feature to feature are joined, or from kink to kink
            where slices have no features; those that do not all have as many are refused. Needs track.rail_origin; at
            most 200000 points together.
        wheel_slices: Profiles by ascending angles, in place of wheel where the wheel is out of round, in the same
            coordinates and cut at the same y, all within a revolution, after which the first one comes again. Radii go
            from slice to slice with continuous curvature and without overshoot; at most 200000 points together.
        track: Where the rails lie.
        wheelset: Where the wheels sit on their axle.
        upper: Material of the rail; without bodies it is steel, G = 82000 and nu = 0.28.
        lower: Material of the wheel; None: as the rail.
        model: full: boundary elements. hertz: closed forms of elliptic contact. The models of vehicle codes, of steady
            rolling: fastsim, Kalker's simplified theory; fastrip, strip theory with FASTSIM where it slips; polach,
            Polach's forces, which knows no tractions and no spin moment. Default "full".
        normal_model: How pressures are found, as in contact.solve: of_model as model says; kp, kpec, analyn from the
            overlap of the undeformed surfaces, with model full, fastsim, fastrip or polach. Default "of_model".
        simplified: Options of the models fastsim, fastrip and polach, as in contact.solve.
        temperature: What rail (upper) and wheel (lower) have to do with heat, where temperatures of their surfaces are
            wanted: of steady rolling, in each patch by itself. None: none.
        wear: Laws by which rail (upper) and wheel (lower) wear, where that is wanted: of steady rolling, in each patch
            by itself. None: no answer of wear.
        fatigue: Rolling contact fatigue of rail (upper) or wheel (lower), where that is wanted: of steady rolling, in
            each patch by itself. None: no answer of fatigue.
        sheet_flexibility: Flexibility of a thin sheet between rail and wheel, as in contact.solve (mm^3/N), >= 0. Of
            model full. Default 0.
        friction: Coulomb friction, by default 0.3 everywhere; None: frictionless.
        dx: Size of the elements along x, in the plane of a contact (mm), 0.0001 to 100. Default 0.2.
        dy: Size of the elements across (mm), 0.0001 to 100. Default 0.2.
        dq: Step of rolling (mm), 0 to 100; 0: dx. Default 0.
        patches: Rules by which regions of overlap that lie close to each other are combined, by their distance.
            distance_combine < distance_separate < distance_turn.
        rail_spline: How the rail goes from slice to slice: shape_preserving and cubic through them, the latter with the
            swings of natural cubic splines; approximating by the cubic B-spline whose control points they are, which
            passes them by and smooths what is noise. Default "shape_preserving".
        wheel_spline: How the wheel goes from slice to slice, likewise; cubic and approximating splines are periodic.
            Default "shape_preserving".
        wheel_surface: The wheel by its splines, or bilinear between corners of a mesh as large as the elements, which
            comparisons with other programs want. Default "exact".
        rigid_slip: Rigid slip, before the bodies deform: by the creepages of the reference, as in a plane; surfaces, by
            the motion of both surfaces at each row of elements, for conformal contact, with model full; or elements, by
            that at the middle of each element, seen along the plane as the surfaces lean along x, with creepages that
            fit it best, which comparisons with other programs want. Default "plane".
        slope_forces: Which forces follow the slope of a rail, or a roller, along the track, in track, rail and wheelset
            coordinates. pressure: pressures act along the normal of the rail's surface, and friction along the track's
            x. all: friction acts along the surface, too. none: neither, as if the rail were level, which comparisons
            with other programs want. The three are the same on a straight rail. Default "pressure".
        conformal: Whether a contact is curved across the track, half-way between wheel and rail. off: one plane.
            Otherwise each row of elements has its own normal, along which gaps are measured, tractions turned and slip
            is that of the surfaces, with coefficients of half_space, as if rows lay flat; rotated, half-spaces that
            turn from row to row; fem, wheel and rail by their cross-sections, whose tables are built when they are
            first needed. auto: rotated where a plane would be left by more than 0.24 rad, else off.
            rotated_displacements: half-spaces along the loaded row, of which only the displacements turn, which
            comparisons with other programs want. Of model full. Default "off".
        normal: Stopping criterion of NORM, for the pressures, on which all else builds; its tolerance is 1e-8 unless
            given.
        tangential: Stopping criterion for the tractions under friction, and the solver that finds them.
        outer: Stopping criterion of the outer (Panagiotopoulos) iterations around these, which dissimilar bodies,
            kinetic friction and prescribed tangential forces need; its iterations are at most 100 unless given.
        force: Search for a height that brings Fz: bounds of |F - Fz|/Fz, 1e-6 unless given, and of solves, 40 unless
            given.
        accuracy: How far forces over the normal force, and largest values over these, may be from those with tight
            tolerances at the same height (1e-08 to 0.01); real time wants 1e-4. In place of the tolerances of settings
            and force.
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

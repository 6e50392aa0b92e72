"""Answers of contacts. Arrays are read-only; copy one to change it.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, Literal

from .arrays import Array
from .dictionaries import Saved
from .evidence import ContactEvidence
from .fatigue_methods import ContactFatigueMethods
from .grid import Grid
from .motion import Rolling, Shift
from .representation import Shown
from .solution_methods import Bytes, Floats, SolutionMethods
from .wear_methods import ContactWearMethods

__all__ = [
    "Areas",
    "ContactFatigue",
    "ContactTemperature",
    "ContactWear",
    "Counts",
    "Derivatives",
    "DerivativesOfAnswer",
    "FatigueRow",
    "Field",
    "Forces",
    "FunctionDamage",
    "LawWear",
    "Resultant",
    "RollingResistance",
    "Solution",
    "StressPlace",
    "WearRow",
]

Field = Literal["element_division", "pressure", "traction_x", "traction_y", "slip_x", "slip_y", "displacement_x", "displacement_y", "displacement_z", "flow_x", "flow_y", "yield_stress", "friction_coefficient", "upper_temperature", "lower_temperature"]


@dataclass(frozen=True)
class DerivativesOfAnswer:
    """The derivatives of one answer by each input: units are those of the answer over those of the input. What the
    problem does not have, or its model does not know, is None.

    Attributes:
        xi: Derivative by the longitudinal creepage, in rolling.
        eta: Derivative by the lateral creepage, in rolling.
        phi: Derivative by the spin creepage, in rolling.
        rigid_shift: Derivatives by the rigid shift along x, and along y, in a shift.
        rotation: Derivative by the rotation, in a shift.
        approach: Derivative by the approach, where that is prescribed.
        Fn: Derivative by the normal force, where that is prescribed.
        mu: Derivative by the coefficient of friction, which changes alike in every element.
    """

    xi: float | None = None
    eta: float | None = None
    phi: float | None = None
    rigid_shift: tuple[float, float] | None = None
    rotation: float | None = None
    approach: float | None = None
    Fn: float | None = None
    mu: float | None = None


@dataclass(frozen=True)
class ContactTemperature:
    """What a contact answers of temperatures beside those of the elements.

    Attributes:
        largest: Largest temperature in contact, where both surfaces have the same (degC); without contact that of the
            hotter body.
        x: x of the element that has it, the first of equals (mm).
        y: y of this element (mm).
        largest_upper: Largest temperature of the upper surface over all elements, also before and behind the contact
            (degC).
        largest_lower: Largest temperature of the lower surface over all elements, as largest_upper (degC).
        rise: Largest rise by friction alone (K).
        heat_upper: Frictional power that goes into the upper body (N mm/s).
        heat_lower: Frictional power that goes into the lower body (N mm/s).
        peclet: Peclet number U L/(2 kappa), the smaller one of both bodies: U the speed of its surface through the
            contact, L the longest row. Below 10 heat spreads along the surface as well.
    """

    largest: float
    x: float
    y: float
    largest_upper: float
    largest_lower: float
    rise: float
    heat_upper: float
    heat_lower: float
    peclet: float


@dataclass(frozen=True)
class RollingResistance:
    """What the creep of viscoelastic bodies takes of rolling.

    Attributes:
        force: Force that resists rolling (N): the sum of pressures times the slopes of the undeformed distance along
            the rolling direction.
        power: Power that the bodies dissipate by hysteresis, the force times the velocity of rolling (N mm/s).
        centre_of_pressure: x of the centre of pressure (mm).
        moment: Moment of the pressures about the axis y, the sum of x p dx dy (N mm).
        defect: Evidence of the force: its difference to minus the sum of pressures times the slopes of the surfaces,
            which is the hysteresis, over the sum of pressures times the sizes of the slopes.
    """

    force: float
    power: float
    centre_of_pressure: float
    moment: float
    defect: float


@dataclass(frozen=True)
class WearRow:
    """A row of elements, and what one passage takes off it.

    Attributes:
        y: Its middle (mm): y of the grid or of the strips' section, of wheels on rails in track coordinates.
        z: Its middle, likewise (mm); 0 on a plane.
        angle: Its inclination, likewise (rad); depths are along its normal.
        dissipation: Integral of |t s| along the row (N/mm).
        pressure_slip: Integral of p |s| along the row (N/mm).
        depths: Depth that one passage takes off (mm), by the laws in their order.
    """

    y: float
    z: float
    angle: float
    dissipation: float
    pressure_slip: float
    depths: tuple[float, ...]


@dataclass(frozen=True)
class LawWear:
    """What a law makes of a contact.

    Attributes:
        name: The law.
        body: The body that wears by it. One of "upper", "lower".
        area: Area that a passage takes off the section, the volume per distance rolled (mm^2).
        depth: Largest depth of the rows (mm).
        argument: Largest argument of the law, in the unit of its range.
    """

    name: str
    body: Literal["upper", "lower"]
    area: float
    depth: float
    argument: float


@dataclass(frozen=True)
class ContactWear(ContactWearMethods):
    """What a passage takes off the surfaces, row by row, with T gamma; p is the pressure, t the traction and s the slip
    over the distance rolled.

    Attributes:
        T_gamma: T gamma by forces and creepages, without spin (N): the size of Fx xi + Fy eta.
        T_gamma_with_spin: T gamma by forces and creepages, with spin (N): -(Fx xi + Fy eta + Mz phi), all that friction
            dissipates per distance rolled.
        dissipation: Sum of |t s| over the elements, not scaled (N).
        factor: Factor by which slips were scaled; 1 of plain energy.
        largest_pressure_slip: Largest p |s| of an element (N/mm^2).
        largest_dissipation: Largest |t s| of an element (N/mm^2).
        largest_sliding_velocity: Largest sliding velocity of an element (mm/s).
        rows: Rows of elements, dy of the grid wide, by ascending y, from the first to the last one in contact.
        laws: What each law makes of the contact, in the order of the request.
    """

    T_gamma: float
    T_gamma_with_spin: float
    dissipation: float
    factor: float
    largest_pressure_slip: float
    largest_dissipation: float
    largest_sliding_velocity: float
    rows: tuple[WearRow, ...]
    laws: tuple[LawWear, ...]


@dataclass(frozen=True)
class StressPlace:
    """Largest |xz| below the surface, which no residual stress changes, or |t| on it. With passage.

    Attributes:
        value: The stress (N/mm^2).
        y: The middle of its row, as of rows (mm).
        z: The middle of its row, as of rows (mm).
        depth: The depth below that (mm).
    """

    value: float
    y: float
    z: float
    depth: float


@dataclass(frozen=True)
class FunctionDamage:
    """What a function makes of a contact.

    Attributes:
        name: The function.
        value: Damage of a passage; below 0 wear takes cracks away.
    """

    name: str
    value: float


@dataclass(frozen=True)
class FatigueRow:
    """A row of elements, and what it bears.

    Attributes:
        y: Its middle (mm): y of the grid or of the strips' section, of wheels on rails in track coordinates.
        z: Its middle, likewise (mm); 0 on a plane.
        angle: Its inclination, likewise (rad).
        pressure: Largest pressure (N/mm^2).
        traction: Largest tangential traction (N/mm^2); the surface flows where it is above k.
        force_x: Tangential force along x on the body (N/mm).
        force_y: Tangential force along the row's y on the body (N/mm).
        shear: Largest shear below it, as shear of the contact (N/mm^2). With passage.
        shear_depth: Where that is (mm).
        dang_van: Largest stress of Dang Van below it (N/mm^2). With passage and a_DV.
        dang_van_depth: Where that is (mm).
    """

    y: float
    z: float
    angle: float
    pressure: float
    traction: float
    force_x: float
    force_y: float
    shear: float | None = None
    shear_depth: float | None = None
    dang_van: float | None = None
    dang_van_depth: float | None = None


@dataclass(frozen=True)
class ContactFatigue(ContactFatigueMethods):
    """Rolling contact fatigue of one of the bodies.

    Attributes:
        body: The body. One of "upper", "lower".
        T_gamma: T gamma by forces and creepages, without spin (N).
        traction_coefficient: mu_u, the size of the tangential force over the normal one.
        force_angle: Angle of the tangential force on the body from the way in which the contact runs over it, towards
            +y where it runs along +x (rad); head checks run across it.
        driven: Whether the force on the body is against the way in which the contact runs over it: the other body
            drives, as a wheel that accelerates does a rail.
        FI_sub: Subsurface fatigue index, Fn (1 + mu_u^2)/(4 A), with a_DV and residual stresses and a_DV times their
            largest hydrostatic stress besides (N/mm^2).
        damages: Damage of a passage by each function, in the order of the request.
        rows: Rows of elements, dy of the grid wide, by ascending y, from the first to the last one in contact.
        FI_surf: Surface fatigue index by the area A of the contact, mu_u - 2 A k/(3 Fn); the surface flows where it is
            above 0. With strength.
        load: The largest pressure over k: the load of shakedown diagrams. With strength.
        limit: The load at which shakedown ends, by the contact's own tractions: the largest pressure over the largest
            shear. With passage.
        shear: Largest |xz| below the surface, which no residual stress changes, or |t| on it. With passage.
        von_mises: Largest von Mises stress, without residual stresses. With passage.
        dang_van: Largest stress of Dang Van, the shear stress less its middle of the passage and a_DV times the
            hydrostatic stress. With passage and a_DV.
        utilisation: Dang Van's largest stress over tau_e; cracks start beyond 1. With these.
    """

    body: Literal["upper", "lower"]
    T_gamma: float
    traction_coefficient: float
    force_angle: float
    driven: bool
    FI_sub: float
    damages: tuple[FunctionDamage, ...]
    rows: tuple[FatigueRow, ...]
    FI_surf: float | None = None
    load: float | None = None
    limit: float | None = None
    shear: StressPlace | None = None
    von_mises: StressPlace | None = None
    dang_van: StressPlace | None = None
    utilisation: float | None = None


@dataclass(frozen=True)
class Forces:
    """Total forces on the upper body (N), and their moment about z. On curved columns: of pressures what is along the
    direction of approach, of tractions what is along x and across both, and their moment about that direction.

    Attributes:
        Fn: Normal force, positive in compression (N).
        Fx: Tangential force along x (N).
        Fy: Tangential force along y (N).
        Mz: Moment of the tractions about z at the origin, sum of x p_y - y p_x (N mm).
    """

    Fn: float
    Fx: float
    Fy: float
    Mz: float


@dataclass(frozen=True)
class Resultant:
    """Resultant force (N) and moment about their origin (N mm) of pressures and tractions together on curved columns,
    on the upper body, in the axes of the section.

    Attributes:
        Fx: Force along x (N).
        Fy: Force along y (N).
        Fz: Force along z (N).
        Mx: Moment about x (N mm).
        My: Moment about y (N mm).
        Mz: Moment about z (N mm).
    """

    Fx: float
    Fy: float
    Fz: float
    Mx: float
    My: float
    Mz: float


@dataclass(frozen=True)
class Areas:
    """Areas (mm^2): contact = adhesion + slip + flow; without friction all contact counts as slip.

    Attributes:
        contact: Area of contact (mm^2).
        adhesion: Area of adhesion (mm^2).
        slip: Area of slip (mm^2).
        flow: Area where a layer flows (mm^2). Default 0.
    """

    contact: float
    adhesion: float
    slip: float
    flow: float | None = None


@dataclass(frozen=True)
class Counts:
    """Numbers of elements: contact = adhesion + slip + flow; without friction all contact counts as slip.

    Attributes:
        contact: Elements in contact.
        adhesion: Elements in adhesion.
        slip: Elements in slip.
        border: Elements in contact at the border of the potential contact area; any are a reason for a warning.
        flow: Elements where a layer flows. Default 0.
    """

    contact: int
    adhesion: int
    slip: int
    border: int
    flow: int | None = None


@dataclass(frozen=True)
class Derivatives:
    """Derivatives of the forces by the inputs, where they were requested and the solution has converged and has
    contact: derivatives.Fx.xi is dFx/d(xi). Fixed are the undeformed distance (also where semi-axes and the load made
    it), the tractions before the step, rigid_slip, and the division of the elements, at whose next change the
    derivatives are one-sided. Motion is an input also where forces found it: as if it had been given.

    Attributes:
        Fx: Derivatives of Fx (N), with friction.
        Fy: Derivatives of Fy (N), with friction.
        Mz: Derivatives of Mz (N mm), with friction.
        Fn: Derivatives of the normal force (N), where the approach is prescribed.
        approach: Derivatives of the approach (mm), where the normal force is prescribed.
    """

    Fx: DerivativesOfAnswer | None = None
    Fy: DerivativesOfAnswer | None = None
    Mz: DerivativesOfAnswer | None = None
    Fn: DerivativesOfAnswer | None = None
    approach: DerivativesOfAnswer | None = None


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Solution(SolutionMethods, Saved, Shown, Generic[Floats, Bytes]):
    """The solution and its evidence. Arrays have shape [ny, nx]; tractions and forces act on the upper body.

    Attributes:
        approach: Approach of the bodies, prescribed or found (mm).
        forces: Total forces on the upper body (N), and their moment about z. On curved columns: of pressures what is
            along the direction of approach, of tractions what is along x and across both, and their moment about that
            direction.
        pmax: Largest pressure (N/mm^2).
        area: Areas (mm^2): contact = adhesion + slip + flow; without friction all contact counts as slip.
        elements: Numbers of elements: contact = adhesion + slip + flow; without friction all contact counts as slip.
        element_division: Bytes, shape [ny, nx]: 0 exterior, 1 adhesion, 2 slip, 3 flow of a layer.
        pressure: Pressure, shape [ny, nx] (N/mm^2), zero or positive.
        traction_x: Traction along x on the upper body, shape [ny, nx] (N/mm^2).
        traction_y: Traction along y on the upper body, shape [ny, nx] (N/mm^2).
        converged: Whether every solver of the problem that ran reached its tolerance; derivatives that did not are
            None.
        evidence: How the solvers ended, and which coefficients they used; what did not run is None.
        resultant: Resultant force (N) and moment about their origin (N mm) of pressures and tractions together on
            curved columns, on the upper body, in the axes of the section.
        slip_x: Slip of the upper body over the lower along x, with friction, shape [ny, nx]: in a shift the distance
            over the step (mm), in rolling the relative slip, per distance rolled. Zero outside of the contact.
        slip_y: Slip of the upper body over the lower along y, with friction, as slip_x.
        flow_x: Plastic flow of a layer along x, in the direction of the tractions on the upper body, where a layer
            yields, shape [ny, nx]: over the step (mm), in rolling per distance rolled. Slip is without it.
        flow_y: Plastic flow of a layer along y, as flow_x.
        yield_stress: Yield stress of a layer that hardens or softens, behind its flow, shape [ny, nx] (N/mm^2); outside
            of the contact that of a particle that enters.
        friction_coefficient: Coefficient of kinetic friction, shape [ny, nx]; outside of the contact the static one.
        displacement_x: Displacement of the upper body's surface along x less that of the lower one's, under the
            tractions, shape [ny, nx] (mm); where asked for.
        displacement_y: The same along y.
        displacement_z: What both bodies yield along z, positive under pressure, shape [ny, nx] (mm); where asked for.
        upper_temperature: Temperature of the upper body's surface, in contact and behind it, shape [ny, nx] (degrees
            Celsius); where asked for.
        lower_temperature: Temperature of the lower body's surface, as upper_temperature.
        temperature: The largest temperature, and the heat; where temperatures were asked for.
        wear: What a passage takes off the surfaces; where asked for.
        fatigue: Rolling contact fatigue of a body; where asked for.
        rolling_resistance: What the creep of viscoelastic bodies takes of rolling; of contact with such a body.
        elastic_energy: Half the sum of traction times displacement, the energy that elastic bodies have stored (N mm);
            with displacements.
        frictional_work: Energy that friction dissipates in a shift (N mm).
        frictional_power: Power that friction dissipates in rolling (N mm/s).
        plastic_work: What of frictional_work the flow of a layer dissipates (N mm).
        plastic_power: What of frictional_power the flow of a layer dissipates (N mm/s).
        largest_flow: Largest length of the flow of a layer, as flow_x: over the step (mm), in rolling per distance
            rolled.
        motion: Motion as requested, with friction, and as found where a force is prescribed: of a shift rigid_shift,
            rotation and duration; else as rolling of the request. force as in the request.
        derivatives: Derivatives of the forces by the inputs, where they were requested and the solution has converged
            and has contact: derivatives.Fx.xi is dFx/d(xi). Fixed are the undeformed distance (also where semi-axes and
            the load made it), the tractions before the step, rigid_slip, and the division of the elements, at whose
            next change the derivatives are one-sided. Motion is an input also where forces found it: as if it had been
            given.
        warnings: Sentences that a user of the solution should know; for example that the contact touches the border of
            the potential contact area, or that elements or dq are too large for it.
        grid: The grid of the problem, which the client adds.
    """

    approach: float
    forces: Forces
    pmax: float
    area: Areas
    elements: Counts
    element_division: Bytes
    pressure: Floats
    traction_x: Floats
    traction_y: Floats
    converged: bool
    evidence: ContactEvidence
    resultant: Resultant | None = None
    slip_x: Array | None = None
    slip_y: Array | None = None
    flow_x: Array | None = None
    flow_y: Array | None = None
    yield_stress: Array | None = None
    friction_coefficient: Array | None = None
    displacement_x: Array | None = None
    displacement_y: Array | None = None
    displacement_z: Array | None = None
    upper_temperature: Array | None = None
    lower_temperature: Array | None = None
    temperature: ContactTemperature | None = None
    wear: ContactWear | None = None
    fatigue: ContactFatigue | None = None
    rolling_resistance: RollingResistance | None = None
    elastic_energy: float | None = None
    frictional_work: float | None = None
    frictional_power: float | None = None
    plastic_work: float | None = None
    plastic_power: float | None = None
    largest_flow: float | None = None
    motion: Shift | Rolling | None = None
    derivatives: Derivatives | None = None
    warnings: tuple[str, ...] = ()
    grid: Grid | None = None

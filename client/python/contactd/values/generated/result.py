"""Answers of contacts. Arrays are read-only; copy one to change it.

Written by ./dev generate from proto/schema: edit it there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from ..arrays import Array
from ..dictionaries import Saved
from ..fatigue_methods import ContactFatigueMethods
from ..representation import Shown
from ..solution_methods import SolutionMethods
from ..wear_methods import ContactWearMethods
from .evidence import ContactEvidence
from .grid import Grid
from .motion import Rolling, Shift

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

Field = Literal["element_division", "pressure", "traction_x", "traction_y", "slip_x", "slip_y", "displacement_x", "displacement_y", "displacement_z", "flow_x", "flow_y", "yield_stress", "friction_coefficient", "upper_temperature", "lower_temperature", "pressure_by_approach"]


@dataclass(frozen=True)
class DerivativesOfAnswer:
    """Derivatives of an answer by each input. Units are those of the answer over those of the input. Inputs that the
    problem lacks or that do not affect its model are None.

    Attributes:
        xi: Derivative by the longitudinal creepage, in rolling.
        eta: Derivative by the lateral creepage, in rolling.
        phi: Derivative by the spin creepage, in rolling.
        rigid_shift: Derivatives by the rigid shift along x, and along y, in a shift.
        rotation: Derivative by the rotation, in a shift.
        approach: Derivative by the approach, if it is prescribed.
        Fn: Derivative by the normal force, if it is prescribed.
        mu: Derivative by the coefficient of friction, with the same change in every element.
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
    """Results for temperatures in addition to those of the elements.

    Attributes:
        largest: Largest temperature in the contact, where both surfaces have the same temperature (degC); without
            contact the temperature of the hotter body.
        x: x of the element with the largest temperature, the first of several equal ones (mm).
        y: y of this element (mm).
        largest_upper: Largest temperature of the upper surface over all elements, including those ahead of the contact
            and behind it (degC).
        largest_lower: Largest temperature of the lower surface over all elements, including those ahead of the contact
            and behind it (degC).
        rise: Largest rise by friction alone (K).
        heat_upper: Frictional power that flows into the upper body (N mm/s).
        heat_lower: Frictional power that flows into the lower body (N mm/s).
        peclet: Peclet number U L/(2 kappa), the smaller of the two bodies', where U is the surface speed through the
            contact and L the longest row. Below 10, heat also spreads along the surface.
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
    """Rolling resistance due to the creep of viscoelastic bodies.

    Attributes:
        force: Force that resists rolling (N): the sum of pressures times slopes of the undeformed distance along the
            rolling direction.
        power: Power that the bodies dissipate by hysteresis (N mm/s): the force times the rolling velocity.
        centre_of_pressure: x of the centre of pressure (mm).
        moment: Moment of the pressures about the axis y, the sum of x p dx dy (N mm).
        defect: Evidence of the force: its difference from minus the sum of pressures times slopes of the surfaces,
            which is the hysteresis, over the sum of pressures times absolute slopes.
    """

    force: float
    power: float
    centre_of_pressure: float
    moment: float
    defect: float


@dataclass(frozen=True)
class WearRow:
    """A row of elements and its wear in one passage.

    Attributes:
        y: y of the middle of the row (mm): of the grid or of the strips' section; for wheels on rails in track
            coordinates.
        z: z of the middle of the row, in the same coordinates (mm); 0 on a plane.
        angle: Inclination of the row, in the same coordinates (rad). Depths are along its normal.
        dissipation: Integral of |t s| along the row (N/mm).
        pressure_slip: Integral of p |s| along the row (N/mm).
        depths: Depth removed in one passage (mm), one value per law.
    """

    y: float
    z: float
    angle: float
    dissipation: float
    pressure_slip: float
    depths: tuple[float, ...]


@dataclass(frozen=True)
class LawWear:
    """Wear of a contact by a law.

    Attributes:
        name: The law.
        body: The body that wears by it. One of "upper", "lower".
        area: Area removed from the section in one passage, the volume per distance rolled (mm^2).
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
    """Wear of the surfaces in one passage, row by row, with T gamma. p is the pressure, t the traction and s the slip
    per distance rolled.

    Attributes:
        T_gamma: T gamma by forces and creepages, without spin (N): the size of Fx xi + Fy eta.
        T_gamma_with_spin: T gamma from forces and creepages, with spin (N): -(Fx xi + Fy eta + Mz phi), the total
            frictional dissipation per distance rolled.
        dissipation: Sum of |t s| over the elements, not scaled (N).
        factor: Factor by which slips were scaled; 1 for plain energy.
        largest_pressure_slip: Largest p |s| of an element (N/mm^2).
        largest_dissipation: Largest |t s| of an element (N/mm^2).
        largest_sliding_velocity: Largest sliding velocity of an element (mm/s).
        rows: Rows of elements, as wide as dy of the grid, by ascending y, from the first to the last row in contact.
        laws: Wear of the contact by each law, in the order of the request.
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
    """Largest |xz| below the surface, which residual stresses do not affect, or |t| on it. Only with passage.

    Attributes:
        value: The stress (N/mm^2).
        y: y of the middle of the row, as in rows (mm).
        z: z of the middle of the row, as in rows (mm).
        depth: Depth below this point (mm).
    """

    value: float
    y: float
    z: float
    depth: float


@dataclass(frozen=True)
class FunctionDamage:
    """Damage of a contact by a function.

    Attributes:
        name: The function.
        value: Damage of a passage; if negative, wear removes cracks.
    """

    name: str
    value: float


@dataclass(frozen=True)
class FatigueRow:
    """A row of elements with its load and fatigue indices.

    Attributes:
        y: y of the middle of the row (mm): of the grid or of the strips' section; for wheels on rails in track
            coordinates.
        z: z of the middle of the row, in the same coordinates (mm); 0 on a plane.
        angle: Inclination of the row, in the same coordinates (rad).
        pressure: Largest pressure (N/mm^2).
        traction: Largest tangential traction (N/mm^2). The surface flows where it is above k.
        force_x: Tangential force along x on the body (N/mm).
        force_y: Tangential force along the row's y on the body (N/mm).
        shear: Largest shear below the row, as shear of the contact (N/mm^2). Only with passage.
        shear_depth: Depth of the largest value (mm).
        dang_van: Largest stress of Dang Van below the row (N/mm^2). Only with passage and a_DV.
        dang_van_depth: Depth of the largest value (mm).
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
        traction_coefficient: mu_u, the size of the tangential force divided by the normal force.
        force_angle: Angle of the tangential force on the body from the direction in which the contact moves over it,
            towards +y if the contact moves along +x (rad). Head checks run across the force.
        driven: True if the force on the body opposes the direction in which the contact moves over it. The other body
            then drives, like an accelerating wheel on a rail.
        FI_sub: Subsurface fatigue index, Fn (1 + mu_u^2)/(4 A) (N/mm^2); with a_DV and residual stresses, plus a_DV
            times their largest hydrostatic stress.
        damages: Damage of a passage by each function, in the order of the request.
        rows: Rows of elements, as wide as dy of the grid, by ascending y, from the first to the last row in contact.
        FI_surf: Surface fatigue index by the area A of the contact, mu_u - 2 A k/(3 Fn). The surface flows if it is
            positive. Only with strength.
        load: Largest pressure over k: the load of shakedown diagrams. Only with strength.
        limit: Shakedown limit from the contact's own tractions: the largest pressure over the largest shear. Only with
            passage.
        shear: Largest |xz| below the surface, which residual stresses do not affect, or |t| on it. Only with passage.
        von_mises: Largest von Mises stress, without residual stresses. Only with passage.
        dang_van: Largest stress of Dang Van: the shear stress minus the centre of its path in the passage, plus a_DV
            times the hydrostatic stress. Only with passage and a_DV.
        utilisation: Dang Van's largest stress over tau_e; cracks start beyond 1. Only with passage, a_DV and tau_e.
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
    """Total forces on the upper body (N), and their moment about z. On curved columns: the component of the pressures
    along the direction of approach, those of the tractions along x and across both, and their moment about that
    direction.

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
    """Resultant force (N) and moment about the origin (N mm) of pressures and tractions together on curved columns, on
    the upper body, in the axes of the section.

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
    """Areas (mm^2): contact = adhesion + slip + flow. Without friction the whole contact is counted as slip.

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
    """Numbers of elements: contact = adhesion + slip + flow. Without friction the whole contact is counted as slip.

    Attributes:
        contact: Elements in contact.
        adhesion: Elements in adhesion.
        slip: Elements in slip.
        border: Elements in contact at the border of the potential contact area. If there are any, the answer contains a
            warning.
        flow: Elements where a layer flows. Default 0.
    """

    contact: int
    adhesion: int
    slip: int
    border: int
    flow: int | None = None


@dataclass(frozen=True)
class Derivatives:
    """Derivatives of the forces by the inputs, if requested and if the solution has converged and has contact:
    derivatives.Fx.xi is dFx/d(xi). These are held fixed: the undeformed distance (also if semi-axes and the load
    determined it), the tractions before the step, rigid_slip, and the division of the elements. Where that division is
    about to change, the derivatives are one-sided. Motion is an input even if it was computed for prescribed forces.

    Attributes:
        Fx: Derivatives of Fx (N), with friction.
        Fy: Derivatives of Fy (N), with friction.
        Mz: Derivatives of Mz (N mm), with friction.
        Fn: Derivatives of the normal force (N), if the approach is prescribed.
        approach: Derivatives of the approach (mm), if the normal force is prescribed.
    """

    Fx: DerivativesOfAnswer | None = None
    Fy: DerivativesOfAnswer | None = None
    Mz: DerivativesOfAnswer | None = None
    Fn: DerivativesOfAnswer | None = None
    approach: DerivativesOfAnswer | None = None


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Solution(SolutionMethods, Saved, Shown):
    """The solution and its evidence. Arrays have shape [ny, nx]; tractions and forces act on the upper body.

    Attributes:
        approach: Approach of the bodies, prescribed or computed (mm).
        forces: Total forces on the upper body (N), and their moment about z. On curved columns: the component of the
            pressures along the direction of approach, those of the tractions along x and across both, and their moment
            about that direction.
        pmax: Largest pressure (N/mm^2).
        area: Areas (mm^2): contact = adhesion + slip + flow. Without friction the whole contact is counted as slip.
        elements: Numbers of elements: contact = adhesion + slip + flow. Without friction the whole contact is counted
            as slip.
        element_division: Bytes, shape [ny, nx]: 0 exterior, 1 adhesion, 2 slip, 3 flow of a layer.
        pressure: Pressure, shape [ny, nx] (N/mm^2), zero or positive.
        traction_x: Traction along x on the upper body, shape [ny, nx] (N/mm^2).
        traction_y: Traction along y on the upper body, shape [ny, nx] (N/mm^2).
        converged: True if every solver that ran reached its tolerance. Derivatives are None if their solver did not.
        evidence: Convergence of the solvers, and the coefficients that they used. Solvers that did not run are None.
        resultant: Resultant force (N) and moment about the origin (N mm) of pressures and tractions together on curved
            columns, on the upper body, in the axes of the section.
        slip_x: Slip of the upper body over the lower along x, with friction, shape [ny, nx]: in a shift the distance
            over the step (mm), in rolling the relative slip per distance rolled. Zero outside the contact.
        slip_y: Slip of the upper body over the lower along y, with friction, as slip_x.
        flow_x: Plastic flow of a layer along x, in the direction of the tractions on the upper body, if a layer yields,
            shape [ny, nx]: over the step (mm), in rolling per distance rolled. It is not part of the slip.
        flow_y: Plastic flow of a layer along y, as flow_x.
        yield_stress: Yield stress of a layer that hardens or softens, after its flow, shape [ny, nx] (N/mm^2); outside
            the contact that of a particle that enters.
        friction_coefficient: Coefficient of kinetic friction, shape [ny, nx]; outside the contact the static
            coefficient.
        displacement_x: Displacement of the upper body's surface along x minus that of the lower body's, under the
            tractions, shape [ny, nx] (mm). Only if requested.
        displacement_y: Displacement along y, as displacement_x.
        displacement_z: Sum of the displacements of both bodies along z, positive under pressure, shape [ny, nx] (mm).
            Only if requested.
        upper_temperature: Temperature of the upper body's surface, in the contact and behind it, shape [ny, nx]
            (degrees Celsius). Only if requested.
        lower_temperature: Temperature of the lower body's surface, as upper_temperature.
        pressure_by_approach: Derivative of the pressure by the approach at constant motion, shape [ny, nx] (N/mm^3),
            zero outside the contact. Its sum times the area of an element is derivatives.Fn.approach, or
            1/derivatives.approach.Fn for a prescribed normal force. It includes the effect of the tractions of
            dissimilar bodies. For wheels on rails, the approach is that of the patch, along its normal; curved patches
            do not have this array. Only with derivatives and model full.
        temperature: The largest temperatures, and the heat. Only if requested.
        wear: Wear of the surfaces in one passage. Only if requested.
        fatigue: Rolling contact fatigue of a body. Only if requested.
        rolling_resistance: Rolling resistance due to the creep of viscoelastic bodies. Only for contact with such a
            body.
        elastic_energy: Half the sum of traction times displacement (N mm): the elastic energy stored in the bodies.
            Only with displacements.
        frictional_work: Energy that friction dissipates in a shift (N mm).
        frictional_power: Power that friction dissipates in rolling (N mm/s).
        plastic_work: Part of frictional_work that the flow of a layer dissipates (N mm).
        plastic_power: Part of frictional_power that the flow of a layer dissipates (N mm/s).
        largest_flow: Largest length of the flow of a layer, as flow_x: over the step (mm), in rolling per distance
            rolled.
        motion: Motion of a problem with friction, as requested or as computed for a prescribed force. For a shift,
            rigid_shift, rotation and duration; otherwise the fields of rolling. `force` is that of the request.
        upper_speed: Speed at which the upper surface, that of the rail, passes through the contact (mm/s): the speed of
            the contact along the rail, or that of the roller's surface. Only for wheels on rails that roll steadily.
            Temperatures depend on it.
        derivatives: Derivatives of the forces by the inputs, if requested and if the solution has converged and has
            contact: derivatives.Fx.xi is dFx/d(xi). These are held fixed: the undeformed distance (also if semi-axes
            and the load determined it), the tractions before the step, rigid_slip, and the division of the elements.
            Where that division is about to change, the derivatives are one-sided. Motion is an input even if it was
            computed for prescribed forces.
        warnings: Warnings: for example, the contact touches the border of the potential contact area, or elements or dq
            are too large for it.
        grid: The grid of the problem, which the client adds.
    """

    approach: float
    forces: Forces
    pmax: float
    area: Areas
    elements: Counts
    element_division: npt.NDArray[np.uint8]
    pressure: Array
    traction_x: Array
    traction_y: Array
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
    pressure_by_approach: Array | None = None
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
    upper_speed: float | None = None
    derivatives: Derivatives | None = None
    warnings: tuple[str, ...] = ()
    grid: Grid | None = None

// Defines contact problems and their solutions as plain values.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "contactd/contact_load.hpp"
#include "contactd/contact_setup.hpp"
#include "contactd/derivatives.hpp"

namespace contactd {

/// An element flows if a layer between the surfaces flows. If the layer has hardened to the friction bound, the
/// surfaces slip as well.
enum class ElementState : std::uint8_t { exterior = 0, adhesion = 1, slip = 2, flow = 3 };

/// Describes how a solver ended.
struct SolverEvidence {
    int iterations = 0;
    double residual = 0;  ///< the value compared with the tolerance
    bool converged = false;
    double seconds = 0;
};

/// Selects the source of the estimated discretisation errors.
enum class ErrorSource { hertz, estimate };

/// Describes how finely the elements divide the contact, and the absolute relative errors against the limit of small
/// elements. docs/contact.md contains measurements.
struct Discretisation {
    int elements_across = 0;  ///< along the direction with fewer elements; directions in which the contact fills the
                              ///< grid do not count
    double force_error = 0;   ///< error of Fn for the given approach, whether force or approach was prescribed
    double pmax_error = 0;    ///< error of the largest pressure under the prescribed load
    /// Both errors come from Hertz's closed form for a paraboloid on half-spaces, otherwise from an estimate by
    /// elements_across.
    ErrorSource source = ErrorSource::estimate;
    /// Estimates the error of the tangential force in rolling under a small creepage, from elements_across and dq. The
    /// error is smaller if most of the contact slips.
    std::optional<double> rolling_error{};
    /// Describes bodies with layers: the compliance of the layers that elements of this size represent, over their true
    /// compliance, under pressures as wide as the contact. Both errors above include it.
    std::optional<double> compliance_ratio{};

    bool operator==(const Discretisation&) const = default;
};

/// Holds the tangential forces on the upper body on a grid around the contact ellipse.
struct GridForces {
    int nx = 0, ny = 0;     ///< numbers of elements
    double Fx = 0, Fy = 0;  ///< (N)
    double Mz = 0;          ///< (N mm)

    bool operator==(const GridForces&) const = default;
};

/// Describes the extrapolation of tangential forces to elements of zero size, F = 2 F_fine - F_coarse.
struct ForceAccuracy {
    GridForces coarse, fine;  ///< the latter has twice as many elements along each axis
    double force_error = 0;   ///< stated error of Fx and Fy over mu Fn
    double moment_error = 0;  ///< stated error of Mz over mu Fn sqrt(ab)
    bool converged = false;   ///< whether the stated errors meet the request, and the solvers converged on both grids

    bool operator==(const ForceAccuracy&) const = default;
};

/// Describes normal contact with a prescribed approach or force and, with friction, tangential contact.
struct ContactProblem : ContactSetup, ContactLoad {};

/// Holds the contact area and its parts (mm^2).
struct Areas {
    double contact = 0, adhesion = 0, slip = 0, flow = 0;
};

/// Counts the elements in each state.
struct Counts {
    int contact = 0, adhesion = 0, slip = 0, flow = 0;
    int border = 0;  ///< those in contact at the border of the potential contact area
};

/// Holds the total forces on the upper body. On curved strips, Fn is the component of the pressures along the direction
/// of approach, Fx and Fy are those of the tractions along x and across both, and Mz is their moment about that
/// direction at the strips' origin.
struct Forces {
    double Fn = 0;          ///< normal (N), > 0 in compression
    double Fx = 0, Fy = 0;  ///< tangential (N)
    double Mz = 0;          ///< moment about z at the origin, sum of x p_y - y p_x (N mm)
};

/// Describes the rolling resistance due to the creep of viscoelastic bodies.
struct RollingResistance {
    /// The force that resists rolling (N) is the sum of the pressures times the slopes of the undeformed distance along
    /// the rolling direction.
    double force = 0;
    double power = 0;               ///< power dissipated by the bodies: force times velocity (N mm/s)
    double centre_of_pressure = 0;  ///< x of the centre of pressure (mm)
    double moment = 0;              ///< moment of the pressures about the axis y, sum of x p (N mm)
    /// The hysteresis is minus the sum of the pressures times the slopes of the surfaces. The defect is the difference
    /// of the force from it, over the sum of the pressures times the absolute slopes.
    double defect = 0;

    bool operator==(const RollingResistance&) const = default;
};

/// Describes how the solvers of a contact problem ended.
struct ContactEvidence {
    SolverEvidence normal;
    std::optional<SolverEvidence> tangential;
    std::optional<TangentialSolver> tangential_solver;  ///< solver that computed the tractions
    /// Describes the iterations between normal and tangential contact of dissimilar bodies, and between slip and a slip
    /// law. The residual is the relative change of the tractions expected from further iterations; with a slip law, it
    /// is the last change.
    std::optional<SolverEvidence> outer;
    std::optional<SolverEvidence> force;  ///< Newton's iterations or solves for the motion; residual |F - F_set|/(sum g
                                          ///< dx dy)
    std::optional<Discretisation> discretisation;  ///< for model full with contact
    /// Describes the linear equations of the derivatives, if requested: the total number of iterations and the largest
    /// residual.
    std::optional<SolverEvidence> derivatives;
    std::optional<ForceAccuracy> accuracy{};  ///< if requested, with contact and friction
};

/// Arrays have shape [ny, nx], and tractions act on the upper body.
struct ContactSolution {
    double approach = 0;  ///< (mm), prescribed or computed
    Forces forces;
    std::optional<Resultant> resultant;  ///< on curved strips: resultant of all tractions
    double pmax = 0;                     ///< largest pressure (N/mm^2)
    Areas area;
    Counts elements;
    std::vector<ElementState> element_division;
    std::vector<double> pressure;                ///< (N/mm^2), >= 0
    std::vector<double> traction_x, traction_y;  ///< (N/mm^2); zero without friction
    /// The slip of the upper body over the lower is a distance over the step (mm) in a shift; in rolling it is the slip
    /// over the step divided by dq. It is empty without friction, and zero outside the contact.
    std::vector<double> slip_x, slip_y;
    /// Hold the plastic flow of a layer along the tractions, over the step (mm) or per distance rolled like slip, and
    /// its yield stress after the flow (N/mm^2). They are empty without a layer that yields.
    std::vector<double> flow_x, flow_y, yield_stress;
    /// Holds the coefficients of kinetic friction or of temperature-dependent friction with memory. Outside the contact
    /// they are the coefficients of a particle that enters.
    std::vector<double> friction_coefficient;
    /// Along x and y, displacements are those of the upper body's surface minus those of the lower body's under the
    /// tractions (mm). Along z, they are the sum of both bodies' displacements, > 0 under pressure. They are empty
    /// unless requested.
    std::vector<double> displacement_x, displacement_y, displacement_z;
    /// Hold the temperatures of both surfaces (degrees Celsius), in the contact and behind it. They are empty unless
    /// requested.
    std::vector<double> upper_temperature, lower_temperature;
    std::optional<ContactTemperature> temperature;  ///< present with the arrays of temperatures
    /// The elastic energy stored in the bodies is half the sum of traction times displacement (N mm). It requires
    /// displacements.
    std::optional<double> elastic_energy;
    /// Friction dissipates this energy in the step of a shift (N mm), or this power in rolling (N mm/s).
    std::optional<double> frictional_work, frictional_power;
    /// Hold the part dissipated by the flow of a layer, and the largest length of flow, with the units of flow_x. They
    /// require a layer that yields.
    std::optional<double> plastic_work, plastic_power, largest_flow;
    std::optional<RollingResistance> rolling_resistance;  ///< for viscoelastic bodies
    std::optional<ContactWear> wear;                      ///< if requested
    std::optional<ContactFatigue> fatigue;                ///< if requested
    std::optional<Motion> motion;                         ///< requested, or determined by a prescribed force
    std::optional<double> upper_speed;                    ///< speed of wheels on rails, as in the problem (mm/s)
    std::optional<Derivatives> derivatives;               ///< if requested and converged, with contact
    /// Holds the derivative of the pressure by the approach (N/mm^3), zero outside the contact, together with
    /// `derivatives`; it is empty for simplified models. Its sum times the area of an element is dFn/d(approach).
    std::vector<double> pressure_by_approach;
    std::vector<std::string> warnings;  ///< messages for the user of the solution
    ContactEvidence evidence;

    /// Returns whether every solver that ran reached its tolerance. Derivatives are not considered, because those that
    /// did not converge are omitted.
    bool converged() const {
        for (const auto& solver : {evidence.tangential, evidence.outer, evidence.force})
            if (solver && !solver->converged) return false;
        return evidence.normal.converged;
    }
};

/// Names the arrays of a solution.
enum class SolutionField {
    element_division,
    pressure,
    traction_x,
    traction_y,
    slip_x,
    slip_y,
    displacement_x,
    displacement_y,
    displacement_z,
    flow_x,
    flow_y,
    yield_stress,
    friction_coefficient,
    upper_temperature,
    lower_temperature,
    pressure_by_approach
};
/// Selects the arrays to include in an answer.
using SolutionFields = std::vector<SolutionField>;
extern const SolutionFields all_solution_fields;

/// Returns the length of one step (mm): dq, or size_along of the elements if dq is 0.
double step_length(const Rolling& rolling, const Grid& grid);

/// Returns the vector from a particle to its position one step ago (mm): dq (cos chi, sin chi), or zero without
/// rolling.
std::array<double, 2> step_of(const ContactProblem& problem);

/// Returns the quantities besides the set-up that the operators of a problem depend on: the step and, if viscoelastic
/// bodies roll, the velocity, otherwise zero.
std::array<double, 3> rolling_of_operators(const ContactProblem& problem);

/// Throws InvalidArgument, which names the field by its path on the wire, if the problem is invalid.
void validate(const ContactProblem& problem);
/// Checks a problem whose gap and load may be missing because later steps contain them.
void validate_opening(const ContactProblem& problem);

}  // namespace contactd

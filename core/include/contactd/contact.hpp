// Contact problems and their solutions as plain values.
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

/// flow: a layer between the surfaces flows. If it has hardened to the friction bound, the surfaces slip as well.
enum class ElementState : std::uint8_t { exterior = 0, adhesion = 1, slip = 2, flow = 3 };

/// How a solver ended.
struct SolverEvidence {
    int iterations = 0;
    double residual = 0;  ///< the value compared with the tolerance
    bool converged = false;
    double seconds = 0;
};

/// Source of the errors of a discretisation.
enum class ErrorSource { hertz, estimate };

/// How finely the elements divide the contact, and the absolute relative errors against the limit of small elements
/// (docs/contact.md contains measurements).
struct Discretisation {
    int elements_across = 0;  ///< in the direction with fewer, without directions in which the contact fills the grid
    double force_error = 0;   ///< of the normal force for the given approach, whichever was prescribed
    double pmax_error = 0;    ///< of the largest pressure under the prescribed load
    /// Source of both errors: Hertz's closed form for a paraboloid on half-spaces, otherwise an estimate from
    /// elements_across.
    ErrorSource source = ErrorSource::estimate;
    /// Estimated error of the tangential force in rolling under a small creepage, from elements_across and dq. The
    /// error is smaller if most of the contact slips.
    std::optional<double> rolling_error{};
    /// For bodies with layers: the compliance of layers that elements of this size represent, under pressures as wide
    /// as the contact, over their true compliance. Both errors above include it.
    std::optional<double> compliance_ratio{};

    bool operator==(const Discretisation&) const = default;
};

/// Normal contact with a prescribed approach or force and, with friction, tangential contact.
struct ContactProblem : ContactSetup, ContactLoad {};

/// The contact area and its parts (mm^2).
struct Areas {
    double contact = 0, adhesion = 0, slip = 0, flow = 0;
};

/// Numbers of elements.
struct Counts {
    int contact = 0, adhesion = 0, slip = 0, flow = 0;
    int border = 0;  ///< of those in contact, at the border of the potential contact area
};

/// Total forces on the upper body. On curved strips: the component of the pressures along the direction of approach,
/// those of the tangential tractions along x and across both, and their moment about that direction at the strips'
/// origin.
struct Forces {
    double Fn = 0;          ///< normal (N), > 0 in compression
    double Fx = 0, Fy = 0;  ///< tangential (N)
    double Mz = 0;          ///< moment about z at the origin, sum of x p_y - y p_x (N mm)
};

/// Rolling resistance due to the creep of viscoelastic bodies.
struct RollingResistance {
    /// Force that resists rolling (N): the sum of pressures times slopes of the undeformed distance along the rolling
    /// direction.
    double force = 0;
    double power = 0;               ///< dissipated by the bodies, the force times the velocity (N mm/s)
    double centre_of_pressure = 0;  ///< its x (mm)
    double moment = 0;              ///< of the pressures about the axis y, sum of x p (N mm)
    /// Difference of the force from minus the sum of pressures times slopes of the surfaces, which is the hysteresis,
    /// over the sum of pressures times absolute slopes.
    double defect = 0;

    bool operator==(const RollingResistance&) const = default;
};

/// How the solvers of a contact problem ended.
struct ContactEvidence {
    SolverEvidence normal;
    std::optional<SolverEvidence> tangential;
    std::optional<TangentialSolver> tangential_solver;  ///< solver that computed the tractions
    /// Iterations between normal and tangential contact of dissimilar bodies, and between slip and a slip law. The
    /// residual is the relative change of the tractions expected from further iterations, with a slip law the last
    /// one.
    std::optional<SolverEvidence> outer;
    std::optional<SolverEvidence> force;  ///< Newton's iterations, or solves, for the motion; |F - F_set|/(sum g dx dy)
    std::optional<Discretisation> discretisation;  ///< for model full with contact
    /// Evidence of the linear equations of the derivatives, if requested: the total number of iterations, the largest
    /// residual.
    std::optional<SolverEvidence> derivatives;
};

/// Arrays have shape [ny, nx]. Tractions act on the upper body.
struct ContactSolution {
    double approach = 0;  ///< (mm), prescribed or computed
    Forces forces;
    std::optional<Resultant> resultant;  ///< on curved strips: of all tractions together
    double pmax = 0;                     ///< largest pressure (N/mm^2)
    Areas area;
    Counts elements;
    std::vector<ElementState> element_division;
    std::vector<double> pressure;                ///< (N/mm^2), >= 0
    std::vector<double> traction_x, traction_y;  ///< (N/mm^2); zero without friction
    /// Slip of the upper body over the lower: in a shift the distance over the step (mm), in rolling the slip over the
    /// step divided by dq. Empty without friction; zero outside the contact.
    std::vector<double> slip_x, slip_y;
    /// Plastic flow of a layer along the tractions, over the step (mm) or per distance rolled like slip, and its yield
    /// stress after the flow (N/mm^2). Empty without a layer that yields.
    std::vector<double> flow_x, flow_y, yield_stress;
    /// Coefficients of kinetic friction or of temperature-dependent friction with memory; outside the contact the
    /// coefficients of a particle that enters.
    std::vector<double> friction_coefficient;
    /// Displacements of the upper body's surface minus those of the lower body's under the tractions (mm) along x and
    /// y; along z the sum of the displacements of both bodies, > 0 under pressure. Empty unless requested.
    std::vector<double> displacement_x, displacement_y, displacement_z;
    /// Temperatures of both surfaces (degrees Celsius), in the contact and behind it. Empty unless requested.
    std::vector<double> upper_temperature, lower_temperature;
    std::optional<ContactTemperature> temperature;  ///< with these
    /// Half the sum of traction times displacement (N mm), the elastic energy stored in the bodies. Requires
    /// displacements.
    std::optional<double> elastic_energy;
    /// Energy dissipated by friction in the step of a shift (N mm), or power in rolling (N mm/s).
    std::optional<double> frictional_work, frictional_power;
    /// Part dissipated by the flow of a layer, and the largest length of flow, like flow_x. Requires a layer that
    /// yields.
    std::optional<double> plastic_work, plastic_power, largest_flow;
    std::optional<RollingResistance> rolling_resistance;  ///< for viscoelastic bodies
    std::optional<ContactWear> wear;                      ///< if requested
    std::optional<ContactFatigue> fatigue;                ///< if requested
    std::optional<Motion> motion;                         ///< as requested, or as determined by a prescribed force
    std::optional<double> upper_speed;                    ///< of wheels on rails, as in the problem (mm/s)
    std::optional<Derivatives> derivatives;               ///< if requested and converged, with contact
    std::vector<std::string> warnings;                    ///< messages for the user of the solution
    ContactEvidence evidence;

    /// Returns whether every solver of the problem that ran reached its tolerance. Derivatives that did not converge
    /// are omitted.
    bool converged() const {
        for (const auto& solver : {evidence.tangential, evidence.outer, evidence.force})
            if (solver && !solver->converged) return false;
        return evidence.normal.converged;
    }
};

/// The arrays of a solution.
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
    lower_temperature
};
/// The arrays to include in an answer.
using SolutionFields = std::vector<SolutionField>;
inline const SolutionFields all_solution_fields{SolutionField::element_division,
                                                SolutionField::pressure,
                                                SolutionField::traction_x,
                                                SolutionField::traction_y,
                                                SolutionField::slip_x,
                                                SolutionField::slip_y,
                                                SolutionField::displacement_x,
                                                SolutionField::displacement_y,
                                                SolutionField::displacement_z,
                                                SolutionField::flow_x,
                                                SolutionField::flow_y,
                                                SolutionField::yield_stress,
                                                SolutionField::friction_coefficient,
                                                SolutionField::upper_temperature,
                                                SolutionField::lower_temperature};

/// Returns the length of one step (mm): dq, or size_along of the elements where dq is 0.
double step_length(const Rolling& rolling, const Grid& grid);

/// Returns the vector from a particle to its position one step ago (mm): dq (cos chi, sin chi); zero without rolling.
std::array<double, 2> step_of(const ContactProblem& problem);

/// Returns the quantities that the operators of a problem depend on in addition to its set-up: the step, and for
/// rolling viscoelastic bodies the velocity, otherwise zero.
std::array<double, 3> rolling_of_operators(const ContactProblem& problem);

/// Throws InvalidArgument naming the field by its path on the wire if the problem is invalid.
void validate(const ContactProblem& problem);
/// Checks a problem whose gap and load may be missing because later steps contain them.
void validate_opening(const ContactProblem& problem);

}  // namespace contactd

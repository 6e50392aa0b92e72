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

/// flow: a layer between the surfaces flows; where it has hardened to the bound of friction they slip as well.
enum class ElementState : std::uint8_t { exterior = 0, adhesion = 1, slip = 2, flow = 3 };

/// How a solver ended.
struct SolverEvidence {
    int iterations = 0;
    double residual = 0;  ///< the figure compared with the tolerance
    bool converged = false;
    double seconds = 0;
};

/// Where the errors of a discretisation are known from.
enum class ErrorSource { hertz, estimate };

/// How finely the elements divide the contact, and what that costs: sizes of relative errors against the limit of small
/// elements (docs/contact.md, which has them measured).
struct Discretisation {
    int elements_across = 0;  ///< in the direction with fewer; one in which the contact fills the grid does not count
    double force_error = 0;   ///< of the normal force for the approach, whichever of them was prescribed
    double pmax_error = 0;    ///< of the largest pressure under the prescribed load
    /// The source of both errors: Hertz's closed form, where the gap is a paraboloid on half-spaces, or an estimate
    /// from elements_across.
    ErrorSource source = ErrorSource::estimate;
    /// Estimated error of the tangential force in rolling under a small creepage, from elements_across and dq. Where
    /// most of the contact slips the force errs by less.
    std::optional<double> rolling_error{};
    /// Where a body has layers: how compliant elements of this size make them to pressures as wide as the contact, over
    /// how compliant they are. Both errors above have it in them.
    std::optional<double> compliance_ratio{};

    bool operator==(const Discretisation&) const = default;
};

/// Normal contact, the approach or the force prescribed, and tangential contact where there is friction.
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

/// In total, on the upper body. On curved strips: of pressures what is along the direction of approach, of tangential
/// tractions what is along x and across both, and their moment about that direction at the strips' origin.
struct Forces {
    double Fn = 0;          ///< normal (N), > 0 in compression
    double Fx = 0, Fy = 0;  ///< tangential (N)
    double Mz = 0;          ///< moment about z at the origin, sum of x p_y - y p_x (N mm)
};

/// What the creep of viscoelastic bodies takes of rolling.
struct RollingResistance {
    /// Sum of pressures times the slopes of the undeformed distance along the rolling direction (N): it resists
    /// rolling.
    double force = 0;
    double power = 0;               ///< that the bodies dissipate, the force times the velocity (N mm/s)
    double centre_of_pressure = 0;  ///< its x (mm)
    double moment = 0;              ///< of the pressures about the axis y, sum of x p (N mm)
    /// What the force is off by the slopes of the surfaces, whose work is the hysteresis: over the sum of pressures
    /// times the sizes of the slopes.
    double defect = 0;

    bool operator==(const RollingResistance&) const = default;
};

/// How the solvers of a contact problem ended.
struct ContactEvidence {
    SolverEvidence normal;
    std::optional<SolverEvidence> tangential;
    std::optional<TangentialSolver> tangential_solver;  ///< which of them found the tractions
    /// Between normal and tangential contact of dissimilar bodies, and between slip and a slip law: iterations, and
    /// what further ones would change of the tractions, relative; with a slip law the last change.
    std::optional<SolverEvidence> outer;
    std::optional<SolverEvidence> force;  ///< Newton's iterations, or solves, for the motion; |F - asked|/(sum g dx dy)
    std::optional<Discretisation> discretisation;  ///< of model full, where there is contact
    /// Evidence of the linear equations of the derivatives, where these were asked for: iterations of all, the largest
    /// residual.
    std::optional<SolverEvidence> derivatives;
};

/// Arrays have shape [ny, nx]. Tractions act on the upper body.
struct ContactSolution {
    double approach = 0;  ///< (mm), prescribed or found
    Forces forces;
    std::optional<Resultant> resultant;  ///< on curved strips: of all tractions together
    double pmax = 0;                     ///< largest pressure (N/mm^2)
    Areas area;
    Counts elements;
    std::vector<ElementState> element_division;
    std::vector<double> pressure;                ///< (N/mm^2), >= 0
    std::vector<double> traction_x, traction_y;  ///< (N/mm^2); zero without friction
    /// Slip of the upper body over the lower: of a shift the distance over the step (mm), of rolling the slip over the
    /// step divided by dq. Empty without friction; zero outside contact.
    std::vector<double> slip_x, slip_y;
    /// Plastic flow of a layer along the tractions, over the step (mm) or per distance rolled as slip, and its yield
    /// stress behind it (N/mm^2). Empty without a layer that yields.
    std::vector<double> flow_x, flow_y, yield_stress;
    /// Coefficients of kinetic friction or of friction by temperature with memory; outside contact those on entry.
    std::vector<double> friction_coefficient;
    /// Displacements of the upper body's surface less those of the lower one's under the tractions (mm): along x and y,
    /// and along z what the bodies yield, > 0 under pressure. Where asked for; elsewhere empty.
    std::vector<double> displacement_x, displacement_y, displacement_z;
    /// Temperatures of both surfaces (degrees Celsius), in contact and behind it. Where asked for; elsewhere empty.
    std::vector<double> upper_temperature, lower_temperature;
    std::optional<ContactTemperature> temperature;  ///< with these
    /// Half the sum of traction times displacement (N mm), which is the energy that elastic bodies have stored; with
    /// displacements.
    std::optional<double> elastic_energy;
    /// The energy that friction dissipates: in the step of a shift (N mm), or the power of rolling (N mm/s).
    std::optional<double> frictional_work, frictional_power;
    /// What of that the flow of a layer dissipates, and the largest length of flow, as flow_x; where a layer yields.
    std::optional<double> plastic_work, plastic_power, largest_flow;
    std::optional<RollingResistance> rolling_resistance;  ///< of viscoelastic bodies
    std::optional<ContactWear> wear;                      ///< where asked for
    std::optional<ContactFatigue> fatigue;                ///< where asked for
    std::optional<Motion> motion;                         ///< as asked, with what a prescribed force made of it
    std::optional<Derivatives> derivatives;               ///< where asked for, of a converged solution with contact
    std::vector<std::string> warnings;                    ///< sentences: what a user of the solution should know
    ContactEvidence evidence;

    /// True when every solver of the problem that ran reached its tolerance; derivatives that did not are left out.
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
/// Those that an answer shall hold.
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

/// The way from a particle to where it was one step ago (mm): dq (cos chi, sin chi); zero unless the bodies roll.
std::array<double, 2> step_of(const ContactProblem& problem);

/// Returns what the operators of a problem depend on beside its set-up: the step, and of viscoelastic bodies that roll
/// the velocity, else zero.
std::array<double, 3> rolling_of_operators(const ContactProblem& problem);

/// Throws InvalidArgument naming the field as on the wire when the problem cannot be solved as stated.
void validate(const ContactProblem& problem);
/// Checks likewise, but gap and load may be missing: later steps bring them.
void validate_opening(const ContactProblem& problem);

}  // namespace contactd

// Contact problems and their solutions as plain values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "contactd/friction.hpp"
#include "contactd/gap.hpp"
#include "contactd/given_ics.hpp"
#include "contactd/grid.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/material.hpp"

namespace contactd {

enum class ElementState : std::uint8_t { exterior = 0, adhesion = 1, slip = 2 };

/// Stop test and bound of one iterative solver.
struct SolverSettings {
    double tolerance = 1e-6;  ///< of the paper's stop tests (sections 4.1 and 4.2)
    int max_iterations = 1000;

    bool operator==(const SolverSettings&) const = default;
};

/// How a solver ended.
struct SolverEvidence {
    int iterations = 0;
    double residual = 0;  ///< the figure compared with the tolerance
    bool converged = false;
    double seconds = 0;
};

/// How finely the elements divide the contact, and what that costs: sizes of relative errors against the limit of small
/// elements (docs/contact.md, which has them measured).
struct DiscretisationEvidence {
    int elements_across = 0;  ///< in the direction with fewer; one in which the contact fills the grid does not count
    double force_error = 0;   ///< of the normal force for the approach, whichever of them was prescribed
    double pmax_error = 0;    ///< of the largest pressure under the prescribed load
    /// Both by Hertz's closed form: the gap is a paraboloid on half-spaces. Else they are estimates from
    /// elements_across.
    bool from_hertz = false;
    /// Of rolling, an estimate: of the tangential force under a small creepage, from elements_across and dq. Where most
    /// of the contact slips the force errs by less.
    std::optional<double> rolling_error{};

    bool operator==(const DiscretisationEvidence&) const = default;
};

/// full: boundary elements (NORM, TangCG, steady rolling). hertz: closed forms for elliptic contact. fastsim: Hertzian
/// contact with Kalker's simplified theory of rolling. The quick ones need a paraboloid or semi-axes.
enum class Model { full, hertz, fastsim };

/// Tractions at the end of the step before, each empty (zero) or of shape [ny, nx] (N/mm^2), on the upper body.
struct PreviousState {
    std::vector<double> pressure, traction_x, traction_y;

    bool empty() const { return pressure.empty() && traction_x.empty() && traction_y.empty(); }
    bool operator==(const PreviousState&) const = default;
};

/// Normal contact, the approach or the force prescribed, and tangential contact where `friction` is given.
struct ContactProblem {
    Grid grid;
    BodyPair bodies;
    Ics ics;                            ///< of both bodies
    std::optional<GivenIcs> given_ics;  ///< instead of computed ones; bodies and ics mean nothing then
    Gap gap;                            ///< undeformed distance h without the approach
    /// Either of these two. The approach is delta (mm), the gap before deformation h - delta; with the normal force
    /// (N, >= 0) prescribed instead it is found.
    std::optional<double> approach, Fn;
    Model model = Model::full;
    std::optional<Friction> friction;            ///< absent: frictionless
    PreviousState previous;                      ///< where a shift or a transient step starts
    SolverSettings normal_settings{1e-8, 1000};  ///< ||d||_rms / ||h||_rms; all else builds on the pressures
    SolverSettings tangential_settings;          ///< ||p_t - p_t,old|| / ||p_t||, and the estimated error
    SolverSettings outer_settings{1e-6, 100};    ///< of the loop that bodies that differ, slip laws and forces need
    std::vector<double> initial_pressure;        ///< empty, or an estimate, shape [ny, nx]
    std::vector<double> initial_traction_x, initial_traction_y;  ///< empty, or estimates
};

/// Arrays have shape [ny, nx]. Tractions act on the upper body.
struct ContactSolution {
    double approach = 0;      ///< (mm), prescribed or found
    double Fn = 0;            ///< normal force (N), > 0 in compression
    double Fx = 0, Fy = 0;    ///< tangential force on the upper body (N)
    double Mz = 0;            ///< moment about z at the origin, sum of x p_y - y p_x (N mm)
    double pmax = 0;          ///< largest pressure (N/mm^2)
    double contact_area = 0;  ///< (mm^2)
    double adhesion_area = 0, slip_area = 0;
    int contact_elements = 0, adhesion_elements = 0, slip_elements = 0;
    int border_elements = 0;  ///< contact elements at the border of the potential contact area
    std::vector<ElementState> element_division;
    std::vector<double> pressure;                ///< (N/mm^2), >= 0
    std::vector<double> traction_x, traction_y;  ///< (N/mm^2); zero without friction
    /// Slip of the upper body over the lower: of a shift the distance over the step (mm), of rolling the slip over the
    /// step divided by dq. Empty without friction; zero outside contact.
    std::vector<double> slip_x, slip_y;
    /// Of a shift what friction dissipates in the step (N mm); of rolling its power (N mm/s).
    std::optional<double> frictional_work, frictional_power;
    std::optional<Motion> motion;       ///< as asked, with what a prescribed force made of it
    std::vector<std::string> warnings;  ///< sentences: what a user of the solution should know
    SolverEvidence normal;
    std::optional<SolverEvidence> tangential;
    /// Between normal and tangential contact of bodies that differ, and between slip and a slip law: iterations, the
    /// last relative change of the tractions.
    std::optional<SolverEvidence> outer;
    std::optional<SolverEvidence> force;  ///< of the search for the motion: the last |F - prescribed| over the bound
    std::optional<DiscretisationEvidence> discretisation;  ///< of model full, where there is contact

    /// True when every solver that ran reached its tolerance.
    bool converged() const {
        for (const auto& evidence : {tangential, outer, force})
            if (evidence && !evidence->converged) return false;
        return normal.converged;
    }
};

/// Of one step (mm): dq, or size_along of the elements where dq is 0.
double step_length(const Rolling& rolling, const Grid& grid);

/// The paraboloid of the gap, with the radii that semi-axes stand for under the load; nothing for an array.
std::optional<Paraboloid> paraboloid_of(const ContactProblem& problem);

/// Whether its coefficients are those of a line contact.
bool is_line_contact(const ContactProblem& problem);

/// Throws InvalidArgument ("approach" or "Fn") unless one of the two is prescribed, and only one.
void require_load(const ContactProblem& problem);

/// h at the element centres, shape [ny, nx] (mm), of any gap the problem has.
std::vector<double> undeformed_distance(const ContactProblem& problem);

/// Throws InvalidArgument naming the field as on the wire when the problem cannot be solved as stated.
void validate(const ContactProblem& problem);

}  // namespace contactd

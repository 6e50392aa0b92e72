#include "simplified_models.hpp"

#include <chrono>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "cattaneo_mindlin.hpp"
#include "closed_forms/elements/element_friction.hpp"
#include "closed_forms/elliptic_contact.hpp"
#include "closed_forms/undeformed_distance.hpp"
#include "contactd/error.hpp"
#include "contactd/fields/contact_setup.hpp"
#include "fastsim.hpp"
#include "simplified_derivatives.hpp"
#include "vermeulen_johnson.hpp"

namespace contactd {
namespace {

[[noreturn]] void unknown(const ContactProblem& problem, const char* field, const std::string& what) {
    throw InvalidArgument(
        field, what + ", which model " + std::string(name_of(problem.model)) + " does not support: use model full");
}

HertzContact line_hertz(const ContactProblem& problem, const LineContactSpec& line) {
    const double compliance = problem.bodies.materials().normal_compliance();
    const auto& paraboloid = std::get<Paraboloid>(*problem.gap);
    check_is_curved(paraboloid.Rx, "gap.paraboloid.Rx");
    const CylinderGap gap{paraboloid.Rx, problem.grid.dy, line.datum};
    return problem.Fn ? hertz_of_line_force(gap, compliance, *problem.Fn)
                      : hertz_of_line_approach(gap, compliance, *problem.approach);
}

HertzContact hertz(const ContactProblem& problem) {
    const auto line = line_contact_of(problem.bodies);
    return line ? line_hertz(problem, *line) : hertz_of(problem);
}

void check_is_elliptic(const ContactProblem& problem) {
    if (std::holds_alternative<std::vector<double>>(*problem.gap)) unknown(problem, "gap", "is an array");
    if (problem.bodies.pair) unknown(problem, "ics", "contains a table of coefficients");
}

void check_is_simple(const ContactProblem& problem) {
    const FrictionLaw& friction = *problem.friction;
    if (friction.mu.size() != 1) unknown(problem, "friction.mu", "differs from element to element");
    if (friction.kinetic && !rolls_on_elements(problem))
        unknown(problem, "friction.kinetic", "makes friction depend on the slip");
    if (friction.kinetic && friction.kinetic->memory)
        unknown(problem, "friction.kinetic.memory", "makes friction depend on the history of particles");
    if (friction.temperature) unknown(problem, "friction.temperature", "makes friction depend on the temperature");
    if (!problem.previous.empty()) unknown(problem, "previous", "starts from tractions");
    if (!problem.rigid_slip.empty()) unknown(problem, "friction.rigid_slip", "differs from element to element");
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (rolling && !rolling->steady()) unknown(problem, "friction.rolling.kind", "is transient");
    if (!rolling && problem.model != Model::hertz) unknown(problem, "friction", "is a shift");
}

/// FaStrip requires Hertz's pressures.
TractionBound bound_of(const ContactProblem& problem) {
    return problem.model == Model::fastsim ? problem.simplified.bound : TractionBound::elliptic;
}

EllipticFriction friction_of(const ContactProblem& problem, const EllipticContact& contact,
                             std::vector<std::string>& warnings) {
    if (rolls_on_elements(problem))
        return element_friction(problem, patch_of(problem.grid, contact, bound_of(problem)), warnings);
    constexpr double least_mu = 1e-100;  // Products of smaller coefficients with pressures are too small as divisors.
    const double given = problem.friction->mu[0], mu = given >= least_mu ? given : 0;
    if (const auto* shift = std::get_if<Shift>(&problem.motion))
        return cattaneo_mindlin(problem.grid, contact, mu, *shift);
    const auto& rolling = std::get<Rolling>(problem.motion);
    if (problem.model == Model::fastsim) return fastsim(problem.grid, contact, mu, rolling);
    return vermeulen_johnson(problem.grid, contact, mu, rolling);
}

void take_friction(EllipticFriction friction, ContactSolution& solution) {
    solution.forces = {solution.forces.Fn, friction.Fx, friction.Fy, friction.Mz};
    solution.area.adhesion = friction.adhesion_area;
    solution.area.slip = friction.slip_area;
    solution.element_division = std::move(friction.element_division);
    solution.traction_x = std::move(friction.traction_x);
    solution.traction_y = std::move(friction.traction_y);
    solution.slip_x = std::move(friction.slip_x);
    solution.slip_y = std::move(friction.slip_y);
    solution.friction_coefficient = std::move(friction.friction_coefficient);
    solution.frictional_power = friction.frictional_power;
    solution.motion = friction.motion;
    solution.evidence.force = friction.force;
}

void take_no_friction(ContactSolution& solution) {
    const std::size_t elements = solution.pressure.size();
    solution.area.slip = solution.area.contact;
    solution.element_division.resize(elements);
    for (std::size_t i = 0; i < elements; ++i)
        solution.element_division[i] = solution.pressure[i] > 0 ? ElementState::slip : ElementState::exterior;
    solution.traction_x.resize(elements);
    solution.traction_y.resize(elements);
}

void differentiate(const ContactProblem& problem, const EllipticContact& contact, ContactSolution& solution) {
    if (contact.empty() || !solution.converged()) {
        solution.warnings.push_back(contact.empty() ? "There is no contact, so there are no derivatives."
                                                    : "The solution did not converge, so it has no derivatives.");
        return;
    }
    const auto start = std::chrono::steady_clock::now();
    solution.derivatives = simplified_derivatives(problem, contact, solution);
    const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
    solution.evidence.derivatives = SolverEvidence{0, 0, true, duration.count()};  // This is a closed form.
}

ContactSolution solve_on_pressures(const ContactProblem& problem, const PenetrationContact& found) {
    ContactSolution solution;
    solution.evidence.normal = found.evidence;
    solution.warnings = found.warnings;
    solution.approach = found.approach;
    solution.forces.Fn = found.Fn;
    solution.pmax = found.pmax;
    solution.pressure = found.pressure;
    const ElementPatch patch = patch_of(problem.grid, found.pressure, combined_material(problem.bodies.materials()));
    solution.area.contact = patch.area;
    if (problem.friction)
        take_friction(element_friction(problem, patch, solution.warnings), solution);
    else
        take_no_friction(solution);
    return solution;
}

}  // namespace

ContactSolution solve_by_simplified_model(const ContactProblem& problem, const PenetrationContact* penetration) {
    if (penetration == nullptr) check_is_elliptic(problem);
    if (problem.friction) check_is_simple(problem);
    if (penetration != nullptr) return solve_on_pressures(problem, *penetration);
    const HertzContact found = hertz(problem);
    EllipticContact contact{{found.a, found.b}, found.Fn, combined_material(problem.bodies.materials())};
    if (const auto line = line_contact_of(problem.bodies)) {
        contact.length = problem.grid.dy;
        contact.datum = line->datum;
    }
    ContactSolution solution;
    solution.evidence.normal.converged = true;  // This is a closed form.
    solution.approach = found.approach;
    solution.forces.Fn = found.Fn;
    solution.pmax = found.pmax;
    solution.area.contact = contact.area();
    solution.pressure = hertz_pressure(problem.grid, contact);
    if (problem.friction)
        take_friction(friction_of(problem, contact, solution.warnings), solution);
    else
        take_no_friction(solution);
    if (problem.derivatives) differentiate(problem, contact, solution);
    return solution;
}

}  // namespace contactd

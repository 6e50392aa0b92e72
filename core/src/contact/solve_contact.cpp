#include "contactd/solve_contact.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "closed_forms/elements/element_friction.hpp"
#include "closed_forms/simplified/simplified_models.hpp"
#include "closed_forms/undeformed_distance.hpp"
#include "contact/answers/contact_temperature.hpp"
#include "contact/answers/displacements.hpp"
#include "contact/answers/viscoelastic_rolling.hpp"
#include "contact/friction/curved_strips.hpp"
#include "contact/normal/normal.hpp"
#include "contact/outer/boundary_elements.hpp"
#include "contact/penetration/virtual_penetration.hpp"
#include "contact/rolling/rolling.hpp"
#include "contact/support/problem_of_regions.hpp"
#include "contact/support/sheets_between.hpp"
#include "contact/warnings/discretisation.hpp"
#include "contact/warnings/layer_resolution.hpp"
#include "contact/warnings/uniqueness.hpp"
#include "contact/warnings/unit_warnings.hpp"
#include "contactd/error.hpp"
#include "contactd/strip_frames.hpp"
#include "fatigue/contact_fatigue.hpp"
#include "types/number_text.hpp"
#include "wear/contact_wear.hpp"

namespace contactd {
namespace {

/// Returns the ends of a longitudinally uniform body by finite elements. The half-space of an analytic one continues
/// beyond an edge.
StripEnds ends_of(const Body& body, const Grid& grid, const char* name) {
    if (body.section() == nullptr || body.computed()->source == IcSource::analytic) return {};
    return strip_ends(*body.section(), grid.ny, grid.dy, name);
}

/// Returns whether one row of long elements represents a line contact, whose ends are not those of a contact that
/// continues beyond them.
bool is_long_row(const ContactProblem& problem, const ContactSolution& solution) {
    // If rows are longer than the contact by this factor, the error of pressures is less than a percent.
    constexpr double longer = 5;
    if (problem.grid.ny != 1 || !problem.gap) return false;
    const auto* paraboloid = std::get_if<Paraboloid>(&*problem.gap);
    const bool is_cylinder = paraboloid != nullptr && !std::isfinite(paraboloid->Ry);
    if (!is_cylinder && !std::holds_alternative<std::vector<double>>(*problem.gap)) return false;
    return problem.grid.dy >= longer * solution.elements.contact * problem.grid.dx;
}

BorderRows border_rows(const ContactProblem& problem, const ContactSolution& solution) {
    if (is_line_contact(problem) || is_long_row(problem, solution)) return {false, false};
    if (!problem.bodies.any_uniform()) return {};
    const StripEnds below = ends_of(problem.bodies.lower, problem.grid, "bodies.lower.ics.section"),
                    above = ends_of(problem.bodies.upper, problem.grid, "bodies.upper.ics.section");
    // The upper body's strips are in reverse order.
    return {!below.first && !above.last, !below.last && !above.first};
}

void count_elements(const ContactProblem& problem, ContactSolution& solution) {
    for (const ElementState state : solution.element_division) {
        if (state == ElementState::adhesion) ++solution.elements.adhesion;
        if (state == ElementState::slip) ++solution.elements.slip;
        if (state == ElementState::flow) ++solution.elements.flow;
    }
    solution.elements.contact = solution.elements.adhesion + solution.elements.slip + solution.elements.flow;
    solution.elements.border = border_elements(problem.grid, solution.pressure);
    if (solution.elements.border > 0)  // This evaluates sections.
        solution.elements.border = border_elements(problem.grid, solution.pressure, border_rows(problem, solution));
}

void sum_up(const ContactSetup& setup, ContactSolution& solution) {
    const Grid& grid = setup.grid;
    const double area = grid.element_area();
    for (const double p : solution.pressure) {
        solution.forces.Fn += p * area;
        solution.pmax = std::max(solution.pmax, p);
    }
    const TangentialForces forces = tangential_forces(grid, solution.traction_x, solution.traction_y);
    solution.forces = {solution.forces.Fn, forces.Fx, forces.Fy, forces.Mz};
    if (setup.columns) sum_forces(*setup.columns, grid, solution);
    solution.area.contact = solution.elements.contact * area;
    solution.area.adhesion = solution.elements.adhesion * area;
    solution.area.slip = solution.elements.slip * area;
    solution.area.flow = solution.elements.flow * area;
}

/// Slip in rolling is per distance rolled; the solvers do not divide by that distance. Adhesion dissipates nothing: its
/// slip is within the tolerance. The sum is not corrected: one clearly below zero indicates a wrong solution.
void take_friction_losses(const ContactProblem& problem, ContactSolution& solution) {
    if (!solution.motion) return;
    double work = 0;
    for (std::size_t i = 0; i < solution.slip_x.size(); ++i)
        if (solution.element_division[i] > ElementState::adhesion)
            work -= solution.slip_x[i] * solution.traction_x[i] + solution.slip_y[i] * solution.traction_y[i];
    work *= problem.grid.element_area();
    double plastic = 0, largest_flow = 0;
    for (std::size_t i = 0; i < solution.flow_x.size(); ++i) {
        plastic += solution.flow_x[i] * solution.traction_x[i] + solution.flow_y[i] * solution.traction_y[i];
        largest_flow = std::max(largest_flow, std::hypot(solution.flow_x[i], solution.flow_y[i]));
    }
    plastic *= problem.grid.element_area();
    work += plastic;
    const bool yields = !solution.flow_x.empty();
    const auto* rolling = std::get_if<Rolling>(&*solution.motion);
    if (rolling == nullptr) {
        solution.frictional_work = work;
        if (yields) {
            solution.plastic_work = plastic;
            solution.largest_flow = largest_flow;
        }
        return;
    }
    const double dq = step_length(*rolling, problem.grid);
    for (auto* slip : {&solution.slip_x, &solution.slip_y, &solution.flow_x, &solution.flow_y})
        for (double& s : *slip) s /= dq;
    solution.frictional_power = work / dq * rolling->velocity;
    if (yields) {
        solution.plastic_power = plastic / dq * rolling->velocity;
        solution.largest_flow = largest_flow / dq;
    }
}

/// Closed forms treat each strip as the surface of a half-space. They neglect the edge of a block and its support.
void warn_of_edges(const ContactProblem& problem, ContactSolution& solution) {
    const Grid& grid = problem.grid;
    int first = grid.ny, last = -1;
    for (int row = 0; row < grid.ny; ++row) {
        const auto begin = solution.element_division.begin() + static_cast<std::ptrdiff_t>(row) * grid.nx;
        if (std::all_of(begin, begin + grid.nx, [](ElementState state) { return state == ElementState::exterior; }))
            continue;
        first = std::min(first, row);
        last = row;
    }
    if (last < 0) return;
    const double width = (last - first + 1) * grid.dy;
    const auto warn_of = [&](const Body& body, const std::string& name, int rows_beyond) {
        const Ics* ics = body.computed();
        const auto* block = ics != nullptr && ics->source == IcSource::analytic && ics->section
                                ? std::get_if<EdgeBlock>(&ics->section->shape)
                                : nullptr;
        if (block == nullptr) return;
        const double size = ics->section->size, edge = rows_beyond * grid.dy + size * block->edge_distance;
        if (edge < width)
            solution.warnings.push_back("The edge of bodies." + name + " is " + short_text(edge) +
                                        " mm from the contact, which is " + short_text(width) +
                                        " mm wide. Closed forms neglect edges; use ics.source fem.");
        if (size * block->height < width)
            solution.warnings.push_back(
                "The block of bodies." + name + " is " + short_text(size * block->height) +
                " mm high, and the contact is " + short_text(width) +
                " mm wide. Closed forms neglect the support below the block; use ics.source fem.");
    };
    warn_of(problem.bodies.upper, "upper", first);  // The upper body's strips are in reverse order.
    warn_of(problem.bodies.lower, "lower", grid.ny - 1 - last);
}

bool sums_over_elements(const ContactProblem& problem) {
    return problem.friction && problem.model != Model::polach && rolls_on_elements(problem);
}

void warn(const ContactProblem& problem, ContactSolution& solution) {
    warn_of_edges(problem, solution);
    for (std::string& warning : unit_warnings(problem, solution)) solution.warnings.push_back(std::move(warning));
    for (std::string& warning : creep_warnings(problem, solution)) solution.warnings.push_back(std::move(warning));
    if (problem.model == Model::full)
        for (std::string& warning : discretisation_warnings(problem, solution))
            solution.warnings.push_back(std::move(warning));
    else if (solution.forces.Fn > 0 && solution.elements.contact == 0)
        solution.warnings.push_back(
            std::string("No element has its centre in the contact, which is narrower than the elements or lies beyond "
                        "the potential contact area: ") +
            (sums_over_elements(problem)
                 ? "tangential forces, which are sums over the elements, do not include it."
                 : "the forces are those of the whole contact, but the arrays do not show it."));
    if (solution.elements.border == 0) return;
    const bool one = solution.elements.border == 1;
    solution.warnings.push_back(std::to_string(solution.elements.border) +
                                (one ? " contact element touches" : " contact elements touch") +
                                " the border of the potential contact area. The contact may extend beyond it, which "
                                "the solution neglects. Use a larger grid.");
}

void find_wear(const ContactProblem& problem, ContactSolution& solution) {
    if (!problem.wear || !solution.motion) return;
    const WearPlace place = wear_place(problem, std::get<Rolling>(*solution.motion));
    solution.wear = contact_wear(*problem.wear, problem, place, solution);
}

void find_fatigue(const ContactProblem& problem, ContactSolution& solution, Observer& observer) {
    if (!problem.fatigue || !solution.motion) return;
    const FatiguePlace place = fatigue_place(problem, std::get<Rolling>(*solution.motion));
    solution.fatigue = contact_fatigue(problem, place, solution, observer);
}

ContactSolution simplified(const ContactProblem& problem) {
    if (problem.normal_model == NormalModel::of_model) return solve_by_simplified_model(problem);
    const PenetrationContact penetration = penetration_contact(problem, undeformed_distance(problem));
    return solve_by_simplified_model(problem, &penetration);
}

ContactSolution solve_valid(const ContactProblem& problem, const ContactInfluence& influence, Observer& observer) {
    if (problem.model != Model::full) {
        ContactSolution solution = simplified(problem);
        count_elements(problem, solution);
        find_temperature(problem, solution, observer);
        find_wear(problem, solution);
        find_fatigue(problem, solution, observer);
        warn(problem, solution);
        return solution;
    }
    if (influence.current->size() != problem.grid.size())
        throw InvalidArgument("grid", "has " + std::to_string(problem.grid.size()) +
                                          " elements; the influence coefficients are for " +
                                          std::to_string(influence.current->size()));
    require_layers_resolved(problem);
    const ContactInfluence bodies = with_sheets(problem, influence);
    ContactSolution solution = solve_boundary_elements(problem, bodies, observer);
    count_elements(problem, solution);
    sum_up(problem, solution);
    take_friction_losses(problem, solution);
    find_temperature(problem, solution, observer);
    find_wear(problem, solution);
    find_fatigue(problem, solution, observer);
    if (problem.displacements) find_displacements(problem.grid, *bodies.current, solution);
    solution.evidence.discretisation = discretisation(problem, solution, problem.friction && bodies.current->coupled());
    warn(problem, solution);
    for (std::string& warning : friction_warnings(problem, *bodies.current, solution, observer))
        solution.warnings.push_back(std::move(warning));
    solution.warnings.insert(solution.warnings.end(), influence.warnings.begin(), influence.warnings.end());
    return solution;
}

ContactSolution solve_checked(const ContactProblem& problem, const ContactInfluence& influence, Observer& observer) {
    if (!problem.bodies.any_viscoelastic()) return solve_valid(problem, influence, observer);
    ContactProblem rolling = problem;
    rolling.bodies = without_instant_creep(problem.bodies);
    ContactSolution solution = solve_valid(rolling, influence, observer);
    solution.rolling_resistance = rolling_resistance(problem, *influence.current, solution);
    return solution;
}

}  // namespace

ContactSolution solve_contact(const ContactProblem& problem, const ContactInfluence& influence, Observer& observer) {
    validate(problem);
    if (!problem.regions) return solve_checked(problem, influence, observer);
    const ProblemOfRegions plain(problem, influence);
    return solve_checked(plain.problem, plain.influence, observer);
}

}  // namespace contactd

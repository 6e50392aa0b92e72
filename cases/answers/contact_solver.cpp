#include "contact_solver.hpp"

#include "contact/answers/displacements.hpp"
#include "contact/support/problem_of_regions.hpp"
#include "contactd/half_space.hpp"
#include "contactd/ic_record.hpp"
#include "contactd/observer.hpp"
#include "contactd/solve_contact.hpp"
#include "operators/region_operator.hpp"
#include "wheel_rail/mirror.hpp"

namespace contactd::cases {
namespace {

BodyTable table_of(const Grid& grid, const Body& body) {
    const Ics* ics = body.computed();
    if (ics == nullptr) return IcTable(grid.nx, grid.ny);
    const IcSpec spec{*ics, without_instant_creep({body, body}).upper.material, grid.dx, grid.dy, grid.nx, grid.ny};
    IcRecord record;  // the same as that of closed_form_record, but without its evidence, which is not needed
    record.spec = dimensionless(spec);
    record.tables = half_space_table(record.spec);
    return body_table(record, spec);
}

/// Returns the part of a solution that determines the displacements.
ContactSolution tractions_of(const ContactSolution& solution) {
    ContactSolution part;
    part.pressure = solution.pressure;
    part.traction_x = solution.traction_x;
    part.traction_y = solution.traction_y;
    return part;
}

/// Adds the shear of a layer between the bodies, its flexibility times the traction, and the compression of a sheet.
Displacements with_layer(const ContactProblem& problem, ContactSolution u) {
    if (problem.sheet_flexibility > 0)
        for (std::size_t i = 0; i < u.pressure.size(); ++i)
            u.displacement_z[i] += problem.sheet_flexibility * u.pressure[i];
    if (problem.friction && problem.friction->layer)
        for (std::size_t i = 0; i < u.traction_x.size(); ++i) {
            u.displacement_x[i] += problem.friction->layer->flexibility * u.traction_x[i];
            u.displacement_y[i] += problem.friction->layer->flexibility * u.traction_y[i];
        }
    return {u.displacement_x, u.displacement_y, u.displacement_z};
}

/// Returns the regions of the elements, the same as in the solve of the wheel.
RegionShares regions_on_rail(const ContactProblem& problem, bool is_left) {
    ContactRegions regions = *problem.regions;
    Grid grid = problem.grid;
    if (is_left) {
        mirror(regions);
        mirror(grid);
    }
    return region_shares(regions, grid);
}

}  // namespace

const ContactInfluence& ContactSolver::influence_of(const ContactProblem& problem) {
    const Grid& grid = problem.grid;
    const Key key{grid.nx, grid.ny, grid.dx, grid.dy, problem.bodies};
    constexpr std::array<double, 3> none{};
    const auto step = rolling_of_operators(problem);
    // An operator with a step also serves problems without one.
    if (key_ == key && (step == step_ || step == none)) return influence_;
    key_.reset();
    const Bodies& bodies = problem.bodies;
    if (bodies.pair) {
        influence_ = make_influence(problem, bodies.pair->table);
        key_ = key;
        step_ = step;
        return influence_;
    }
    BodyTable upper = table_of(grid, bodies.upper);
    BodyTable lower = bodies.lower == bodies.upper ? upper : table_of(grid, bodies.lower);
    influence_ = make_influence(problem, std::move(upper), std::move(lower));
    key_ = key;
    step_ = step;
    return influence_;
}

ContactSolution ContactSolver::solve(const ContactProblem& problem) {
    Observer observer;
    return solve_contact(problem, problem.model == Model::full ? influence_of(problem) : ContactInfluence{}, observer);
}

Displacements ContactSolver::displacements(const ContactProblem& problem, const ContactSolution& solution) {
    ContactSolution u = tractions_of(solution);
    std::shared_ptr<const InfluenceOperator> bodies = influence_of(problem).current;
    if (problem.regions)
        bodies = std::make_shared<const RegionOperator>(bodies, region_shares(*problem.regions, problem.grid));
    find_displacements(problem.grid, *bodies, u);
    return with_layer(problem, std::move(u));
}

Displacements ContactSolver::displacements_on_rail(const ContactProblem& problem, const ContactSolution& solution,
                                                   bool is_left) {
    if (bodies_on_rail_ != problem.bodies) {
        on_rail_ = std::make_unique<HalfSpaceCache>(problem.bodies);
        bodies_on_rail_ = problem.bodies;
    }
    ContactSolution u = tractions_of(solution);
    if (is_left) mirror(u, problem.grid);
    std::shared_ptr<const InfluenceOperator> bodies = on_rail_->of(problem).current;
    if (problem.regions) bodies = std::make_shared<const RegionOperator>(bodies, regions_on_rail(problem, is_left));
    find_displacements(problem.grid, *bodies, u);
    if (is_left) mirror(u, problem.grid);
    return with_layer(problem, std::move(u));
}

}  // namespace contactd::cases

#include "contact_solver.hpp"

#include "contactd/half_space.hpp"
#include "contactd/ic_record.hpp"
#include "contactd/observer.hpp"
#include "contactd/solve_contact.hpp"

namespace contactd::cntc {
namespace {

BodyTable table_of(const Grid& grid, const Body& body) {
    const Ics* ics = body.computed();
    if (ics == nullptr) return IcTable(grid.nx, grid.ny);
    const IcSpec spec{*ics, without_instant_creep({body, body}).upper.material, grid.dx, grid.dy, grid.nx, grid.ny};
    IcRecord record;  // as closed_form_record makes it, but for the evidence: nobody asks for that
    record.spec = dimensionless(spec);
    record.tables = half_space_table(record.spec);
    return body_table(record, spec);
}

Displacements displacements_by(const InfluenceOperator& influence, const ContactSolution& solution) {
    const std::size_t n = solution.pressure.size();
    Displacements u{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
    influence.normal(solution.pressure, u.z);
    influence.tangential(solution.traction_x, solution.traction_y, u.x, u.y);
    if (!influence.coupled()) return u;
    std::vector<double> x(n), y(n), z(n);
    influence.normal_of_tangential(solution.traction_x, solution.traction_y, z);
    influence.tangential_of_normal(solution.pressure, x, y);
    for (std::size_t i = 0; i < n; ++i) {
        u.x[i] += x[i];
        u.y[i] += y[i];
        u.z[i] += z[i];
    }
    return u;
}

/// Rows in the opposite order, with this sign.
std::vector<double> mirrored(const std::vector<double>& values, const Grid& grid, double sign) {
    std::vector<double> result;
    result.reserve(values.size());
    const auto nx = static_cast<std::ptrdiff_t>(grid.nx);
    for (auto row = static_cast<std::ptrdiff_t>(grid.ny); row-- > 0;)
        for (auto value = values.begin() + row * nx; value != values.begin() + (row + 1) * nx; ++value)
            result.push_back(sign < 0 ? 0 - *value : *value);
    return result;
}

}  // namespace

const ContactInfluence& ContactSolver::influence_of(const ContactProblem& problem) {
    const Grid& grid = problem.grid;
    const Key key{grid.nx, grid.ny, grid.dx, grid.dy, problem.bodies};
    constexpr std::array<double, 3> none{};
    const auto step = rolling_of_operators(problem);
    if (key_ == key && (step == step_ || step == none)) return influence_;  // with a step it serves without one, too
    key_.reset();
    const Bodies& bodies = problem.bodies;
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
    return displacements_by(*influence_of(problem).current, solution);
}

Displacements ContactSolver::displacements_on_rail(const ContactProblem& problem, const ContactSolution& solution,
                                                   bool is_left) {
    if (bodies_on_rail_ != problem.bodies) {
        on_rail_ = std::make_unique<HalfSpaceCache>(problem.bodies);
        bodies_on_rail_ = problem.bodies;
    }
    const ContactInfluence influence = on_rail_->of(problem);
    if (!is_left) return displacements_by(*influence.current, solution);
    const Grid& grid = problem.grid;
    ContactSolution right;
    right.pressure = mirrored(solution.pressure, grid, 1);
    right.traction_x = mirrored(solution.traction_x, grid, 1);
    right.traction_y = mirrored(solution.traction_y, grid, -1);
    const Displacements u = displacements_by(*influence.current, right);
    return {mirrored(u.x, grid, 1), mirrored(u.y, grid, -1), mirrored(u.z, grid, 1)};
}

}  // namespace contactd::cntc

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
    const InfluenceOperator& influence = *influence_of(problem).current;
    const std::size_t n = problem.grid.size();
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

}  // namespace contactd::cntc

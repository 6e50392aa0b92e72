#include "basic_history.hpp"

#include <utility>

#include "history/moved.hpp"

namespace contactd::cases {
namespace {

/// Returns the plastic slip at the start of a step, on its elements.
PlasticSlip slip_before(const Given& given, const ContactProblem& problem, const Solved& last) {
    constexpr int again = 3;
    PlasticSlip before = given.digits.previous == again ? last.plastic_before : last.plastic;
    for (auto* values : {&before.x, &before.y}) *values = on_grid(*values, last.problem.grid, problem.grid);
    return before;
}

}  // namespace

Solved solved_step(const Given& given, ContactProblem problem, ContactSolution solution, const Solved* last) {
    take_elements(problem, solution, problem.friction.has_value());
    PlasticSlip before;
    if (last != nullptr && !problem.previous.empty()) before = slip_before(given, problem, *last);
    PlasticSlip plastic = plastic_slip(problem, solution, before);
    Solved solved{std::move(problem), std::move(solution), std::move(before), std::move(plastic)};
    solved.spin_x = given.spin_x;
    solved.spin_y = given.spin_y;
    return solved;
}

ContactEvidence required_evidence(const Solved& solved) {
    ContactEvidence evidence = solved.solution.evidence;
    if (solved.problem.settings.outer.max_iterations == 1) evidence.outer.reset();
    return evidence;
}

}  // namespace contactd::cases

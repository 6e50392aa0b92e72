#include "contactd/contact_gradients.hpp"

#include <algorithm>

#include "contact/support/problem_of_regions.hpp"
#include "contact/support/sheets_between.hpp"
#include "find_gradients.hpp"

namespace contactd {
namespace {

// Strips have a transpose by their reflection along x, which does not give the coupling.
void check_strips(const ContactProblem& problem, const ContactInfluence& influence) {
    if (problem.friction && std::holds_alternative<Rolling>(problem.motion) && problem.bodies.any_uniform() &&
        influence.current->coupled())
        throw InvalidArgument("vjp",
                              "is not available for rolling of dissimilar longitudinally uniform bodies; use finite "
                              "differences of solves");
}

ContactSolution with_slip_in_mm(const ContactProblem& problem, const ContactSolution& solution) {
    ContactSolution result = solution;
    const auto* rolling = problem.friction ? std::get_if<Rolling>(&problem.motion) : nullptr;
    if (rolling == nullptr) return result;
    const double dq = step_length(*rolling, problem.grid);
    for (auto* slip : {&result.slip_x, &result.slip_y})
        for (double& s : *slip) s *= dq;
    return result;
}

}  // namespace

ContactGradients contact_gradients(const ContactProblem& problem, const ContactInfluence& influence,
                                   const ContactSolution& solution, const std::vector<Cotangents>& outputs,
                                   const std::vector<GradientInput>& by, Observer& observer) {
    validate(problem);
    validate_gradients(problem, outputs, by);
    check_strips(problem, influence);
    if (solution.pressure.size() != problem.grid.size())
        throw InvalidArgument("vjp", "requires the solution of the same problem");
    ContactGradients none;
    if (!solution.converged()) {
        none.warnings.emplace_back("The solution did not converge, so it has no gradients.");
        return none;
    }
    if (!std::ranges::any_of(solution.pressure, [](double p) { return p > 0; })) {
        none.warnings.emplace_back("There is no contact, so there are no gradients.");
        return none;
    }
    const ContactSolution in_mm = with_slip_in_mm(problem, solution);
    if (!problem.regions) return find_gradients(problem, with_sheets(problem, influence), in_mm, outputs, by, observer);
    const ProblemOfRegions plain(problem, influence);
    return find_gradients(plain.problem, with_sheets(plain.problem, plain.influence), in_mm, outputs, by, observer);
}

}  // namespace contactd

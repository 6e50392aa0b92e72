#include "contact_case.hpp"

#include "answers/sensitivities.hpp"
#include "edge/codes.hpp"
#include "edge/last_error.hpp"
#include "handles/stopwatch.hpp"
#include "problem/area.hpp"
#include "problem/case_models.hpp"
#include "problem/problem.hpp"
#include "run/basic_history.hpp"

namespace contactd::cntc {

void require_converged(const ContactEvidence& evidence) {
    const char* const found = " The best solution found is kept. Allow more iterations.";
    if (!evidence.normal.converged)
        throw Refused(error_code::normal, std::string("The normal problem did not converge.") + found);
    for (const auto& solver : {evidence.tangential, evidence.force})
        if (solver && !solver->converged)
            throw Refused(error_code::tangential, std::string("The tangential problem did not converge.") + found);
    if (evidence.outer && !evidence.outer->converged)
        throw Refused(
            error_code::tolerance,
            std::string("The outer iterations between pressures, tractions and friction stopped above the tolerance.") +
                found);
}

const Solved& solution_of(const ProblemCase& problem) {
    if (!problem.current)
        throw Refused(error_code::input, "There is no solution. Call cntc_calculate and check ierror.");
    return *problem.solved;
}

Grid grid_of(const ProblemCase& problem) {
    const Grid set = grid_of(problem.settings);
    return problem.current && set == problem.requested ? problem.solved->problem.grid : set;
}

void warn_of_memory(const Settings& settings) {
    if (settings.digits.tangential == 0) return;
    if (const std::string sentence = warning_of_memory(settings); !sentence.empty()) warn(sentence);
}

int calculate(ProblemCase& problem) {
    const Stopwatch stopwatch(problem.time);
    problem.current = false;
    problem.blocks.clear();
    std::optional<LastCase> last;
    if (problem.solved) last.emplace(LastCase{problem.solved->problem, problem.solved->solution});
    const Settings& settings = problem.settings;
    require_nothing_refused(settings);
    warn_of_memory(settings);
    ContactProblem next = problem_of(settings, last ? &*last : nullptr, [&](const ContactProblem& frictionless) {
        return problem.solver.solve(frictionless).forces.Fn;
    });
    if (settings.digits.result >= 2) return 0;
    ContactSolution solution = problem.solver.solve(next);
    problem.solved =
        solved_step(settings, std::move(next), std::move(solution), problem.solved ? &*problem.solved : nullptr);
    problem.requested = grid_of(settings);
    problem.current = true;
    Solved& solved = *problem.solved;
    require_converged(required_evidence(solved));
    if (const int digit = settings.digits.sensitivities; digit >= 2)
        solved.sensitivities = sensitivities(solved.problem, solved.solution, problem.solver, digit == 3);
    return solved.solution.elements.border;
}

}  // namespace contactd::cntc

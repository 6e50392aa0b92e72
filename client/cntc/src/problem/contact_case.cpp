#include "contact_case.hpp"

#include <chrono>
#include <ctime>

#include "edge/codes.hpp"
#include "problem/problem.hpp"
#include "problem/sensitivities.hpp"

namespace contactd::cntc {
namespace {

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Adds to a time what passes while it lives.
class Stopwatch {
   public:
    explicit Stopwatch(CalculationTime& time) : time_(time) {}
    ~Stopwatch() {
        time_.cpu += processor_seconds() - cpu_;
        time_.wall += std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

   private:
    CalculationTime& time_;
    double cpu_ = processor_seconds();
    std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
};

void require_converged(const ContactEvidence& evidence) {
    const char* const found = " The best that was found is kept; allow more iterations.";
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

}  // namespace

const Solved& solution_of(const ContactCase& problem) {
    if (!problem.current)
        throw Refused(error_code::input, "There is no solution to read from; call cntc_calculate, and look at ierror.");
    return *problem.solved;
}

int calculate(ContactCase& problem) {
    const Stopwatch stopwatch(problem.time);
    problem.current = false;
    problem.blocks.clear();
    std::optional<LastCase> last;
    if (problem.solved) last.emplace(LastCase{problem.solved->problem, problem.solved->solution});
    const Settings& settings = problem.settings;
    ContactProblem next = problem_of(settings, last ? &*last : nullptr, [&](const ContactProblem& frictionless) {
        return problem.solver.solve(frictionless).forces.Fn;
    });
    if (settings.digits(flag::result) >= 2) return 0;
    ContactSolution solution = problem.solver.solve(next);
    problem.solved = Solved{std::move(next), std::move(solution)};
    problem.current = true;
    Solved& solved = *problem.solved;
    require_converged(solved.solution.evidence);
    if (const int digit = settings.digits(flag::sensitivities); digit != 0)
        solved.sensitivities = sensitivities(solved.problem, solved.solution, problem.solver, digit == 3);
    return solved.solution.elements.border;
}

}  // namespace contactd::cntc

// One contact problem of a result element: what was set, and what came of the last solve.
#pragma once

#include <map>
#include <mutex>
#include <optional>

#include "answers/contact_solver.hpp"
#include "answers/solved.hpp"
#include "handles/settings.hpp"

namespace contactd::cntc {

/// Seconds that solves took.
struct CalculationTime {
    double cpu = 0, wall = 0;
};

struct ProblemCase {
    std::mutex mutex;  ///< held by whoever uses the rest
    Settings settings;
    ContactSolver solver;
    std::optional<Solved> solved;       ///< the last case, which the next one may continue from
    Grid requested;                     ///< of the last solve; a step may go on with others
    bool current = false;               ///< whether it is what was asked for last: a refused case cannot be read
    std::map<int, SolvedBlock> blocks;  ///< of the last solve
    CalculationTime time;
};

/// Throws Refused where the last case was not solved.
const Solved& solution_of(const ProblemCase& problem);

/// The elements: of the last solve as long as the same are set. Throws as cases::grid_of does.
Grid grid_of(const ProblemCase& problem);

/// Throws Refused where a solver missed its tolerance.
void require_converged(const ContactEvidence& evidence);

/// Warns of a memory of friction that a simplified theory does not have.
void warn_of_memory(const Settings& settings);

/// Solves what is set, and keeps it. Returns what cntc_calculate answers where it is not negative. Throws Refused,
/// where solvers missed their tolerances with what they found kept.
int calculate(ProblemCase& problem);

}  // namespace contactd::cntc

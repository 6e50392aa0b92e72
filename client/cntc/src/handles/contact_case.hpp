// One contact problem of a result element: its settings, and the results of the last solve.
#pragma once

#include <map>
#include <mutex>
#include <optional>

#include "answers/contact_solver.hpp"
#include "answers/solved.hpp"
#include "handles/settings.hpp"

namespace contactd::cntc {

/// Durations of the solves (s).
struct CalculationTime {
    double cpu = 0, wall = 0;
};

struct ProblemCase {
    std::mutex mutex;  ///< guards the other members
    Settings settings;
    ContactSolver solver;
    std::optional<Solved> solved;       ///< the last case, from which the next one may continue
    Grid requested;                     ///< grid of the last solve; a step may continue with another
    bool current = false;               ///< true if it belongs to the last request; a refused case has no results
    std::map<int, SolvedBlock> blocks;  ///< of the last solve
    CalculationTime time;
};

/// Returns the solution. Throws Refused if the last case was not solved.
const Solved& solution_of(const ProblemCase& problem);

/// Returns the grid: that of the last solve as long as its settings are unchanged. Throws as cases::grid_of does.
Grid grid_of(const ProblemCase& problem);

/// Throws Refused if a solver missed its tolerance.
void require_converged(const ContactEvidence& evidence);

/// Warns of friction with memory, which simplified theories ignore.
void warn_of_memory(const Settings& settings);

/// Solves the current settings and stores the solution. Returns the result of cntc_calculate unless it is negative.
/// Throws Refused; after a missed tolerance the solution is stored nevertheless.
int calculate(ProblemCase& problem);

}  // namespace contactd::cntc

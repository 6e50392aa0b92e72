// Solves the grids from which the tangential forces of a contact are extrapolated.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/observer.hpp"
#include "engine/ics/cache/influence_cache.hpp"

namespace contactd::engine {

/// Replaces the forces of a solved problem as extrapolate_forces does, if the problem requests an accuracy. Operators
/// of the grids are kept in `cache`. Throws the same, and Cancelled.
void extrapolate_on_grids(const ContactProblem& problem, ContactSolution& solution, InfluenceCache& cache,
                          Observer& observer);

}  // namespace contactd::engine

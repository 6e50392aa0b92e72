// Leads from a contact to the tables of its bodies, and from these to the operators that solve it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/solve_contact.hpp"
#include "engine/ics/cache/influence_cache.hpp"
#include "ic_pair.hpp"

namespace contactd::engine {

/// Returns false for simplified models, and if the request contains all coefficients.
bool needs_tables(const ContactSetup& setup);

/// Returns the required tables, except for rigid bodies and bodies with a given table.
std::array<std::optional<IcSpec>, 2> specs_of(const ContactSetup& setup);

/// Throws for a problem that cannot be solved.
void check(const ContactProblem& problem);
/// Checks an opening, in which gap and load may be missing because steps give them.
void check_opening(const ContactProblem& problem);

/// Returns the operators of the pair, from the cache if possible; none for a simplified model.
CachedInfluence influence_of(const ContactProblem& problem, const IcAnswers& ics, InfluenceCache& cache,
                             const Observer& observer);

/// Returns the origin of the coefficients.
IcUses uses_of(const ContactSetup& setup, const IcAnswers& ics);

/// Returns the warnings of the tables used for a solution, as sentences.
std::vector<std::string> table_warnings(const IcAnswers& ics);

/// Returns sentences about tables that miss the accuracy of the bodies; bodies of wheels on rails have no accuracy.
std::vector<std::string> accuracy_warnings(const Bodies& bodies, const IcAnswers& ics);

}  // namespace contactd::engine

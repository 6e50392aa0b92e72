// From a contact to the tables of its bodies, and from these to the operators that solve it.
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

/// False for simplified models, and where the request holds all coefficients.
bool needs_tables(const ContactSetup& setup);

/// The tables wanted; none of a rigid body, nor of one whose table is given.
std::array<std::optional<IcSpec>, 2> specs_of(const ContactSetup& setup);

/// Throws for a problem that cannot be solved as stated.
void check(const ContactProblem& problem);
/// Checks an opening, where steps will bring gap and load that are missing.
void check_opening(const ContactProblem& problem);

/// The operators of the pair, from the cache where they can be; none of a simplified model.
CachedInfluence influence_of(const ContactProblem& problem, const IcAnswers& ics, InfluenceCache& cache,
                             const Observer& observer);

/// Where the coefficients came from.
IcUses uses_of(const ContactSetup& setup, const IcAnswers& ics);

/// Returns warnings of the tables behind a solution: sentences, none when all is well.
std::vector<std::string> table_warnings(const IcAnswers& ics);

/// Sentences about tables that miss the accuracy that the bodies ask for; those of wheels on rails ask for none.
std::vector<std::string> accuracy_warnings(const Bodies& bodies, const IcAnswers& ics);

}  // namespace contactd::engine

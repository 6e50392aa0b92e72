// Sentences for what is wrong with a document that does not conform to its schema.
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/proto/status.hpp"

namespace contactd::proto {

/// More than these are of no use to anyone and would let a stranger fill the memory.
inline constexpr std::size_t max_violations = 20;

/// The violations of `schema` (references inlined) by `document`, one per field, the deepest ones only. Knows the
/// keywords that proto/schema uses.
std::vector<Violation> explain(const nlohmann::json& schema, const nlohmann::json& document);

}  // namespace contactd::proto

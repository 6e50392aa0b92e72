// Explains in sentences why a document does not conform to its schema.
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/proto/status.hpp"

namespace contactd::proto {

/// More violations would not help users, and would let an attacker fill the memory.
inline constexpr std::size_t max_violations = 20;

/// Returns the violations of `schema` (with references inlined) by `document`: one per field, and only the deepest
/// ones. It supports the keywords that proto/schema uses.
std::vector<Violation> explain(const nlohmann::json& schema, const nlohmann::json& document);

}  // namespace contactd::proto

// JSON Schemas (draft-07) of every message, kept in proto/schema and compiled in, and the OpenRPC document made of
// them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/proto/status.hpp"

namespace contactd::proto {

/// Every method of the wire, which is every file proto/schema/<method>.params.json, in the order of docs/protocol.md.
const std::vector<std::string>& method_names();

/// The schema kept as proto/schema/<name>.json, e.g. "ic.get.params", "envelope". Throws std::out_of_range.
const nlohmann::json& schema(std::string_view name);

/// What is wrong with `document`, by path, each description saying what the value is and what would be right; empty
/// when it conforms. Thread-safe.
std::vector<Violation> violations_of(std::string_view schema_name, const nlohmann::json& document);
/// The same for a schema of one's own, without references.
std::vector<Violation> violations_against(const nlohmann::json& schema, const nlohmann::json& document);

/// Throws StatusError: UNIMPLEMENTED/UNKNOWN_METHOD, or INVALID_ARGUMENT/FIELD_INVALID with all violations.
void check_params(const std::string& method, const nlohmann::json& params);

/// The OpenRPC 1.3 description of the service, which server.describe returns.
const nlohmann::json& openrpc();

}  // namespace contactd::proto

// References between the files of proto/schema: {"$ref": "definitions.json#/definitions/NAME"}.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace contactd::proto {

/// `schema` with every reference replaced by the definition; what stands beside the reference (description, default)
/// wins over the definition's own.
nlohmann::json inlined(const nlohmann::json& schema, const nlohmann::json& definitions);

/// `schema` with every reference pointing to `prefix` + NAME instead.
nlohmann::json redirected(const nlohmann::json& schema, const std::string& prefix);

}  // namespace contactd::proto

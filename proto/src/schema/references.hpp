// Resolves references between the files of proto/schema: {"$ref": "definitions.json#/definitions/NAME"}, a place within
// another file, or a whole file, {"$ref": "contact.solve.params.json"}.
#pragma once

#include <functional>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace contactd::proto {

/// Returns the files of proto/schema by their names without ".json".
using Documents = std::map<std::string, nlohmann::json, std::less<>>;

/// Returns the schema of a file without the keys that describe the file or the method: "$schema", "x-order" (the
/// method's place among all methods), "x-summary" (a sentence) and "x-errors" (status codes besides those of every
/// method).
nlohmann::json without_file_notes(nlohmann::json document);

/// Returns `schema` with every reference replaced by its target. Keys beside the reference (description, default)
/// override those of the target.
nlohmann::json inlined(const nlohmann::json& schema, const Documents& documents);

/// Returns `schema` with every reference pointing to `prefix` + NAME instead: the name of the definition or of the
/// file.
nlohmann::json redirected(const nlohmann::json& schema, const std::string& prefix);

}  // namespace contactd::proto

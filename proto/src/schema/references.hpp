// References between the files of proto/schema: {"$ref": "definitions.json#/definitions/NAME"}, a place within another
// file, or a whole one, {"$ref": "contact.solve.params.json"}.
#pragma once

#include <functional>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace contactd::proto {

/// The files of proto/schema by their names without ".json".
using Documents = std::map<std::string, nlohmann::json, std::less<>>;

/// The schema of a file without what belongs to the file only: "$schema", and of a method "x-order", its place among
/// all methods, "x-summary", a sentence, and "x-errors", the status codes it may answer besides those of every method.
nlohmann::json without_file_notes(nlohmann::json document);

/// `schema` with every reference replaced by what it refers to; what stands beside the reference (description, default)
/// wins over what is said there.
nlohmann::json inlined(const nlohmann::json& schema, const Documents& documents);

/// `schema` with every reference pointing to `prefix` + NAME instead: that of the definition, or of the file.
nlohmann::json redirected(const nlohmann::json& schema, const std::string& prefix);

}  // namespace contactd::proto

// Describes in words the requirements of a schema on a value.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace contactd::proto {

/// Returns true if `value` has (one of) the schema's types, or the schema names none.
bool has_type(const nlohmann::json& schema, const nlohmann::json& value);

/// Returns true if `value` is the schema's constant or one of its choices, or the schema names none.
bool is_choice(const nlohmann::json& schema, const nlohmann::json& value);

/// Returns the phrase after "it must" for a number outside the schema's bounds, and an empty text for one within.
std::optional<std::string> broken_bound(const nlohmann::json& schema, double value);

/// Returns true if `value` does not match the schema's pattern, or is longer than any text that a pattern describes.
bool breaks_pattern(const nlohmann::json& schema, const std::string& value);

/// Returns the phrase after "it must be": "an integer from 1 to 5", "one of \"hex\", \"prism\"", "an object with G,
/// nu".
std::string expected(const nlohmann::json& schema);

/// Returns the names of an object's members.
std::vector<std::string> names_of(const nlohmann::json& object);

}  // namespace contactd::proto

// Requirements of a schema on a value, in words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace contactd::proto {

/// True when `value` has (one of) the schema's types, or the schema names none.
bool has_type(const nlohmann::json& schema, const nlohmann::json& value);

/// True when `value` is the schema's constant or one of its choices, or the schema names none.
bool is_choice(const nlohmann::json& schema, const nlohmann::json& value);

/// The phrase after "it must", for a number outside of the schema's bounds; empty for one within.
std::optional<std::string> broken_bound(const nlohmann::json& schema, double value);

/// True when `value` does not match the schema's pattern, or is longer than anything that a pattern is for.
bool breaks_pattern(const nlohmann::json& schema, const std::string& value);

/// The phrase after "it must be": "an integer from 1 to 5", "one of \"hex\", \"prism\"", "an object with G, nu".
std::string expected(const nlohmann::json& schema);

/// The names of an object's members.
std::vector<std::string> names_of(const nlohmann::json& object);

}  // namespace contactd::proto

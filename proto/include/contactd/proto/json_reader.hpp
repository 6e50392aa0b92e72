// Reads untrusted JSON: limits depth and number of values, and names the field that cannot be read.
#pragma once

#include <cstddef>
#include <string_view>

#include <nlohmann/json.hpp>

namespace contactd::proto {

/// Largest depth of an envelope; far more than any message needs, far less than the stack allows.
inline constexpr std::size_t max_depth = 64;

/// Parses `text` into `root`. Throws StatusError: NOT_JSON (invalid syntax or UTF-8, NaN, numbers beyond double, a
/// repeated key in an object, too many levels) or LIMIT_EXCEEDED (more than `max_values` values); its message names the
/// field, or begins with `what`. `root` then contains the values read before. Integers beyond 64 bits become doubles.
void read_json(std::string_view text, std::size_t max_values, nlohmann::json& root,
               std::string_view what = "The envelope");

}  // namespace contactd::proto

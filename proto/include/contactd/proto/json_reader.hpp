// Reading the JSON of a stranger: bounded in depth and number of values, and able to say which field cannot be read.
#pragma once

#include <cstddef>
#include <string_view>

#include <nlohmann/json.hpp>

namespace contactd::proto {

/// Deepest nesting of an envelope; far more than any message needs, far less than any stack holds.
inline constexpr std::size_t max_depth = 64;

/// Parses `text` into `root`. Throws StatusError: NOT_JSON (bad syntax, bad UTF-8, NaN, numbers beyond double, a key
/// twice in one object, nested too deeply) or LIMIT_EXCEEDED (more than `max_values` values); its sentence names the
/// field, or begins with `what`. `root` then holds what was read before. Integers beyond 64 bits become doubles.
void read_json(std::string_view text, std::size_t max_values, nlohmann::json& root,
               std::string_view what = "The envelope");

}  // namespace contactd::proto

// How a value or a name of a request is quoted in an error message.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace contactd::proto {

/// Longest quotation of something the sender wrote, in bytes.
inline constexpr std::size_t max_shown = 60;

/// How many characters a text of UTF-8 has.
std::size_t characters(std::string_view text);

/// At most `limit` bytes, cut between characters and marked when cut; control characters become spaces.
std::string shortened(std::string_view text, std::size_t limit = max_shown);

/// A scalar as JSON, shortened; lists and objects by their kind and size.
std::string shown(const nlohmann::json& value);

/// The one of `names` that looks most like `name`, for a hint at what was misspelt; empty where none does.
std::string closest_name(std::string_view name, const std::vector<std::string>& names);

/// "a, b, c"
std::string listed(const std::vector<std::string>& names, std::string_view separator = ", ");

}  // namespace contactd::proto

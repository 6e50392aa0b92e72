// Quotes values and names of a request in error messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace contactd::proto {

/// Longest quotation of a text from the sender, in bytes.
inline constexpr std::size_t max_shown = 60;

/// Returns the number of characters of a UTF-8 text.
std::size_t characters(std::string_view text);

/// Returns at most `limit` bytes of the text, cut between characters and marked when cut. Control characters become
/// spaces.
std::string shortened(std::string_view text, std::size_t limit = max_shown);

/// Returns a scalar as shortened JSON; describes lists and objects by kind and size.
std::string shown(const nlohmann::json& value);

/// Returns the most similar one of `names`, to suggest a spelling; empty if none is similar.
std::string closest_name(std::string_view name, const std::vector<std::string>& names);

/// Returns "a, b, c".
std::string listed(const std::vector<std::string>& names, std::string_view separator = ", ");

}  // namespace contactd::proto

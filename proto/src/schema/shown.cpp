#include "shown.hpp"

#include <algorithm>
#include <cmath>

#include "contactd/proto/message.hpp"

namespace contactd::proto {
namespace {

std::string counted(std::size_t n, const char* what) {
    if (n == 0) return std::string("without ") + what + "s";
    return "with " + std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

bool continues_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u;
}

/// Returns the length of the longest common subsequence.
std::size_t common_letters(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1, 0);
    for (const char letter : a) {
        std::size_t diagonal = 0;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t above = row[j + 1];
            row[j + 1] = letter == b[j] ? diagonal + 1 : std::max(above, row[j]);
            diagonal = above;
        }
    }
    return row.back();
}

}  // namespace

std::size_t characters(std::string_view text) {
    const auto continuing = std::count_if(text.begin(), text.end(), continues_character);
    return text.size() - static_cast<std::size_t>(continuing);
}

std::string shortened(std::string_view text, std::size_t limit) {
    constexpr std::string_view ellipsis = "...";
    std::string result;
    if (text.size() <= limit) {
        result = text;
    } else {
        std::size_t end = limit - ellipsis.size();
        while (end > 0 && continues_character(text[end])) --end;
        result = std::string(text.substr(0, end)) + std::string(ellipsis);
    }
    for (char& c : result)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    return result;
}

std::string shown(const nlohmann::json& value) {
    if (value.is_array()) return "a list " + counted(value.size(), "value");
    if (value.is_object()) return "an object " + counted(value.size(), "field");
    if (value.is_string()) return '"' + shortened(value.get_ref<const std::string&>(), max_shown - 2) + '"';
    if (value.is_number_float() && !std::isfinite(value.get<double>())) return "not finite";
    return shortened(dump(value));
}

std::string closest_name(std::string_view name, const std::vector<std::string>& names) {
    constexpr std::size_t least_common = 3;
    constexpr double least_share = 0.6;
    std::string closest;
    if (name.size() > max_shown) return closest;
    double most = least_share;
    for (const std::string& other : names) {
        const std::size_t common = common_letters(name, other);
        const auto beginning = std::mismatch(name.begin(), name.end(), other.begin(), other.end()).first - name.begin();
        const double share = static_cast<double>(2 * common + static_cast<std::size_t>(beginning)) /
                             static_cast<double>(name.size() + other.size());
        if (common < least_common || share < most) continue;
        most = share;
        closest = other;
    }
    return closest;
}

std::string listed(const std::vector<std::string>& names, std::string_view separator) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? std::string() : std::string(separator)) + name;
    return text;
}

}  // namespace contactd::proto

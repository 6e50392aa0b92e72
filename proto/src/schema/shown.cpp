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

std::string listed(const std::vector<std::string>& names, std::string_view separator) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? std::string() : std::string(separator)) + name;
    return text;
}

}  // namespace contactd::proto

// Finds the unit in headings and comments above the points of a file.
#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "contactd/error.hpp"
#include "profile_lines.hpp"

namespace contactd::geometry {
namespace {

struct NamedUnit {
    std::string_view name;
    double mm;
};

constexpr std::array units{NamedUnit{"mm", 1},        NamedUnit{"millimeter", 1},    NamedUnit{"millimetre", 1},
                           NamedUnit{"m", 1e3},       NamedUnit{"meter", 1e3},       NamedUnit{"metre", 1e3},
                           NamedUnit{"cm", 10},       NamedUnit{"centimeter", 10},   NamedUnit{"centimetre", 10},
                           NamedUnit{"um", 1e-3},     NamedUnit{"micrometer", 1e-3}, NamedUnit{"micrometre", 1e-3},
                           NamedUnit{"micron", 1e-3}, NamedUnit{"in", 25.4},         NamedUnit{"inch", 25.4},
                           NamedUnit{"inche", 25.4},  NamedUnit{"ft", 304.8},        NamedUnit{"feet", 304.8}};

std::string in_small_letters(std::string_view text) {
    std::string small(text);
    std::ranges::transform(small, small.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return small;
}

/// Returns the unit that a word names, or nothing for other words.
std::optional<double> unit_named(std::string_view word) {
    if (word == "M") return {};  // is a letter with many other meanings
    std::string name = in_small_letters(word);
    for (const std::string_view micro : {"\xc2\xb5", "\xce\xbc"})
        if (name.starts_with(micro)) name.replace(0, micro.size(), "u");
    while (name.size() > 1 && name.back() == '.') name.pop_back();
    if (name.size() > 3 && name.back() == 's') name.pop_back();
    const auto found = std::ranges::find(units, name, &NamedUnit::name);
    return found == units.end() ? std::nullopt : std::optional(found->mm);
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, in_small_letters(word)) != words.end();
}

/// Calls `found` with each unit that a line states: in brackets, or after the words "unit" and "in".
template <class Use>
void for_each_unit(std::string_view line, const Use& use) {
    constexpr std::string_view between = " \t\r,;:=\"'()[]#%!";
    bool follows_unit = false;
    for (auto from = line.find_first_not_of(between); from != line.npos;) {
        const auto to = std::min(line.find_first_of(between, from), line.size());
        const std::string_view word = line.substr(from, to - from);
        const bool in_brackets = from > 0 && to < line.size() && (line[from - 1] == '[' || line[from - 1] == '(') &&
                                 (line[to] == ']' || line[to] == ')');
        const auto unit = unit_named(word);
        if (unit && (in_brackets || follows_unit)) {
            use(word, *unit);
            follows_unit = false;
        } else {
            follows_unit = is_one_of(word, {"unit", "units", "in"}) ||
                           (follows_unit && is_one_of(word, {"of", "length", "lengths", "is", "are"}));
        }
        from = line.find_first_not_of(between, to);
    }
}

}  // namespace

std::optional<double> unit_in_heading(std::string_view text, const std::string& name) {
    std::optional<double> found;
    std::string first;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, std::min<std::size_t>(end, 400));
        text.remove_prefix(std::min(end + 1, text.size()));
        const auto words = fields_of(line, ",;\"");
        if (!words.empty() && number_in(words.front())) break;
        for_each_unit(line, [&](std::string_view word, double unit) {
            if (found && *found != unit)
                throw InvalidArgument(name, "states two units above its points, " + quoted(first) + " and " +
                                                quoted(word) + "; give y and z in one unit");
            found = unit;
            first = word;
        });
    }
    return found;
}

}  // namespace contactd::geometry

// Maps enumerators to their keywords on the wire and in files, with one list for each enum.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "contactd/error.hpp"

namespace contactd {

/// Lists the keywords of an enum whose enumerators count from zero, in order. Specialise this for enums with keywords.
template <class Enum>
inline constexpr std::array<std::string_view, 0> enum_words{};

template <class Enum>
concept HasWords = !enum_words<Enum>.empty();

template <HasWords Enum>
std::string_view name_of(Enum value) {
    const auto at = static_cast<std::size_t>(value);
    if (at >= enum_words<Enum>.size()) throw Error("A value of an enum has no word.");
    return enum_words<Enum>[at];
}

/// Sets `value` to the enumerator with that keyword and returns true, or returns false if there is none.
template <HasWords Enum>
bool from_name(std::string_view name, Enum& value) {
    for (std::size_t at = 0; at < enum_words<Enum>.size(); ++at)
        if (enum_words<Enum>[at] == name) {
            value = static_cast<Enum>(at);
            return true;
        }
    return false;
}

}  // namespace contactd

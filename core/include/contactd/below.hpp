// Refusals of a part, in the names that its fields have in the whole.
#pragma once

#include <string>
#include <utility>

#include "contactd/error.hpp"

namespace contactd {

/// The result of `work`. An InvalidArgument that it throws is thrown again with `rename(field)` for its field.
template <class Rename, class Work>
auto renaming(const Rename& rename, const Work& work) {
    try {
        return work();
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(rename(error.field()), error.problem());
    }
}

/// For renaming(): with "material" and "bodies.upper", "material.nu" becomes "bodies.upper.nu". A field that does not
/// begin with `part` keeps its name.
inline auto in_place_of(std::string part, std::string name) {
    return [part = std::move(part), name = std::move(name)](const std::string& field) {
        return field.starts_with(part) ? name + field.substr(part.size()) : field;
    };
}

/// The result of `work`, which refuses fields below `field`: with "section", "profile.arc" becomes
/// "section.profile.arc".
template <class Work>
auto below(const std::string& field, const Work& work) {
    return renaming([&](const std::string& inner) { return field + "." + inner; }, work);
}

/// validate(part), which refuses fields below `field`.
template <class Part>
void validate_below(const std::string& field, const Part& part) {
    below(field, [&] { validate(part); });
}

}  // namespace contactd

// Renames the fields in the errors of a part, so that they name fields of the whole.
#pragma once

#include <string>
#include <utility>

#include "contactd/error.hpp"

namespace contactd {

/// Returns the result of `work`. An InvalidArgument is rethrown with `rename(field)` as its field.
template <class Rename, class Work>
auto renaming(const Rename& rename, const Work& work) {
    try {
        return work();
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(rename(error.field()), error.problem());
    }
}

/// Returns a function for renaming(): with "material" and "bodies.upper", "material.nu" becomes "bodies.upper.nu".
/// Fields that do not begin with `part` keep their names.
inline auto in_place_of(std::string part, std::string name) {
    return [part = std::move(part), name = std::move(name)](const std::string& field) {
        return field.starts_with(part) ? name + field.substr(part.size()) : field;
    };
}

/// Returns the result of `work`; errors name fields below `field`: with "section", "profile.arc" becomes
/// "section.profile.arc".
template <class Work>
auto below(const std::string& field, const Work& work) {
    return renaming([&](const std::string& inner) { return field + "." + inner; }, work);
}

/// Calls validate(part); errors name fields below `field`.
template <class Part>
void validate_below(const std::string& field, const Part& part) {
    below(field, [&] { validate(part); });
}

}  // namespace contactd

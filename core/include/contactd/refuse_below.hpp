// An error of a part, as one of the whole.
#pragma once

#include <string>

#include "contactd/error.hpp"

namespace contactd {

/// Throws the same error with its field below `field`: "profile.arc" becomes "section.profile.arc".
[[noreturn]] inline void refuse_below(const std::string& field, const InvalidArgument& error) {
    throw InvalidArgument(field + "." + error.field(), std::string(error.what()).substr(error.field().size() + 1));
}

/// validate(part), with the field that it names below `field`.
template <class Part>
void validate_below(const std::string& field, const Part& part) {
    try {
        validate(part);
    } catch (const InvalidArgument& error) {
        refuse_below(field, error);
    }
}

}  // namespace contactd

// Checks quotients as doubles before they become counts: a quotient that is too large, or NaN, is refused with the name
// of the field that causes it, before memory is allocated.
#pragma once

#include <string>
#include <string_view>

namespace contactd {

/// The words of the message that refuses a quotient: "FIELD PROBLEM makes COUNT THINGS; MOST are the most,
/// CURE".
struct Counted {
    std::string field;        ///< as on the wire
    std::string problem;      ///< its value, e.g. "is 1e-06 of an element"
    std::string_view things;  ///< e.g. "rows along the rail"
    std::string_view cure;    ///< e.g. "take a larger one"
    int most = 1'000'000;
};

/// Returns the quotient without its fraction. Throws InvalidArgument(counted.field) unless it is in [0, counted.most].
int count_of(double quotient, const Counted& counted);

}  // namespace contactd

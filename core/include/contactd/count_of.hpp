// Checks a quotient as a double before it becomes a count. A quotient that is too large, or NaN, is refused before
// memory is allocated, with the name of the field that causes it.
#pragma once

#include <string>
#include <string_view>

namespace contactd {

/// Holds the words of the message that refuses a quotient: "FIELD PROBLEM, which results in COUNT THINGS; at most MOST
/// are allowed: CURE".
struct Counted {
    std::string field;        ///< as on the wire
    std::string problem;      ///< its value, e.g. "is 1e-06 of an element"
    std::string_view things;  ///< e.g. "rows along the rail"
    std::string_view cure;    ///< e.g. "take a larger one"
    int most = 1'000'000;
};

/// Returns the quotient without its fraction. Throws InvalidArgument(counted.field) unless it lies in [0,
/// counted.most].
int count_of(double quotient, const Counted& counted);

}  // namespace contactd

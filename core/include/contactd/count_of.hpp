// Numbers that become counts are looked at as doubles first: a quotient that is too large, or no number, is refused by
// the name of the field that makes it so, before anything of its size is made.
#pragma once

#include <string>
#include <string_view>

namespace contactd {

/// Describes what a quotient counts, for the sentence that refuses it: "FIELD PROBLEM makes COUNT THINGS; MOST are the
/// most, CURE".
struct Counted {
    std::string field;        ///< as on the wire
    std::string problem;      ///< what its value is, e.g. "is 1e-06 of an element"
    std::string_view things;  ///< e.g. "rows along the rail"
    std::string_view cure;    ///< e.g. "take a larger one"
    int most = 1'000'000;
};

/// The quotient without its fraction. Throws InvalidArgument(counted.field) unless it lies in [0, counted.most].
int count_of(double quotient, const Counted& counted);

}  // namespace contactd

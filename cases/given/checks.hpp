// Checks the numbers of a case.
#pragma once

namespace contactd::cases {

/// Returns a count that is given as a floating-point number. Throws NotCovered if it is not a whole number.
int whole(double value, const char* name);
/// Returns the value. Throws NotCovered if it is not positive.
double positive(double value, const char* name);

}  // namespace contactd::cases

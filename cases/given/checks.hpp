// Checks of numbers that a case has.
#pragma once

namespace contactd::cases {

/// Both throw NotCovered. A count may come as a floating-point number.
int whole(double value, const char* name);
double positive(double value, const char* name);

}  // namespace contactd::cases

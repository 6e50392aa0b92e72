// The undeformed distance as a program sets it: a kind and its numbers.
#pragma once

#include "problem/settings.hpp"

namespace contactd::cntc {

/// Returns the undeformed distance of a kind, ibase, from numbers in the caller's units. Throws Refused where there is
/// no such distance.
Distance read_distance(int base, const double* prmudf, const int* nparam, const Units& units);

}  // namespace contactd::cntc

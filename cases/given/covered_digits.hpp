// The control digits: which of their values contactd has.
#pragma once

#include "given/given.hpp"

namespace contactd::cases {

/// Tells whether a digit means anything for basic contact, or for a wheel on a rail.
bool has_meaning(int Digits::* digit, bool on_rails);
/// Returns which values there are where this one is not covered, and null where it is.
const char* why_not_covered(int Digits::* digit, int value, bool on_rails);
/// Sets a digit. Throws NotCovered, and changes nothing then.
void set_digit(Digits& digits, int Digits::* digit, int value, bool on_rails);

}  // namespace contactd::cases

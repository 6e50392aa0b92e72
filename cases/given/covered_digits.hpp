// Lists supported values of the control digits.
#pragma once

#include "given/given.hpp"

namespace contactd::cases {

/// Returns whether a digit has an effect in basic contact, or for a wheel on a rail.
bool has_meaning(int Digits::* digit, bool on_rails);
/// Returns the supported values as a sentence without its full stop, such as "Use 0 or 1", if this value is not
/// supported. Returns null if it is.
const char* why_not_covered(int Digits::* digit, int value, bool on_rails);
/// Sets a digit. Throws NotCovered for an unsupported value, and changes nothing in that case.
void set_digit(Digits& digits, int Digits::* digit, int value, bool on_rails);

}  // namespace contactd::cases

// The flags of a contact problem: which there are, and which of their values contactd has.
#pragma once

#include <optional>

#include "handles/settings.hpp"

namespace contactd::cntc {

/// Returns a flag's value; nothing where the code means nothing for the module.
std::optional<int> digit_of(const Settings& settings, int code);
/// Throws Refused where contactd does not have the value, and changes nothing then. A code that means nothing here has
/// no effect: output, threads, and of basic contact the control of wheel on rail. 0 and 1 keep discretisation and
/// coefficients as they are.
void set_flag_digit(Settings& settings, int code, int value);
/// Throws Refused where nobody knows the code.
void require_known_flag(int code);

}  // namespace contactd::cntc

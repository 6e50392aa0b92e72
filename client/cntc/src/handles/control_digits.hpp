// Flags of a contact problem, and the values that contactd supports.
#pragma once

#include <optional>

#include "handles/settings.hpp"

namespace contactd::cntc {

/// Returns a flag's value, or nothing if the code does not apply to the module.
std::optional<int> digit_of(const Settings& settings, int code);
/// Sets a flag. Throws Refused without any change for a value that contactd does not support. A code that does not
/// apply has no effect: output, threads and, in basic contact, the control of wheel on rail. The values 0 and 1 keep
/// discretisation and coefficients.
void set_flag_digit(Settings& settings, int code, int value);
/// Throws Refused for an unknown code.
void require_known_flag(int code);

}  // namespace contactd::cntc

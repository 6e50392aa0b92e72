// The outcome of a thread's last call.
#pragma once

#include <string>

namespace contactd::cntc {

/// Forgets the error of this thread's last call: another one begins.
void begin_call() noexcept;

/// Keeps the exception that is being handled as the error of this thread's call, and prints its sentence where it was
/// not printed before. Returns its code.
int report(const char* function) noexcept;

/// Keeps the sentence as a warning of this thread's call, which goes on with code 0, and prints it where it was not
/// printed before.
void warn(const std::string& sentence) noexcept;

/// Turns the printing of errors and warnings on standard error on or off; it is on at first.
void print_errors(bool enabled) noexcept;

}  // namespace contactd::cntc

// Keeps the outcome of a thread's last call.
#pragma once

#include <string>

namespace contactd::cntc {

/// Clears the error of this thread's last call at the start of a new one.
void begin_call() noexcept;

/// Stores the exception being handled as the error of this thread's call, and prints its message unless it was printed
/// before. Returns its code.
int report(const char* function) noexcept;

/// Stores the sentence as a warning of this thread's call, which continues with code 0, and prints it unless it was
/// printed before.
void warn(const std::string& sentence) noexcept;

/// Turns the printing of errors and warnings on standard error on or off. It is initially on.
void print_errors(bool enabled) noexcept;

}  // namespace contactd::cntc

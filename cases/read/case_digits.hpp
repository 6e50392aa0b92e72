// Reads the control digits of a case.
#pragma once

#include <string_view>

#include "contactd/read_contact_file.hpp"
#include "input_lines.hpp"

namespace contactd::contact_files {

/// Reads the control words C1 P B T N F S, V L D C M Z E {M2}, and X H G I A O W R, and the following line of debug
/// digits if X = 1. Leading zeros are optional. The current line of `lines` is that of the first control word. Throws
/// InvalidArgument for invalid words and for undefined digits.
void read_digits(InputLines& lines, ContactCase& read);

/// Returns a digit by its name, or 0 if the case does not contain it.
int digit(const ContactCase& read, std::string_view name);

}  // namespace contactd::contact_files

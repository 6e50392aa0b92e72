// The control digits of a case.
#pragma once

#include <string_view>

#include "contactd/read_contact_file.hpp"
#include "input_lines.hpp"

namespace contactd::contact_files {

/// Reads the control words C1 P B T N F S, V L D C M Z E {M2}, and X H G I A O W R, with the line of debug digits
/// behind it where X = 1. Leading zeros may be left out. `lines` stands on the line of the first of them. Throws
/// InvalidArgument for what is none, and for digits that have no meaning.
void read_digits(InputLines& lines, ContactCase& read);

/// A digit by its name, 0 where the case has none.
int digit(const ContactCase& read, std::string_view name);

}  // namespace contactd::contact_files

// Detects values that no case can have.
#pragma once

#include <string>
#include <vector>

#include "contactd/read_contact_file.hpp"

namespace contactd::cases {

/// Returns sentences without full stops about a case that was read without errors: with such values, Hertz's formulas
/// do not end or have no number as their result, and lists of elements do not match the elements.
std::vector<std::string> mistakes(const ContactCase& read);

}  // namespace contactd::cases

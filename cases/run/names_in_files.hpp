// Refusals of core in the names of the file from which a problem was made.
#pragma once

#include <string>

#include "contactd/error.hpp"

namespace contactd::cases {

/// Returns the sentence of a refusal, with the name in CONTACT's files of the field, if it has one. `module` is that of
/// the case.
std::string in_names_of_files(const InvalidArgument& error, int module);

}  // namespace contactd::cases

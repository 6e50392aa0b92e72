// Converts a section to a list of numbers, for files and keys. Fields are in the order of section_fields.hpp. Flags and
// words are numbers, lists follow their length, and alternatives follow their index.
#pragma once

#include <vector>

#include "contactd/section.hpp"

namespace contactd {

std::vector<double> numbers_of(const Section& section);

/// Returns the section. Throws DamagedTable if the numbers are not those of a section.
Section section_from(const std::vector<double>& numbers);

}  // namespace contactd

// A section as a list of numbers, for files and keys: fields in the order of section_fields.hpp; flags and words by
// their number, lists behind how many there are, alternatives behind which one it is.
#pragma once

#include <vector>

#include "contactd/section.hpp"

namespace contactd {

std::vector<double> numbers_of(const Section& section);

/// Throws DamagedTable when they are none of a section.
Section section_from(const std::vector<double>& numbers);

}  // namespace contactd

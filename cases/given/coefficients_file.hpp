// Reads influence coefficients from a file in CONTACT's format (C = 9).
#pragma once

#include <string>
#include <string_view>

#include "contactd/given_ics.hpp"

namespace contactd::cases {

/// Returns the table of the pair of bodies (mm^3/N). The values in the file are multiplied by the combined modulus `G`
/// (N/mm^2). `name` is the name of the file, for messages. Throws NotCovered, with the line, for other kinds of files,
/// invalid numbers, and coefficients of bodies that are not symmetric in x and y.
GivenIcs read_coefficients(std::string_view text, const std::string& name, double G);

/// Returns the table for a grid, with zeros beyond the offsets of the file, as in CONTACT.
GivenIcs with_offsets(GivenIcs coefficients, const Grid& grid);

}  // namespace contactd::cases

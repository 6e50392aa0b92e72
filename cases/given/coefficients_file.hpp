// Influence coefficients from a file as CONTACT takes them (C = 9).
#pragma once

#include <string>
#include <string_view>

#include "contactd/given_ics.hpp"

namespace contactd::cases {

/// Returns the table of the pair of bodies (mm^3/N). `G` is their combined modulus (N/mm^2), by which the file's values
/// are multiplied. `name` is that of the file, for messages. Throws NotCovered, which names the line, for other kinds
/// of files, numbers that are none, and coefficients of bodies that are not symmetric in x and y.
GivenIcs read_coefficients(std::string_view text, const std::string& name, double G);

/// The table on a grid: CONTACT takes coefficients beyond those of the file for zero.
GivenIcs with_offsets(GivenIcs coefficients, const Grid& grid);

}  // namespace contactd::cases

// What is taken from the transform of a curved body's coefficients, and given back to its table: screened half-spaces,
// turned as those of rotated_half_space.hpp.
#pragma once

#include <vector>

#include "contactd/column_table.hpp"
#include "influence/rotated/column_grid.hpp"

namespace contactd {

/// At the offsets k dx + shift, k >= 0, of constant loads (screened_half_space.hpp); G = 1.
ColumnTable screened_table(const ColumnGrid& grid, double nu, double xi0, double shift = 0);

/// The transform along x at the wavenumber xi, with the convention of screened_transform: shape
/// [3, 3, columns, columns], i, j, I, J; G = 1. dx and nx have no meaning.
std::vector<double> screened_spectrum(const ColumnGrid& grid, double nu, double xi0, double xi);

}  // namespace contactd

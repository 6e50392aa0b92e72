// Coefficients of the bilinear load next to the load from those farther away, on a half-space. A hat function is the
// sum of nine hat functions of half its size, and of half the size the half-space is its own image: in offsets of
// elements
//     A(k, l) = 1/2 sum_ij c_i c_j A(2k - i, 2l - j),  i, j = -1, 0, 1,  c = (1/2, 1, 1/2).
// At the hat function's apex and folds finite elements converge slowly; a few elements away they do not know of them.
#pragma once

#include "contactd/ic_table.hpp"

namespace contactd::fem {

/// Offsets that near_load_from_far() needs along each axis.
inline constexpr int self_similar_extent = 10;

/// Returns the table with the offsets below 5 x 5 replaced by what the others imply. Throws InvalidArgument for a table
/// smaller than self_similar_extent.
IcTable near_load_from_far(const IcTable& table);

}  // namespace contactd::fem

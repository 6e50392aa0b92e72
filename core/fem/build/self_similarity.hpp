// Computes coefficients of the bilinear load next to the load from more distant ones, on a half-space. A hat function
// is the sum of nine hat functions of half its size, and the half-space scaled by one half is unchanged. In offsets of
// elements, A(k, l) = 1/2 sum_ij c_i c_j A(2k - i, 2l - j), i, j = -1, 0, 1, c = (1/2, 1, 1/2). Finite elements
// converge slowly at the apex and the folds of the hat function, but not a few elements away.
#pragma once

#include "contactd/ic_table.hpp"

namespace contactd::fem {

/// The number of offsets that near_load_from_far() needs along each axis.
inline constexpr int self_similar_extent = 10;

/// Returns the table with the offsets below 5 x 5 computed from the others. Throws InvalidArgument for a table smaller
/// than self_similar_extent.
IcTable near_load_from_far(const IcTable& table);

}  // namespace contactd::fem

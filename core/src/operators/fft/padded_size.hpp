// Sizes of periodic grids that convolutions on a grid fit into.
#pragma once

namespace contactd {

/// Along an axis of n elements: 2n where n has small prime factors only; for other n a smaller smooth number is several
/// times faster.
int padded_size(int n);
/// Returns the size for inverses of convolutions, which decay so fast that opposite edges hardly feel each other
/// without any padding: even, or 1.
int periodic_size(int n);

}  // namespace contactd

// Computes sizes of periodic grids for convolutions on a grid.
#pragma once

namespace contactd {

/// Returns the size along an axis of n elements: 2n if n has only small prime factors. For other n, a smooth number
/// below 2n is several times faster.
int padded_size(int n);
/// Returns the size for inverses of convolutions, which decay so fast that opposite edges hardly interact without
/// padding: even, or 1.
int periodic_size(int n);

}  // namespace contactd

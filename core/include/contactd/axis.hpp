// Defines the directions x, y and z (the outward normal), and the parities of influence coefficients.
#pragma once

namespace contactd {

enum class Axis { x = 0, y = 1, z = 2 };

/// Returns the parity of A[i,j](k,l) in its offsets: +1 (even) or -1 (odd) along x and along y. xx, yy and zz are even
/// in both, xy and yx odd in both; xz and zx are odd along x and even along y, yz and zy the reverse.
struct Parity {
    int along_x;
    int along_y;
};
Parity parity(Axis displacement, Axis load);

}  // namespace contactd

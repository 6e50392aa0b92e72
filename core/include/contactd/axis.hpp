// The directions x, y and z (the outward normal), and the parities of influence coefficients.
#pragma once

namespace contactd {

enum class Axis { x = 0, y = 1, z = 2 };

/// Mathematical parity of A[i,j](k,l) in the offsets (design: xx, yy, zz even/even; xy, yx odd/odd; xz, zx odd/even;
/// yz, zy even/odd): +1 or -1 along x and along y.
struct Parity {
    int along_x;
    int along_y;
};
Parity parity(Axis displacement, Axis load);

}  // namespace contactd

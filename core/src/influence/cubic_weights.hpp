// Interpolates between four neighbours.
#pragma once

#include <array>

namespace contactd {

/// Returns the weights of Lagrange's cubic through the nodes -1, 0, 1, 2.
inline std::array<double, 4> cubic_weights(double t) {
    return {-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2, -(t + 1) * t * (t - 2) / 2,
            (t + 1) * t * (t - 1) / 6};
}

}  // namespace contactd

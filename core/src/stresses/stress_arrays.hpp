// Arrays of stresses at points.
#pragma once

#include <array>
#include <vector>

#include "contactd/subsurface_stress.hpp"

namespace contactd {

/// xx, yy, zz, xy, xz, yz
inline std::array<std::vector<double>*, 6> components_of(SubsurfaceStress& stress) {
    return {&stress.xx, &stress.yy, &stress.zz, &stress.xy, &stress.xz, &stress.yz};
}
inline std::array<const std::vector<double>*, 6> components_of(const SubsurfaceStress& stress) {
    return {&stress.xx, &stress.yy, &stress.zz, &stress.xy, &stress.xz, &stress.yz};
}

/// From the components, with the largest.
void find_von_mises(SubsurfaceStress& stress);

}  // namespace contactd

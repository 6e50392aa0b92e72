// Accesses arrays of stresses at points.
#pragma once

#include <array>
#include <vector>

#include "contactd/subsurface_stress.hpp"

namespace contactd {

/// Returns xx, yy, zz, xy, xz, yz.
inline std::array<std::vector<double>*, 6> components_of(SubsurfaceStress& stress) {
    return {&stress.xx, &stress.yy, &stress.zz, &stress.xy, &stress.xz, &stress.yz};
}
inline std::array<const std::vector<double>*, 6> components_of(const SubsurfaceStress& stress) {
    return {&stress.xx, &stress.yy, &stress.zz, &stress.xy, &stress.xz, &stress.yz};
}

/// Computes the von Mises stresses from the components, and the point of the largest one.
void find_von_mises(SubsurfaceStress& stress);

}  // namespace contactd

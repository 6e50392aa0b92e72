// Computes displacements in the half-space z <= 0 under a constant traction on a rectangle, as sums over its corners.
#pragma once

#include <array>

#include "contactd/axis.hpp"
#include "patch_stress.hpp"

namespace contactd {

/// Holds the displacements along x, y and z.
using Displacement = std::array<double, 3>;

/// Returns the antiderivative, in x and in y, of the displacements times the shear modulus at (x, y) and depth d >= 0
/// below a unit force along `load` at the origin. Otherwise it is like corner_stress.
Displacement corner_displacement(Axis load, double x, double y, double d, double nu, double smallest);

/// Returns the parity along x and along y of a displacement below a point force.
Parity displacement_parity(Axis load, std::size_t component);

}  // namespace contactd

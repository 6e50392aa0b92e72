// Computes stresses in the half-space z <= 0 under a constant traction on a rectangle, as sums over its corners.
#pragma once

#include <array>

#include "contactd/ic_table.hpp"

namespace contactd {

/// Holds xx, yy, zz, xy, xz, yz.
using StressComponents = std::array<double, 6>;

/// Returns the antiderivative, in x and in y, of the stresses at (x, y) and depth d >= 0 below a unit force along
/// `load` at the origin. The difference between the corners of a rectangle, at (x, y) - corner, is the stress under a
/// unit traction. Distances below `smallest` count as `smallest` where the antiderivative is infinite. `y` may be
/// infinite for infinitely long rows: the rectangle is then a strip in plane strain.
StressComponents corner_stress(Axis load, double x, double y, double d, double nu, double smallest);

/// Returns the antiderivative, in x, of the stresses below a unit line force along `load`, in plane strain. The
/// difference between the edges of a strip is the stress under a unit traction.
StressComponents edge_stress(Axis load, double x, double d, double nu, double smallest);

/// Returns the parity along x and along y of a stress component below a point force.
Parity stress_parity(Axis load, std::size_t component);

}  // namespace contactd

// Converts values at wavenumbers to values at offsets along x.
#pragma once

#include <vector>

#include "contactd/observer.hpp"

namespace contactd {

/// Returns `count` wavenumbers from 0 to `last`, even in asinh(xi/xi0).
std::vector<double> wavenumber_nodes(double xi0, double last, int count);

/// Holds weights [node * nx + k]: the integral over xi of the spline through values at the nodes, times the transform
/// of an element of length dx and times cos (even) or sin (odd) of xi (k dx + shift), over pi. The spline is cubic in
/// asinh(xi/xi0) and respects the parity: even ones have zero slope at 0, odd ones no value and no curvature. Beyond
/// the last node its value decays as 1/xi^2, like the effect of a surface's curvature. Throws InvalidArgument ("grid")
/// for offsets so large that no quadrature resolves their waves, and Cancelled.
struct WavenumberRule {
    std::vector<double> even, odd;
};
WavenumberRule wavenumber_rule(const std::vector<double>& nodes, double xi0, double dx, int nx, double shift,
                               const Observer& observer = {});

}  // namespace contactd

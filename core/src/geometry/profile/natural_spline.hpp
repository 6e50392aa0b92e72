// Computes cubic splines with natural ends.
#pragma once

#include <span>
#include <vector>

namespace contactd::geometry {

/// Returns second derivatives at the knots of the C2 cubic spline through `values`, zero at both ends (Stoer and
/// Bulirsch, section 2.5). Knots ascend.
std::vector<double> natural_curving(std::span<const double> knots, std::span<const double> values);

}  // namespace contactd::geometry

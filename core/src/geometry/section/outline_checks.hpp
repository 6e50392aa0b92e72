// Checks whether curves enclose a body.
#pragma once

#include <string>
#include <vector>

#include "geometry/section/closed_curve.hpp"

namespace contactd::geometry {

/// Checks the outside, which is first, and the holes; `names` are their fields, for errors. Throws InvalidArgument,
/// with coordinates, for curves that turn back on themselves, cross themselves or each other, or have the body on their
/// left, and for holes outside the body or inside each other.
void check_outlines(const std::vector<ClosedCurve>& curves, const std::vector<std::string>& names);

}  // namespace contactd::geometry

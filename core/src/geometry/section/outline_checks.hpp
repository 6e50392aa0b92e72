// Whether curves enclose a body.
#pragma once

#include <string>
#include <vector>

#include "geometry/section/closed_curve.hpp"

namespace contactd::geometry {

/// The outside first, then the holes; `names` are their fields, for errors. Throws InvalidArgument, with coordinates,
/// for curves that turn back on themselves, cross themselves or each other, have the body on their left, and for holes
/// outside of the body or inside of each other.
void check_outlines(const std::vector<ClosedCurve>& curves, const std::vector<std::string>& names);

}  // namespace contactd::geometry

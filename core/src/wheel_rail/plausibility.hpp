// Warns of probable mistakes in wheels, rails and positions: implausible shapes and contact positions.
#pragma once

#include <string>
#include <vector>

#include "geometry/position.hpp"

namespace contactd {

/// Returns warnings about profiles with the width of points in inches, points whose rounding dominates their curvature,
/// and a flange_back_position that does not match the wheel's profile.
std::vector<std::string> plausibility_warnings(const WheelRailSetup& setup, const geometry::Profiles& profiles);

/// Returns warnings about a contact of a right wheel at the tip or the back of its flange, or beside the rail's head.
/// `side` is the side in the text.
std::vector<std::string> plausibility_warnings(const ContactReference& reference, Side side,
                                               const geometry::WheelSurface& wheel, const geometry::RailSurface& rail);

}  // namespace contactd

// Likely mistakes in wheels, rails and positions: shapes that they never have, and places where they never touch.
#pragma once

#include <string>
#include <vector>

#include "geometry/position.hpp"

namespace contactd {

/// Sentences about profiles that are as wide as if their points were in inches, points that are rounded so that their
/// curvature is noise, and a flange_back_position that is not that of the wheel's profile.
std::vector<std::string> plausibility_warnings(const WheelRailSetup& setup, const geometry::Profiles& profiles);

/// Sentences about a contact of a right wheel at the tip or the back of its flange, or beside the rail's head; `side`
/// is what it is called by.
std::vector<std::string> plausibility_warnings(const ContactReference& reference, Side side,
                                               const geometry::WheelSurface& wheel, const geometry::RailSurface& rail);

}  // namespace contactd

// Determines the side of a rail on which wheels run.
#pragma once

#include <optional>

#include "contactd/profile.hpp"

namespace contactd::geometry {

/// Returns the distance of the top of a rail from the middle of its head (mm), towards y > 0. Rails lean towards the
/// middle of the track, and wear on their gauge side: both move the top to the field side. Returns nothing for a head
/// that is visible to less than 2 mm below its top on either side, or that rises again, as beside grooves.
std::optional<double> top_beside_middle(const ProfileCurve& rail);

/// Returns whether the gauge side lies at y > 0, although it must lie at y < 0. It does if only the side at y > 0
/// extends down to the gauge height, or if both sides or neither do and the top is clearly on the side of y < 0.
bool has_gauge_side_at_right(const ProfileCurve& rail);

}  // namespace contactd::geometry

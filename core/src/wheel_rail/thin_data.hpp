// Warns about sparse data: profiles, slices and friction with too few points for a contact.
#pragma once

#include <string>
#include <vector>

#include "geometry/position.hpp"

namespace contactd {

/// Returns warnings about a candidate patch of a right wheel, named by its position on its own side. They cover fewer
/// than three points of a curved profile across it, slices between which the rail or the wheel's radius deviates from a
/// straight line by more than the overlap, and friction coefficients or laws of temperature-dependent friction at
/// distant angles.
std::vector<std::string> thin_data_warnings(const geometry::CandidatePatch& found, const WheelRailSetup& setup,
                                            const WheelRailState& state, const geometry::WheelSurface& wheel,
                                            const geometry::RailSurface& rail);

}  // namespace contactd

// Data that are too thin for a contact: profiles, slices and friction that were given at too few places.
#pragma once

#include <string>
#include <vector>

#include "geometry/position.hpp"

namespace contactd {

/// Sentences about a candidate patch of a right wheel, named by where it is on its own side: fewer than three points of
/// a profile across it, where it bends between them; slices between which the rail, or the wheel's radius, bends by
/// more than the surfaces overlap; coefficients of friction, and laws of it by temperature, between which it lies far
/// from either.
std::vector<std::string> thin_data_warnings(const geometry::CandidatePatch& found, const WheelRailSetup& setup,
                                            const WheelRailState& state, const geometry::WheelSurface& wheel,
                                            const geometry::RailSurface& rail);

}  // namespace contactd

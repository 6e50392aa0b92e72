// What a user of a wheel-rail solution should know.
#pragma once

#include <string>
#include <vector>

#include "geometry/position.hpp"

namespace contactd {

/// Of a place that is left out: overlap from above, and nothing to measure along the normal.
std::string apart_along_normal(const ContactReference& reference, Side side);

/// Of a place of a right wheel, called by where it is on its own side.
std::vector<std::string> warnings_of(const geometry::CandidatePatch& found, Side side, bool has_friction);
/// Of angles that look as if they were in degrees.
std::vector<std::string> warnings_of(const WheelRailState& state);
/// Those of its solution, under the same name.
std::vector<std::string> warnings_of(const ContactReference& reference, Side side, const ContactSolution& solution);

}  // namespace contactd

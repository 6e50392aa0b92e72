// Creates warnings for users of a wheel-rail solution.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/position.hpp"

namespace contactd {

/// Returns the name of a contact of a right wheel in warnings: its position on its own side.
std::string name_of(const ContactReference& reference, Side side);

/// Warns of a neglected candidate patch, which overlaps when seen from above but not along the normal.
std::string apart_along_normal(const ContactReference& reference, Side side);

/// Warns of a candidate patch of a right wheel, named by its position on its own side.
std::vector<std::string> warnings_of(const geometry::CandidatePatch& found, const WheelRailSetup& setup,
                                     const WheelRailState& state, bool has_friction);
/// Warns of a place that the search has skipped.
std::vector<std::string> warnings_of(const std::optional<geometry::PassedOver>& place, Side side);
/// Returns the warnings of the patch's solution, with the same name.
std::vector<std::string> warnings_of(const ContactReference& reference, Side side, const ContactSolution& solution);

}  // namespace contactd

// Where wheel and rail are in contact, as both methods answer it.
#pragma once

#include <nlohmann/json.hpp>

#include "contactd/wheel_rail_solution.hpp"

namespace contactd::proto {

/// Throws Error for numbers that are not finite, but for the radii of what is straight.
nlohmann::json encode_place(const ContactPlace& place);
/// Throws StatusError naming a field of the grid.
ContactPlace decode_place(const nlohmann::json& source);

}  // namespace contactd::proto

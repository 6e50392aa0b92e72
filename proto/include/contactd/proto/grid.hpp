// Encodes and decodes grids as JSON, which are part of many messages.
#pragma once

#include <nlohmann/json.hpp>

#include "contactd/grid.hpp"

namespace contactd::proto {

nlohmann::json encode_grid(const Grid& grid);
/// Returns the grid of an object that has passed its schema. Throws StatusError naming the field, before memory is
/// allocated.
Grid decode_grid(const nlohmann::json& json);

}  // namespace contactd::proto

// Provides the largest allowed requests of each expensive method, and their expected costs.
#pragma once

#include <nlohmann/json.hpp>

#include "config/config.hpp"

namespace contactd::server {

/// Returns a list of {method, arguments, bytes, seconds, params}: the sentence of docs/limits.md and the params to
/// send. For methods without a separate cost `bytes` is null.
nlohmann::json cost_examples(const Config& config);

}  // namespace contactd::server

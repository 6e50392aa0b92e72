// Requests as large as the limits allow, of each method whose work is not little, and what they are expected to take.
#pragma once

#include <nlohmann/json.hpp>

#include "config/config.hpp"

namespace contactd::server {

/// A list of {method, arguments, bytes, seconds, params}: the sentence of docs/limits.md and the params to send. Of
/// methods without a cost of their own `bytes` is null.
nlohmann::json cost_examples(const Config& config);

}  // namespace contactd::server

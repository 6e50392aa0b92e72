// Selects the part of the daemon's environment that a builder sees.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace contactd::engine {

using Environment = std::vector<std::pair<std::string, std::string>>;  ///< names and values

/// Returns the variables of this process that `names` list. A name that ends with * is a prefix. Nothing else is passed
/// on, because the daemon's environment may contain secrets, and variables that affect other programs (LD_PRELOAD,
/// ...).
Environment passed_on(const std::vector<std::string>& names);

}  // namespace contactd::engine

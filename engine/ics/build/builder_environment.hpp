// The part of the daemon's environment that a builder sees.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace contactd::engine {

using Environment = std::vector<std::pair<std::string, std::string>>;  ///< names and values

/// The variables of this process that `names` name. A name that ends with * stands for all that begin so. Nothing else
/// is handed on: the daemon's environment may hold secrets, and variables that change what programs do (LD_PRELOAD,
/// ...).
Environment passed_on(const std::vector<std::string>& names);

}  // namespace contactd::engine

// Whether what builds tables is there to be started.
#pragma once

#include <string>
#include <vector>

#include "config/config.hpp"

namespace contactd::server {

/// Why builds.program cannot be run, a sentence; empty when it can.
std::string builder_problem(const Config& config);
/// Why what builds.launcher begins with cannot be run; empty when it can, and when there is none.
std::string launcher_problem(const Config& config);

/// Problems with the builder and its launcher, a sentence each; empty: none.
std::vector<std::string> building_problems(const Config& config);

}  // namespace contactd::server

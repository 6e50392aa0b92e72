// Checks whether the builder and its launcher can be started.
#pragma once

#include <string>
#include <vector>

#include "config/config.hpp"

namespace contactd::server {

/// Returns the reason why builds.program cannot be run, as a sentence; empty if it can.
std::string builder_problem(const Config& config);
/// Returns the reason why the program of builds.launcher cannot be run; empty if it can, or if there is no launcher.
std::string launcher_problem(const Config& config);

/// Returns the problems with the builder and its launcher, one sentence each.
std::vector<std::string> building_problems(const Config& config);

}  // namespace contactd::server

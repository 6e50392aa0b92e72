// What a wheel is told before its first position.
#pragma once

#include <filesystem>

#include "handles.hpp"

namespace contactd::fmu {

/// All parameters. Throws Failure, also for a file that cannot be read, naming the variable.
void set_up(contactd_wheel* wheel, const Values& values, const std::filesystem::path& resources);

}  // namespace contactd::fmu

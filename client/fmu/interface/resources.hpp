// Where the resources of an FMU lie.
#pragma once

#include <filesystem>
#include <string_view>

namespace contactd::fmu {

/// Of FMI 2's file:///..., with its %20, or of a path, which stays as it is.
std::filesystem::path folder_of(std::string_view uri);

}  // namespace contactd::fmu

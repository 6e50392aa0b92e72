// Profiles that vary: of an out-of-round wheel, and of a rail along the track.
#pragma once

#include <filesystem>
#include <string>

#include "handles.hpp"

namespace contactd::fmu {

/// Where contactd.h has a list of slices, and what stands in the first column of its file.
struct Slices {
    std::string path, column;
};

/// Sets the slices of the file `name`. Throws Failure naming `variable` for what is no such file, and for a line that
/// has no number and file.
void set_slices(contactd_wheel* wheel, const Slices& slices, const std::string& variable, const std::string& name,
                double smoothing_length, const std::filesystem::path& resources);

}  // namespace contactd::fmu

// Profiles in files, also those that vary: of an out-of-round wheel, and of a rail along the track.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "handles.hpp"

namespace contactd::fmu {

/// Where contactd.h has a list of slices, and what stands in the first column of its file.
struct Slices {
    std::string path, column;
};

/// How a file of a profile is read, beside what it says itself; a unit of 0 leaves that to the file.
struct FileReading {
    double unit = 0;
    bool mirror_y = false;
    std::string_view mirror_z{};  ///< one of `orientations`
    double shift_y = 0, shift_z = 0, smoothing_length = 0;
};

/// Makes the profile at this path that of a file. Throws Failure for one that cannot be read.
void set_profile_file(contactd_wheel* wheel, const std::string& profile, const std::filesystem::path& path,
                      const FileReading& reading);

/// Sets the slices of the file `name`. Throws Failure naming `variable` for what is no such file, and for a line that
/// has no number and file.
void set_slices(contactd_wheel* wheel, const Slices& slices, const std::string& variable, const std::string& name,
                const FileReading& reading, const std::filesystem::path& resources);

}  // namespace contactd::fmu

// Reads profiles from files, including those of an out-of-round wheel, and of a rail that varies along the track.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "handles.hpp"

namespace contactd::fmu {

/// Holds the path of a list of slices in contactd.h, and the first column of its file.
struct Slices {
    std::string path, column;
};

/// Holds options for reading a profile file, in addition to those in the file; a unit of 0 is that of the file.
struct FileReading {
    double unit = 0;
    bool mirror_y = false;
    std::string_view mirror_z{};  ///< one of `orientations`
    double shift_y = 0, shift_z = 0, smoothing_length = 0;
};

/// Sets the profile at this path from a file. Throws Failure if it cannot be read.
void set_profile_file(contactd_wheel* wheel, const std::string& profile, const std::filesystem::path& path,
                      const FileReading& reading);

/// Sets the slices of the file `name`. Throws Failure naming `variable` for an invalid file, and for a line without
/// number and file.
void set_slices(contactd_wheel* wheel, const Slices& slices, const std::string& variable, const std::string& name,
                const FileReading& reading, const std::filesystem::path& resources);

}  // namespace contactd::fmu

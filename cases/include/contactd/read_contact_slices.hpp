// Reads lists of slices of the CONTACT program: .slcs for rails and .slcw for wheels.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace contactd {

inline constexpr int most_contact_slices = 4999;

struct ContactSlice {
    double u = 0;      ///< position along the track (mm) or around the wheel (rad): U_SCALE (U_OFFSET + U_SLC)
    std::string file;  ///< its profile, as written: relative to the folder of the list
    /// Arc lengths (mm) of the features from the profile's first point; below 0 if a feature does not exist here. Empty
    /// if the profiles have one part.
    std::vector<double> features;
};

/// Features divide a profile into parts, numbered from 1; kinks and accelerations along u apply to parts.
struct ContactSlices {
    double u_offset = 0, u_scale = 1;  ///< as written
    bool is_approximated = false;      ///< U_INTPOL = 2; otherwise the surface passes through the slices
    std::vector<ContactSlice> slices;  ///< u rises
    std::vector<int> kinks, accelerations;
};

/// Reads the text of a list; the profiles that it names are not opened. `name` is that of the file, for
/// messages. Throws InvalidArgument that names file, line and column, for an invalid word, and for
/// inconsistent values: positions that do not increase, features that are not in order, or numbers of
/// nonexistent parts.
ContactSlices read_contact_slices(std::string_view text, const std::string& name);

}  // namespace contactd

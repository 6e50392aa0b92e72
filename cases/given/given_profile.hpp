// Reads a profile from a file, or from a table of values.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "given/given_rail.hpp"
#include "given/named_files.hpp"
#include "given/units.hpp"

namespace contactd::cases {

/// Holds options for reading the points of a profile.
struct ProfileOptions {
    std::optional<bool> wheel{};  ///< if absent, the ending of the file name decides
    int mirror_y = 0;             ///< 1: mirrored; -1: not mirrored, even if the file requests it
    int mirror_z = 0;             ///< 1: mirrored, -1: not mirrored, 0: depends on the shape
    int smoother = 0;             ///< `smoothing` is a weight (0) or a length (1, or 2 for the third derivative)
    double scale = 1;             ///< length of a unit (mm)
    double smoothing = 0;
    KinkRule kinks{};
};

/// Holds the options of a file or a table in CONTACT's numbers. Zero or negative numbers select defaults.
struct ProfileNumbers {
    int mirror_y = 0, mirror_z = 0, smoother = 0;
    double scale = 0, smoothing = 0, kink_high = 0, kink_low = 0;
    double kink_width = -1;  ///< not given if negative
};

/// Returns the options. Throws NotCovered for an unsupported smoother.
ProfileOptions profile_options(const ProfileNumbers& numbers, const Units& units);

struct ReadProfile {
    bool wheel = false;
    GivenSurface surface;
};

/// Reads a profile or a list of slices. Throws NotCovered with the subject `profile` or
/// `file`.
ReadProfile profile_from_file(const std::string& name, const ProfileOptions& options, const NamedFiles& files);
/// Reads a profile from alternating values of y and z. Throws NotCovered with the subject `profile`.
ReadProfile profile_from_values(std::span<const double> values, const ProfileOptions& options);

}  // namespace contactd::cases

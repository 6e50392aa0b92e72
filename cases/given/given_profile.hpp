// A profile from a file, or from a table of values.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "given/given_rail.hpp"
#include "given/units.hpp"

namespace contactd::cases {

/// How its points are to be read.
struct ProfileOptions {
    std::optional<bool> wheel{};  ///< absent: the file's ending says it
    int mirror_y = 0;             ///< 1: turned to the other side; -1: not, whatever a file says
    int mirror_z = 0;             ///< 1: turned, -1: not, 0: as their shape asks for
    int smoother = 0;             ///< whose weight (0) or length `smoothing` is; 2: of the third derivative
    double scale = 1;             ///< mm that a unit has
    double smoothing = 0;
    KinkRule kinks{};
};

/// The options of a file or a table as CONTACT takes them; a number that is not positive stands for the usual one.
struct ProfileNumbers {
    int mirror_y = 0, mirror_z = 0, smoother = 0;
    double scale = 0, smoothing = 0, kink_high = 0, kink_low = 0;
    double kink_width = -1;  ///< below 0: none is given
};

/// Throws NotCovered for a smoother that contactd does not have.
ProfileOptions profile_options(const ProfileNumbers& numbers, const Units& units);

struct ReadProfile {
    bool wheel = false;
    GivenSurface surface;
};

/// Throws NotCovered with the code of profiles.
ReadProfile profile_from_file(const std::string& name, const ProfileOptions& options);
/// `values` are y and z in turns.
ReadProfile profile_from_values(std::span<const double> values, const ProfileOptions& options);

}  // namespace contactd::cases

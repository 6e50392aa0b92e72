// Defines the evidence of a profile as plain values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "contactd/enum_words.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

enum class ProfileFormat { simpack, miniprof, columns };

/// Selects the source of the direction of z of a file's points: the file, their shape, or the user.
enum class OrientedBy { file, shape, request };

/// Holds the detected properties of a file.
struct ProfileReading {
    ProfileFormat format = ProfileFormat::columns;
    double unit = 1;                          ///< unit of its points in mm
    bool mirror_y = false, mirror_z = false;  ///< whether y and z of its points were mirrored in total
    OrientedBy oriented_by = OrientedBy::file;
    std::size_t lines_left_out = 0;  ///< neither points nor known keys; comments are not counted

    bool operator==(const ProfileReading&) const = default;
};

/// Holds characteristic points of a wheel.
struct WheelLandmarks {
    ProfilePoint tip;     ///< lowest point of the flange
    ProfilePoint throat;  ///< the point of largest concave curvature between the flange and the tread
    ProfilePoint tread;   ///< at the running circle, 55 mm beside the tip

    bool operator==(const WheelLandmarks&) const = default;
};

/// Describes how the points were processed.
struct ProfileEvidence {
    std::size_t points_given = 0, points_kept = 0;
    double spacing = 0;           ///< mean distance of the used points (mm)
    double rounded_to = 0;        ///< rounding step of all given coordinates (mm); 0: none of 1, 0.1, .. 0.001
    double cut_off = 0;           ///< wavelength whose amplitude smoothing halves (mm); 0: none
    double largest_distance = 0;  ///< distance of the used points from the curve (mm): 0 without smoothing
    double rms_distance = 0;
    std::vector<double> kinks{};            ///< y (mm)
    std::optional<WheelLandmarks> wheel{};  ///< for wheels whose flange is at least 10 mm high
    std::optional<ProfileReading> file{};
    std::vector<std::string> warnings{};

    bool operator==(const ProfileEvidence&) const = default;
};

}  // namespace contactd

// What became of a profile, as plain values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "contactd/enum_words.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

enum class ProfileFormat { simpack, miniprof, columns };

/// What says which way z of a file's points runs: the file, their shape, or who gave it.
enum class OrientedBy { file, shape, request };

/// What a file was taken for.
struct ProfileReading {
    ProfileFormat format = ProfileFormat::columns;
    double unit = 1;                          ///< mm of a unit of its points
    bool mirror_y = false, mirror_z = false;  ///< whether y and z of its points were turned, all told
    OrientedBy oriented_by = OrientedBy::file;
    std::size_t lines_left_out = 0;  ///< neither points nor keys that mean something; comments are not counted

    bool operator==(const ProfileReading&) const = default;
};

/// Places by which a wheel is known.
struct WheelLandmarks {
    ProfilePoint tip;     ///< of the flange, the lowest point
    ProfilePoint throat;  ///< the hollowest point between the flange and the tread
    ProfilePoint tread;   ///< at the running circle, 55 mm beside the tip

    bool operator==(const WheelLandmarks&) const = default;
};

/// Evidence of what became of the points.
struct ProfileEvidence {
    std::size_t points_given = 0, points_kept = 0;
    double spacing = 0;     ///< mean distance of the points kept (mm)
    double rounded_to = 0;  ///< step that all given coordinates are multiples of (mm); 0: none of 1, 0.1, .. 0.001
    double cut_off = 0;     ///< wavelength of which smoothing leaves half the amplitude (mm); 0: none
    double largest_distance = 0;  ///< of the points kept from the curve (mm): 0 without smoothing
    double rms_distance = 0;
    std::vector<double> kinks{};            ///< y (mm)
    std::optional<WheelLandmarks> wheel{};  ///< of wheels whose flange stands out by 10 mm at least
    std::optional<ProfileReading> file{};
    std::vector<std::string> warnings{};

    bool operator==(const ProfileEvidence&) const = default;
};

}  // namespace contactd

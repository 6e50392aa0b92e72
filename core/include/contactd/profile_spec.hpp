// Defines a profile as a plain value: a named formula with parameters, or points.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "contactd/enum_words.hpp"

namespace contactd {

/// Holds a point of a profile, or a vector in its plane (mm): y to the field side, z downwards.
struct ProfilePoint {
    double y = 0, z = 0;

    bool operator==(const ProfilePoint&) const = default;
};

enum class ProfileKind { wheel, rail };
template <>
inline constexpr std::array enum_words<ProfileKind>{std::string_view("wheel"), std::string_view("rail")};

/// Selects the wheel S1002 of EN 13715: z = 0 at its tape circle, y = 0; the flange is at y < 0.
struct S1002 {
    bool operator==(const S1002&) const = default;
};

/// Selects the head of the rail 60E1 (UIC60), inclined towards its gauge side at y < 0; its top is at z = 0.
struct Rail60E1 {
    double inclination = 0;  ///< a slope, e.g. 1/40

    bool operator==(const Rail60E1&) const = default;
};

/// Describes a circular arc through the origin.
struct ArcProfile {
    double radius = 0;  ///< mm; positive: falls to both sides, like a rail's head or a hollow wheel; negative: rises
    double slope = 0;   ///< dz/dy at y = 0
    double from = -40, to = 40;  ///< y of its ends (mm)

    bool operator==(const ArcProfile&) const = default;
};

/// Describes a straight line through the origin; a conical wheel has the slope -conicity.
struct ConeProfile {
    double slope = 0;            ///< dz/dy
    double from = -40, to = 40;  ///< y of its ends (mm)

    bool operator==(const ConeProfile&) const = default;
};

/// Lists the profiles with names. Sections in files contain indices of this list.
enum class StandardName { S1002, UIC60, n49E5, n54E1, n54E3, n60E1, n60E2 };

/// Selects a wheel or the head of a rail by its name. S1002 has the points of the shape S1002, and UIC60 those of
/// Rail60E1. The other names are rails of EN 13674-1:2017.
struct StandardProfile {
    StandardName name = StandardName::n60E1;
    double inclination = 0;  ///< of a rail, as in Rail60E1

    bool operator==(const StandardProfile&) const = default;
};

/// Holds points in the order of the curve, from either end.
struct ProfilePoints {
    std::vector<ProfilePoint> points;
    double unit = 1;  ///< unit of the points in mm: 1000 for metres
    bool mirror_y = false, mirror_z = false;
    double smoothing_length = 0;  ///< wavelength whose amplitude smoothing halves (mm); 0: none

    bool operator==(const ProfilePoints&) const = default;
};

/// A point with a change of direction above `angle` is a kink, at which the curve is broken, if all points within
/// `width` along the curve on both sides have changes below `rest`.
struct KinkRule {
    double angle = 0.5235987755982988, rest = 0.10471975511965978;  ///< rad: 30 and 6 degrees
    double width = 2;                                               ///< mm

    bool operator==(const KinkRule&) const = default;
};

/// Holds the content of a file in a format of read_profile.hpp. The options here apply in addition to those in the
/// file.
struct ProfileFile {
    std::string name;  ///< its extension is the format of the text; a folder before it is ignored
    std::string text;
    std::optional<double> unit{};     ///< unit of its points in mm, instead of that in the file
    bool mirror_y = false;            ///< y is mirrored, after the options of the file
    std::optional<bool> mirror_z{};   ///< z is mirrored, or not, after the options of the file; absent: according to
                                      ///< the shape
    double shift_y = 0, shift_z = 0;  ///< added to the points last (mm)
    double smoothing_length = 0;      ///< as in ProfilePoints
    int smoothing_order = 2;          ///< order of the derivative that smoothing minimises: 2 or 3
    double smoothing_lambda = 0;      ///< weight of the curvature over that of a point, instead of a length (mm^3)
    KinkRule kinks{};

    bool operator==(const ProfileFile&) const = default;
};

/// Sections in files contain the index of a shape in this list.
using ProfileShape =
    std::variant<S1002, Rail60E1, ArcProfile, ConeProfile, ProfilePoints, ProfileFile, StandardProfile>;

struct ProfileSpec {
    ProfileKind kind = ProfileKind::wheel;
    ProfileShape shape{};

    bool operator==(const ProfileSpec&) const = default;
};

/// A profile has at most this number of points.
inline constexpr std::size_t most_profile_points = 20000;
/// All slices of a rail, or of a wheel, together have at most this number of points.
inline constexpr std::size_t most_points_of_slices = 10 * most_profile_points;
/// The text of a ProfileFile has at most this size in bytes.
inline constexpr std::size_t most_profile_text = 2 << 20;

/// Throws InvalidArgument, which names the field below "profile", if a parameter is invalid. make_profile checks the
/// shape of the points.
void validate(const ProfileSpec& spec);

}  // namespace contactd

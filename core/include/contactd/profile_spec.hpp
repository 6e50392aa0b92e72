// A profile as a plain value: by the name of its formula with parameters, or by points.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "contactd/enum_words.hpp"

namespace contactd {

/// A point of a profile, or a vector in its plane (mm): y to the field side, z downwards.
struct ProfilePoint {
    double y = 0, z = 0;

    bool operator==(const ProfilePoint&) const = default;
};

enum class ProfileKind { wheel, rail };
template <>
inline constexpr std::array enum_words<ProfileKind>{std::string_view("wheel"), std::string_view("rail")};

/// The wheel S1002 of EN 13715: z = 0 at its tape circle, y = 0; the flange lies at y < 0.
struct S1002 {
    bool operator==(const S1002&) const = default;
};

/// The head of the rail 60E1 (UIC60), inclined towards y < 0, where its gauge side is; its top lies at z = 0.
struct Rail60E1 {
    double inclination = 0;  ///< a slope, e.g. 1/40

    bool operator==(const Rail60E1&) const = default;
};

/// A circular arc through the origin.
struct ArcProfile {
    double radius = 0;  ///< mm; positive: falls off to both sides, as a rail's head or a hollow wheel; negative: rises
    double slope = 0;   ///< dz/dy at y = 0
    double from = -40, to = 40;  ///< y of its ends (mm)

    bool operator==(const ArcProfile&) const = default;
};

/// A straight line through the origin: a conical wheel has the slope -conicity.
struct ConeProfile {
    double slope = 0;            ///< dz/dy
    double from = -40, to = 40;  ///< y of its ends (mm)

    bool operator==(const ConeProfile&) const = default;
};

/// Points in the order of the curve, from either end.
struct ProfilePoints {
    std::vector<ProfilePoint> points;
    double unit = 1;  ///< mm that a unit of the points has: 1000 for metres
    bool mirror_y = false, mirror_z = false;
    double smoothing_length = 0;  ///< wavelength of which half the amplitude is smoothed away (mm); 0: none

    bool operator==(const ProfilePoints&) const = default;
};

/// A point where the points turn by more than `angle` is a kink, at which the curve is broken, where none of those
/// within `width` along the curve, to both sides, turns by more than `rest`.
struct KinkRule {
    double angle = 0.5235987755982988, rest = 0.10471975511965978;  ///< rad: 30 and 6 degrees
    double width = 2;                                               ///< mm

    bool operator==(const KinkRule&) const = default;
};

/// The content of a file as read_profile.hpp knows them. What else is said here holds beside what the file says itself.
struct ProfileFile {
    std::string name;  ///< its ending says what the text is; a folder before it means nothing
    std::string text;
    std::optional<double> unit{};    ///< mm that a unit of its points has, whatever the file says; absent: what it says
    bool mirror_y = false;           ///< y is turned to the other side, after what the file says
    std::optional<bool> mirror_z{};  ///< z is turned, or not, after what the file says; absent: as the shape asks for
    double shift_y = 0, shift_z = 0;  ///< added to the points at last (mm)
    double smoothing_length = 0;      ///< as of ProfilePoints
    int smoothing_order = 2;          ///< of the derivative that smoothing makes small: 2 or 3
    double smoothing_lambda = 0;      ///< weight of the curvature while all points weigh 1, in place of a length (mm^3)
    KinkRule kinks{};

    bool operator==(const ProfileFile&) const = default;
};

/// Sections in files have a shape's place in this list.
using ProfileShape = std::variant<S1002, Rail60E1, ArcProfile, ConeProfile, ProfilePoints, ProfileFile>;

struct ProfileSpec {
    ProfileKind kind = ProfileKind::wheel;
    ProfileShape shape{};

    bool operator==(const ProfileSpec&) const = default;
};

/// Points that a profile may have.
inline constexpr std::size_t most_profile_points = 20000;
/// Points that all slices of a rail, or of a wheel, may have together.
inline constexpr std::size_t most_points_of_slices = 10 * most_profile_points;
/// Bytes that the text of a ProfileFile may have.
inline constexpr std::size_t most_profile_text = 2 << 20;

/// Throws InvalidArgument naming the field below "profile" when a parameter can not be used. What the points describe
/// is for make_profile to check.
void validate(const ProfileSpec& spec);

}  // namespace contactd

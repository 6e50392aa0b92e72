#include "contactd/profile_spec.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

#include "contactd/error.hpp"
#include "contactd/fields/profile_spec.hpp"
#include "number_text.hpp"

namespace contactd {
namespace {

constexpr double most_inclination = 0.2, most_slope = 3, widest = 1000;  // widest in mm
constexpr double farthest_shift = 1e4;                                   // mm

void check_ends(double from, double to, const std::string& name) {
    if (!(std::abs(from) <= widest))
        throw InvalidArgument(name + ".from", "is " + number_text(from) + "; it must lie between -1000 and 1000 mm");
    if (!(std::abs(to) <= widest && to >= from + 1))
        throw InvalidArgument(name + ".to", "is " + number_text(to) + "; it must exceed `from`, " + number_text(from) +
                                                ", by at least 1 mm, and be at most 1000 mm");
}

void check_slope(double slope, const std::string& name) {
    if (!(std::abs(slope) <= most_slope))
        throw InvalidArgument(name + ".slope", "is " + number_text(slope) + "; it must lie between -3 and 3");
}

void check(const S1002&) {}

void check_inclination(double inclination, const std::string& of) {
    if (!(std::abs(inclination) <= most_inclination))
        throw InvalidArgument(of + ".inclination", "is " + number_text(inclination) +
                                                       "; it must be a slope between -0.2 and 0.2, such as 0.025");
}

void check(const Rail60E1& rail) {
    check_inclination(rail.inclination, "profile.rail_60e1");
}

void check(const StandardProfile& profile) {
    check_inclination(profile.inclination, "profile.standard");
    if (profile.name == StandardName::S1002 && profile.inclination != 0)
        throw InvalidArgument("profile.standard.inclination",
                              "is " + number_text(profile.inclination) + ", but S1002 is a wheel; remove it");
}

/// Checks that the name is that of a wheel or of a rail, as needed.
void check_kind(const StandardProfile& profile, ProfileKind kind) {
    const bool is_wheel = profile.name == StandardName::S1002;
    if (is_wheel != (kind == ProfileKind::wheel))
        throw InvalidArgument("profile.standard.name",
                              "is " + std::string(name_of(profile.name)) + ", which is a " +
                                  (is_wheel ? "wheel; give the name of a rail" : "rail; give the name of a wheel"));
}

void check(const ArcProfile& arc) {
    check_ends(arc.from, arc.to, "profile.arc");
    check_slope(arc.slope, "profile.arc");
    if (!(std::abs(arc.radius) >= 1 && std::abs(arc.radius) <= 1e5))
        throw InvalidArgument("profile.arc.radius",
                              "is " + number_text(arc.radius) + "; its magnitude must lie between 1 and 1e5 mm");
    const double leaning = std::sin(std::atan(arc.slope));
    for (const double y : {arc.from, arc.to})
        if (std::abs(y / arc.radius + leaning) > 0.999)
            throw InvalidArgument("profile.arc", "has the radius " + number_text(arc.radius) +
                                                     " and does not reach its end at y = " + number_text(y) +
                                                     "; move the end closer to 0");
}

void check(const ConeProfile& cone) {
    check_ends(cone.from, cone.to, "profile.cone");
    check_slope(cone.slope, "profile.cone");
}

void check_unit(double unit, const std::string& of) {
    if (!(unit >= 1e-6 && unit <= 1e6))
        throw InvalidArgument(
            of + ".unit",
            "is " + number_text(unit) +
                "; it must be the length of a unit of the points in mm: 1 for mm, 1000 for m, 25.4 for inches");
}

void check_smoothing(double length, const std::string& of) {
    if (!(length >= 0 && length <= 1000))
        throw InvalidArgument(of + ".smoothing_length", "is " + number_text(length) +
                                                            "; it must be a wavelength in mm between 0 and 1000: 0 for "
                                                            "no smoothing, about 5 for measured profiles");
}

void check(const ProfilePoints& points) {
    if (points.points.size() > most_profile_points)
        throw InvalidArgument("profile.points", "has " + std::to_string(points.points.size()) +
                                                    " entries, but at most " + std::to_string(most_profile_points) +
                                                    " are allowed; omit some of them");
    check_unit(points.unit, "profile");
    check_smoothing(points.smoothing_length, "profile");
}

void check(const ProfileFile& file) {
    if (file.name.empty())
        throw InvalidArgument("profile.file.name",
                              "is empty; its extension determines the format of the text, as in wheel.whl");
    if (file.text.empty() || file.text.size() > most_profile_text)
        throw InvalidArgument("profile.file.text", "has " + std::to_string(file.text.size()) +
                                                       " bytes; give the content of a file of 1 to " +
                                                       std::to_string(most_profile_text) +
                                                       " bytes, with fewer points if necessary");
    if (file.unit) check_unit(*file.unit, "profile.file");
    for (const auto& [shift, name] : {std::pair(file.shift_y, "y"), std::pair(file.shift_z, "z")})
        if (!(std::abs(shift) <= farthest_shift))
            throw InvalidArgument(std::string("profile.file.shift_") + name,
                                  "is " + number_text(shift) + "; it must lie between -10000 and 10000 mm");
    check_smoothing(file.smoothing_length, "profile.file");
    if (file.smoothing_order != 2 && file.smoothing_order != 3)
        throw InvalidArgument("profile.file.smoothing_order",
                              "is " + std::to_string(file.smoothing_order) +
                                  "; it must be 2 to penalize the curvature, or 3 to penalize its change");
    if (!(file.smoothing_lambda >= 0 && file.smoothing_lambda <= 1e9))
        throw InvalidArgument("profile.file.smoothing_lambda",
                              "is " + number_text(file.smoothing_lambda) + "; it must lie between 0 and 1e9 mm^3");
    if (file.smoothing_lambda > 0 && (file.smoothing_length > 0 || file.smoothing_order != 2))
        throw InvalidArgument("profile.file.smoothing_lambda",
                              "cannot be combined with smoothing_length or smoothing_order 3; remove one of them");
    const auto check_angle = [](double angle, const char* name) {
        if (!(angle >= 0 && angle <= std::numbers::pi))
            throw InvalidArgument(std::string("profile.file.kinks.") + name,
                                  "is " + number_text(angle) + "; it must be an angle between 0 and pi, in rad");
    };
    check_angle(file.kinks.angle, "angle");
    check_angle(file.kinks.rest, "rest");
    if (!(file.kinks.width >= 0 && file.kinks.width <= widest))
        throw InvalidArgument("profile.file.kinks.width",
                              "is " + number_text(file.kinks.width) + "; it must lie between 0 and 1000 mm");
}

}  // namespace

void validate(const ProfileSpec& spec) {
    std::visit([](const auto& shape) { check(shape); }, spec.shape);
    if (const auto* standard = std::get_if<StandardProfile>(&spec.shape)) check_kind(*standard, spec.kind);
}

}  // namespace contactd

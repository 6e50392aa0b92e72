#include "contactd/profile_spec.hpp"

#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "number_text.hpp"

namespace contactd {
namespace {

constexpr double most_inclination = 0.2, most_slope = 3, widest = 1000;  // widest: mm

void check_ends(double from, double to, const std::string& name) {
    if (!(std::abs(from) <= widest))
        throw InvalidArgument(name + ".from", "is " + number_text(from) + "; it must lie between -1000 and 1000 mm");
    if (!(std::abs(to) <= widest && to >= from + 1))
        throw InvalidArgument(name + ".to", "is " + number_text(to) + "; it must be at least 1 mm above `from`, " +
                                                number_text(from) + ", and 1000 mm at most");
}

void check_slope(double slope, const std::string& name) {
    if (!(std::abs(slope) <= most_slope))
        throw InvalidArgument(name + ".slope", "is " + number_text(slope) + "; it must lie between -3 and 3");
}

void check(const S1002&) {}

void check(const Rail60E1& rail) {
    if (!(std::abs(rail.inclination) <= most_inclination))
        throw InvalidArgument(
            "profile.rail_60e1.inclination",
            "is " + number_text(rail.inclination) + "; it is a slope between -0.2 and 0.2, such as 0.025");
}

void check(const ArcProfile& arc) {
    check_ends(arc.from, arc.to, "profile.arc");
    check_slope(arc.slope, "profile.arc");
    if (!(std::abs(arc.radius) >= 1 && std::abs(arc.radius) <= 1e5))
        throw InvalidArgument("profile.arc.radius",
                              "is " + number_text(arc.radius) + "; its size must be between 1 and 1e5 mm");
    const double leaning = std::sin(std::atan(arc.slope));
    for (const double y : {arc.from, arc.to})
        if (std::abs(y / arc.radius + leaning) > 0.999)
            throw InvalidArgument("profile.arc", "has the radius " + number_text(arc.radius) +
                                                     " and an end at y = " + number_text(y) +
                                                     ", which the arc does not reach; bring the end nearer to 0");
}

void check(const ConeProfile& cone) {
    check_ends(cone.from, cone.to, "profile.cone");
    check_slope(cone.slope, "profile.cone");
}

void check(const ProfilePoints& points) {
    if (points.points.size() > most_profile_points)
        throw InvalidArgument("profile.points", "are " + std::to_string(points.points.size()) + "; " +
                                                    std::to_string(most_profile_points) +
                                                    " are the most, leave some of them out");
    if (!(points.unit >= 1e-6 && points.unit <= 1e6))
        throw InvalidArgument("profile.unit",
                              "is " + number_text(points.unit) +
                                  "; it is the mm of a unit of the points: 1, 1000 for m, 25.4 for inches");
    if (!(points.smoothing_length >= 0 && points.smoothing_length <= 1000))
        throw InvalidArgument("profile.smoothing_length",
                              "is " + number_text(points.smoothing_length) +
                                  "; it is a wavelength in mm, 0 for no smoothing, about 5 for measured profiles");
}

}  // namespace

void validate(const ProfileSpec& spec) {
    std::visit([](const auto& shape) { check(shape); }, spec.shape);
}

}  // namespace contactd

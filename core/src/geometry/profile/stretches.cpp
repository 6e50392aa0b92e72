#include "geometry/profile/stretches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace contactd::geometry {
namespace {

constexpr double smallest_step = 0.01, largest_step = 0.5, growth = 1.3;  // mm

/// Returns parameters from 0 to the length, both included, symmetric.
std::vector<double> graded(double length) {
    std::vector<double> half{0};
    for (double step = smallest_step; half.back() < length / 2; step = std::min(growth * step, largest_step))
        half.push_back(half.back() + step);
    const double fit = length / 2 / half.back();
    std::vector<double> places;
    for (const double place : half) places.push_back(fit * place);
    for (std::size_t i = half.size() - 1; i-- > 0;) places.push_back(length - fit * half[i]);
    return places;
}

}  // namespace

Stretch straight(ProfilePoint from, ProfilePoint to) {
    const double length = std::hypot(to.y - from.y, to.z - from.z);
    return {length, [=](double t) {
                const double share = t / length;
                return ProfilePoint{from.y + share * (to.y - from.y), from.z + share * (to.z - from.z)};
            }};
}

Stretch arc(ProfilePoint centre, double radius, double from, double to) {
    const double length = radius * std::abs(to - from);
    return {length, [=](double t) {
                const double angle = from + t / length * (to - from);
                return ProfilePoint{centre.y + radius * std::cos(angle), centre.z + radius * std::sin(angle)};
            }};
}

Stretch polynomial(std::vector<double> powers, double from, double to) {
    return {to - from, [=, powers = std::move(powers)](double t) {
                const double y = from + t;
                double z = 0;
                for (std::size_t i = powers.size(); i-- > 0;) z = z * y + powers[i];
                return ProfilePoint{y, z};
            }};
}

std::vector<ProfilePoint> points_along(std::span<const Stretch> stretches) {
    std::vector<ProfilePoint> points{stretches.front().at(0)};
    for (const Stretch& stretch : stretches) {
        const auto places = graded(stretch.length);
        for (std::size_t i = 1; i < places.size(); ++i) points.push_back(stretch.at(places[i]));
    }
    return points;
}

}  // namespace contactd::geometry

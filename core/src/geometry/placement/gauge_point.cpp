#include "geometry/placement/gauge_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/profile/spline_piece.hpp"

namespace contactd::geometry {
namespace {

/// Returns the zeros of a quadratic a + b t + c t^2.
std::vector<double> zeros(double a, double b, double c) {
    const double square = b * b - 4 * a * c;
    if (!(square >= 0)) return {};
    const double q = -(b + std::copysign(std::sqrt(square), b)) / 2;  // avoids cancellation
    return {q / c, a / q};                                            // not finite if there is only one
}

/// Represents a curve's coordinate along an axis after the curve was rotated.
class Coordinate {
   public:
    Coordinate(const ProfileCurve& curve, ProfilePoint axis) : curve_(curve), axis_(axis) {}

    double along(const ProfilePoint& vector) const { return axis_.y * vector.y + axis_.z * vector.z; }
    double at(double s) const { return along(curve_.at(s)); }

    /// Returns places between which it ascends or descends throughout, including both ends and the knots.
    std::vector<double> stretches(double from, double to) const {
        std::vector<double> places{from, to};
        const std::vector<double>& knots = curve_.knots();
        for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
            if (knots[i + 1] <= from || knots[i] >= to) continue;
            places.push_back(knots[i]);
            for (const double s : extrema(knots[i], knots[i + 1])) places.push_back(s);
        }
        std::erase_if(places, [&](double s) { return s < from || s > to; });
        std::sort(places.begin(), places.end());
        return places;
    }

   private:
    /// Returns the extrema between two knots, over which it is a cubic.
    std::vector<double> extrema(double from, double to) const {
        const double half = 0.5 * (to - from);
        const auto begin = curve_.place(from);
        const double curving = along(begin.curving);
        const double twice_bend = (along(curve_.curving(from + half)) - curving) / half;
        std::vector<double> places;
        for (const double t : zeros(along(begin.slope), curving, twice_bend / 2))
            if (t > 0 && t < 2 * half) places.push_back(from + t);
        return places;
    }

    const ProfileCurve& curve_;
    ProfilePoint axis_;
};

Coordinate y_of(const ProfileCurve& profile, double cant) {
    return {profile, {std::cos(cant), std::sin(cant)}};
}

Coordinate z_of(const ProfileCurve& profile, double cant) {
    return {profile, {-std::sin(cant), std::cos(cant)}};
}

double place_of_least(const Coordinate& coordinate, double from, double to) {
    const std::vector<double> places = coordinate.stretches(from, to);
    return *std::min_element(places.begin(), places.end(),
                             [&](double a, double b) { return coordinate.at(a) < coordinate.at(b); });
}

}  // namespace

ProfilePoint canted(const ProfilePoint& point, double cant) {
    const double cosine = std::cos(cant), sine = std::sin(cant);
    return {cosine * point.y + sine * point.z, cosine * point.z - sine * point.y};
}

double s_of_top(const ProfileCurve& profile, double cant) {
    return place_of_least(z_of(profile, cant), profile.begin(), profile.end());
}

std::optional<double> s_of_depth(const ProfileCurve& profile, double cant, double s, double z) {
    const Coordinate height = z_of(profile, cant);
    const std::vector<double> places = height.stretches(profile.begin(), s);
    for (std::size_t i = places.size() - 1; i-- > 0;) {
        const double from = places[i], to = places[i + 1], above = height.at(to), below = height.at(from);
        if (!(below > z)) continue;
        return to - root(to - from, (to - from) * (z - above) / (below - above), [&](double t) {
                   const auto here = profile.place(to - t);
                   return std::pair(height.along(here.at) - z, -height.along(here.slope));
               });
    }
    return std::nullopt;
}

double s_of_least_y(const ProfileCurve& profile, double cant, double from, double to) {
    return place_of_least(y_of(profile, cant), from, to);
}

double least_y(const ProfileCurve& profile, double cant, double from, double to) {
    return y_of(profile, cant).at(s_of_least_y(profile, cant, from, to));
}

}  // namespace contactd::geometry

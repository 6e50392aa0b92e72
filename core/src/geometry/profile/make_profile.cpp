#include "contactd/make_profile.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/profile/cleaning.hpp"
#include "geometry/profile/formula_points.hpp"
#include "geometry/profile/measured_points.hpp"
#include "geometry/profile/smoothing.hpp"

namespace contactd {
namespace {

using geometry::Points;

/// Weights as the distances of the points, more at the ends, which are fixed, and most at kinks.
std::vector<double> weights_between(const std::vector<double>& s, std::size_t from, std::size_t to) {
    std::vector<double> weights;
    for (std::size_t i = from; i <= to; ++i) {
        const double before = i > from ? s[i] - s[i - 1] : 0, behind = i < to ? s[i + 1] - s[i] : 0;
        const bool end = i == 0 || i + 1 == s.size();
        weights.push_back((before + behind) / 2 * (end ? 20 : i == from || i == to ? 100 : 1));
    }
    return weights;
}

/// Each part between kinks for itself; where two meet, the mean of both.
Points smoothed(const ProfileCurve& rough, double wavelength) {
    const Points& points = rough.points();
    const auto& s = rough.knots();
    const double lambda = geometry::lambda_of(wavelength);
    Points smooth(points.size());
    std::size_t from = 0;
    for (std::size_t part = 0; part <= rough.kinks().size(); ++part) {
        const std::size_t to = part < rough.kinks().size() ? rough.kinks()[part] : points.size() - 1;
        const auto weights = weights_between(s, from, to);
        for (double ProfilePoint::* coordinate : {&ProfilePoint::y, &ProfilePoint::z}) {
            std::vector<double> values;
            for (std::size_t i = from; i <= to; ++i) values.push_back(points[i].*coordinate);
            const auto fit = geometry::smoothed({s.data() + from, values.size()}, values, weights, lambda);
            for (std::size_t i = from; i <= to; ++i) {
                const bool shared = (i == from && from > 0) || (i == to && to + 1 < points.size());
                smooth[i].*coordinate += (shared ? 0.5 : 1) * fit[i - from];
            }
        }
        from = to;
    }
    return smooth;
}

/// Returns the distance of the curve from a point near s on it.
double distance(const ProfileCurve& curve, const ProfilePoint& point, double s) {
    for (int iteration = 0; iteration < 10; ++iteration) {
        const auto here = curve.place(s);
        const double speed = here.slope.y * here.slope.y + here.slope.z * here.slope.z;
        s += ((point.y - here.at.y) * here.slope.y + (point.z - here.at.z) * here.slope.z) / speed;
    }
    const ProfilePoint at = curve.at(s);
    return std::hypot(at.y - point.y, at.z - point.z);
}

Profile of_points(const ProfilePoints& given, ProfileKind kind) {
    const Points points = geometry::measured_points(given, kind);
    const auto kinks = geometry::kinks_of(points);
    ProfileEvidence evidence{given.points.size(), points.size()};
    ProfileCurve curve(points, kinks);
    if (given.smoothing_length == 0) return {kind, curve, evidence};
    curve = ProfileCurve(smoothed(curve, given.smoothing_length), kinks);
    double squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double far = distance(curve, points[i], curve.knots()[i]);
        evidence.largest_distance = std::max(evidence.largest_distance, far);
        squares += far * far;
    }
    evidence.rms_distance = std::sqrt(squares / static_cast<double>(points.size()));
    return {kind, curve, evidence};
}

}  // namespace

Profile make_profile(const ProfileSpec& spec) {
    validate(spec);
    return std::visit(
        [&](const auto& shape) -> Profile {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, ProfilePoints>)
                return of_points(shape, spec.kind);
            else {
                const auto points = geometry::formula_points(shape);  // sides of an inclined head may lean under it
                ProfileCurve curve(spec.kind == ProfileKind::rail ? geometry::rail_seen_from_above(points) : points);
                const std::size_t kept = curve.points().size();
                return {spec.kind, std::move(curve), {points.size(), kept}};
            }
        },
        spec.shape);
}

}  // namespace contactd

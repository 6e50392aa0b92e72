#include "geometry/placement/sliced_rail.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/profile/natural_spline.hpp"

namespace contactd::geometry {
namespace {

constexpr double spacing = 0.5;  // mm: of points on the longest slice

/// s of the ends of each part.
std::vector<double> ends_of_parts(const ProfileCurve& curve, bool by_kinks) {
    std::vector<double> ends{curve.begin()};
    if (by_kinks)
        for (const std::size_t kink : curve.kinks()) ends.push_back(curve.knots()[kink]);
    ends.push_back(curve.end());
    return ends;
}

bool equally_many_kinks(const std::vector<ProfileCurve>& curves) {
    return std::all_of(curves.begin(), curves.end(), [&](const ProfileCurve& curve) {
        return curve.kinks().size() == curves.front().kinks().size();
    });
}

}  // namespace

SlicedRail::SlicedRail(std::vector<double> x, const std::vector<ProfileCurve>& curves) : x_(std::move(x)) {
    const bool by_kinks = equally_many_kinks(curves);
    std::vector<std::vector<double>> ends;
    for (const ProfileCurve& curve : curves) ends.push_back(ends_of_parts(curve, by_kinks));
    for (std::size_t part = 0; part + 1 < ends.front().size(); ++part) {
        double longest = 0;
        for (const auto& of_slice : ends) longest = std::max(longest, of_slice[part + 1] - of_slice[part]);
        const int pieces = std::max(3, static_cast<int>(std::ceil(longest / spacing)));
        if (part > 0) kinks_.push_back(y_.size() - 1);
        for (int piece = part > 0 ? 1 : 0; piece <= pieces; ++piece) {
            Line y, z;
            for (std::size_t slice = 0; slice < curves.size(); ++slice) {
                const double from = curves[slice].arc_length(ends[slice][part]);
                const double to = curves[slice].arc_length(ends[slice][part + 1]);
                const ProfilePoint at =
                    curves[slice].at(curves[slice].s_at_arc_length(from + (to - from) * piece / pieces));
                y.values.push_back(at.y);
                z.values.push_back(at.z);
            }
            for (Line* line : {&y, &z}) line->curving = natural_curving(x_, line->values);
            y_.push_back(std::move(y));
            z_.push_back(std::move(z));
        }
    }
}

ProfileCurve SlicedRail::at(double x) const {
    const double inside = std::clamp(x, x_.front(), x_.back());
    const auto behind = std::upper_bound(x_.begin() + 1, x_.end() - 1, inside);
    const auto i = static_cast<std::size_t>(behind - x_.begin()) - 1;
    const double h = x_[i + 1] - x_[i], b = (inside - x_[i]) / h, a = 1 - b;
    const auto value = [&](const Line& line) {
        return a * line.values[i] + b * line.values[i + 1] +
               h * h / 6 * ((a * a * a - a) * line.curving[i] + (b * b * b - b) * line.curving[i + 1]);
    };
    std::vector<ProfilePoint> points;
    points.reserve(y_.size());
    for (std::size_t k = 0; k < y_.size(); ++k) points.push_back({value(y_[k]), value(z_[k])});
    return ProfileCurve(std::move(points), kinks_);
}

}  // namespace contactd::geometry

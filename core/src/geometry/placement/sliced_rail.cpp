#include "geometry/placement/sliced_rail.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "contactd/count_of.hpp"
#include "contactd/error.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr double spacing = 0.5;         // mm: of points on the longest slice
constexpr int most_places = 2'000'000;  // 64 MB

/// s of the ends of each part.
std::vector<double> ends_of_parts(const ProfileCurve& curve) {
    std::vector<double> ends{curve.begin()};
    for (const std::size_t kink : curve.kinks()) ends.push_back(curve.knots()[kink]);
    ends.push_back(curve.end());
    return ends;
}

/// Parts that begin or end between two slices have nothing to be joined with.
void check_parts(const std::vector<ProfileCurve>& curves) {
    const std::size_t parts = curves.front().kinks().size() + 1;
    for (std::size_t i = 1; i < curves.size(); ++i)
        if (const std::size_t here = curves[i].kinks().size() + 1; here != parts)
            throw InvalidArgument("rail_slices[" + std::to_string(i) + "].profile",
                                  "has " + std::to_string(here) + (here == 1 ? " part" : " parts") +
                                      " between kinks, and the first slice has " + std::to_string(parts) +
                                      "; slices are joined part by part, so all need as many kinks (turns of more than "
                                      "30 degrees at a point): smooth what is noise, or cut the slices alike");
}

}  // namespace

SlicedRail::SlicedRail(std::vector<double> x, const std::vector<ProfileCurve>& curves) : along_(std::move(x)) {
    check_parts(curves);
    std::vector<std::vector<double>> ends;
    for (const ProfileCurve& curve : curves) ends.push_back(ends_of_parts(curve));
    for (std::size_t part = 0; part + 1 < ends.front().size(); ++part) {
        double longest = 0;
        for (const auto& of_slice : ends) longest = std::max(longest, of_slice[part + 1] - of_slice[part]);
        const int pieces =
            std::max(3, count_of(std::ceil(longest / spacing),
                                 {"rail_slices", "have a part that is " + short_text(longest) + " mm long",
                                  "places along all slices together",
                                  "take fewer slices, or leave out points that leap up and down",
                                  most_places / static_cast<int>(curves.size())}));
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
            for (Line* line : {&y, &z}) line->derivatives = along_.derivatives(line->values);
            y_.push_back(std::move(y));
            z_.push_back(std::move(z));
        }
    }
}

ProfileCurve SlicedRail::at(double x) const {
    const std::vector<double>& slices = along_.knots();
    const double inside = std::clamp(x, slices.front(), slices.back());
    const auto behind = std::upper_bound(slices.begin() + 1, slices.end() - 1, inside);
    const auto i = static_cast<std::size_t>(behind - slices.begin()) - 1;
    const double h = along_.width(i);
    const QuinticWeights weights = QuinticWeights::of_value((inside - slices[i]) / h, h);
    const auto value = [&](const Line& line) {
        return line.values[i] +
               weights.sum(line.values[i + 1] - line.values[i], line.derivatives[i], line.derivatives[i + 1]);
    };
    std::vector<ProfilePoint> points;
    points.reserve(y_.size());
    for (std::size_t k = 0; k < y_.size(); ++k) points.push_back({value(y_[k]), value(z_[k])});
    return ProfileCurve(std::move(points), kinks_);
}

}  // namespace contactd::geometry

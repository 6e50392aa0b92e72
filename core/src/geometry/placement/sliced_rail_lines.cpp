// Computes lines of a rail of slices along the track: their positions without the profiles between slices, and their
// slopes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/placement/sliced_rail.hpp"

namespace contactd::geometry {
namespace {

// The derivative of a Bezier polygon lies between those of its sides.
double steepest_of(const LineAlong& line, std::size_t knot, double width) {
    const auto ordinates = bezier_ordinates(width, line.values[knot + 1] - line.values[knot], line.derivatives[knot],
                                            line.derivatives[knot + 1]);
    double largest = 0;
    for (std::size_t i = 0; i + 1 < ordinates.size(); ++i)
        largest = std::max(largest, std::abs(ordinates[i + 1] - ordinates[i]));
    return static_cast<double>(ordinates.size() - 1) * largest / width;
}

}  // namespace

void SlicedRail::find_steepest() {
    steepest_.assign(x_.size() - 1, {0, 0});
    for (const Stretch& stretch : stretches_)
        for (std::size_t slice = stretch.first; slice < stretch.last; ++slice) {
            const std::size_t knot = slice - stretch.first;
            const double width = stretch.along.width(knot);
            ProfilePoint& steepest = steepest_[slice];
            for (const LineAlong& y : stretch.y) steepest.y = std::max(steepest.y, steepest_of(y, knot, width));
            for (const LineAlong& z : stretch.z) steepest.z = std::max(steepest.z, steepest_of(z, knot, width));
        }
}

SlicedRail::Place SlicedRail::place(double x) const {
    const double inside = std::clamp(x, x_.front(), x_.back());
    const std::size_t slice = slice_before(inside);
    const double width = x_[slice + 1] - x_[slice];
    return {slice, QuinticWeights::of_value((inside - x_[slice]) / width, width)};
}

std::size_t SlicedRail::lines() const {
    std::size_t lines = 0;
    for (const Stretch& stretch : stretches_) lines += stretch.y.size();
    return lines;
}

void SlicedRail::look_along(std::size_t line, std::span<const Place> places, std::vector<ProfilePoint>& points) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    auto stretch = stretches_.begin();
    for (; line >= stretch->y.size(); ++stretch) line -= stretch->y.size();
    const LineAlong &y = stretch->y[line], &z = stretch->z[line];
    points.clear();
    for (const auto& [slice, weights] : places) {
        const bool exists = slice >= stretch->first && slice < stretch->last;
        const std::size_t knot = exists ? slice - stretch->first : 0;
        points.push_back(exists ? ProfilePoint{y.between(knot, weights), z.between(knot, weights)}
                                : ProfilePoint{none, none});
    }
}

ProfilePoint SlicedRail::largest_change(double from, double to) const {
    ProfilePoint change{0, 0};
    for (std::size_t slice = slice_before(from); slice + 1 < x_.size() && x_[slice] < to; ++slice) {
        const double length = std::max(0.0, std::min(to, x_[slice + 1]) - std::max(from, x_[slice]));
        change.y += length * steepest_[slice].y;
        change.z += length * steepest_[slice].z;
    }
    return change;
}

double SlicedRail::steepest(double from, double to) const {
    double steepest = 0;
    for (std::size_t slice = slice_before(from); slice + 1 < x_.size() && x_[slice] < to; ++slice)
        steepest = std::max(steepest, steepest_[slice].z);
    return steepest;
}

}  // namespace contactd::geometry

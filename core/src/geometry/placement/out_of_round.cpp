#include "geometry/placement/out_of_round.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "contactd/count_of.hpp"
#include "geometry/profile/natural_spline.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double spacing = 0.5;  // mm: distance of stations along the profile
constexpr int most_stations = 1'000'000;
constexpr double ends_differ = 1;  // mm: largest difference of the ends of a slice and the first one
constexpr double largest = 20;     // mm: largest plausible deviation

}  // namespace

OutOfRound::OutOfRound(std::vector<double> angles, const std::vector<ProfileCurve>& slices, SliceSpline spline)
    : round_(std::move(angles), spline, turn, EqualValues::may_flank_extremum) {
    const ProfileCurve& first = slices.front();
    const auto pieces = static_cast<std::size_t>(
        count_of(std::ceil(first.end() / spacing),
                 {"wheel_slices[0].profile", "is " + short_text(first.end()) + " mm long",
                  "stations, the same number on each slice", "use fewer slices, or omit points that jump up and down",
                  most_stations / static_cast<int>(slices.size())}));
    for (std::size_t k = 0; k <= pieces; ++k)
        stations_.push_back(first.end() * static_cast<double>(k) / static_cast<double>(pieces));
    const std::size_t count = slices.size();
    slices_.resize(count);
    for (std::size_t i = 0; i < count; ++i) slices_[i].radius.values = radii_beside(slices[i], first, i);
    std::vector<SlicePoints> all_radii;
    for (const Slice& slice : slices_) all_radii.push_back(slice.radius.values);
    const std::vector<DerivativeShares> shares = round_.shares(all_radii);
    for (std::size_t k = 0; k < stations_.size(); ++k) {
        std::vector<double> radii;
        for (const SlicePoints& slice : all_radii) radii.push_back(slice[k]);
        const auto [at_slices, derivatives] = round_.line(std::move(radii), shares);
        for (std::size_t i = 0; i < count; ++i) {
            slices_[i].radius.values[k] = at_slices[i];
            slices_[i].slope.values.push_back(derivatives[i].slope);
            slices_[i].curving.values.push_back(derivatives[i].curving);
            const std::size_t next = (i + 1) % count;
            const double h = round_.width(i);
            const auto polygon = bezier_ordinates(h, at_slices[next] - at_slices[i], derivatives[i], derivatives[next]);
            for (std::size_t side = 0; side + 1 < polygon.size(); ++side)
                steepest_ = std::max(steepest_, 5 * std::abs(polygon[side + 1] - polygon[side]) / h);
        }
    }
    for (Slice& slice : slices_)
        for (Line* line : {&slice.radius, &slice.slope, &slice.curving})
            line->curving = natural_curving(stations_, line->values);
    find_nodes(slices, shares);
}

std::vector<double> OutOfRound::radii_beside(const ProfileCurve& slice, const ProfileCurve& first,
                                             std::size_t index) const {
    const std::string field = "wheel_slices[" + std::to_string(index) + "].profile";
    const ProfilePoint from = slice.points().front(), to = slice.points().back();
    const ProfilePoint first_from = first.points().front(), first_to = first.points().back();
    if (std::abs(from.y - first_from.y) > ends_differ || std::abs(to.y - first_to.y) > ends_differ)
        throw InvalidArgument(field, "reaches from y = " + short_text(from.y) + " to " + short_text(to.y) +
                                         " mm, but the first slice from " + short_text(first_from.y) + " to " +
                                         short_text(first_to.y) + "; cut all slices at the same y");
    std::vector<double> radii;
    for (const double s : stations_) {
        const ProfilePoint here = first.at(s);
        const auto [at, slope, curving] = slice.place(slice.s_at_y(here.y));
        // Beyond its last points a slice continues along its tangent.
        const double z = at.z + (slope.y != 0 ? slope.z / slope.y * (here.y - at.y) : 0);
        radii.push_back(&slice == &first ? 0 : z - here.z);
        if (!(std::abs(radii.back()) <= largest))
            throw InvalidArgument(field, "differs by " + short_text(std::abs(radii.back())) +
                                             " mm from the first slice at y = " + short_text(here.y) +
                                             " mm; the largest supported out-of-roundness is " + number_text(largest) +
                                             " mm: check the units, and that all slices use the same coordinates");
    }
    return radii;
}

OutOfRound::Along OutOfRound::along(const Line& line, double s) const {
    const double h = stations_[1], inside = std::clamp(s, 0.0, stations_.back());
    const auto k = std::min(static_cast<std::size_t>(inside / h), stations_.size() - 2);
    const double b = (inside - stations_[k]) / h, a = 1 - b;
    const auto& [values, curving] = line;
    return {
        a * values[k] + b * values[k + 1] +
            h * h / 6 * ((a * a * a - a) * curving[k] + (b * b * b - b) * curving[k + 1]),
        (values[k + 1] - values[k]) / h + h / 6 * ((1 - 3 * a * a) * curving[k] + (3 * b * b - 1) * curving[k + 1])};
}

OutOfRound::Between OutOfRound::between(double angle) const {
    const std::vector<double>& angles = round_.knots();
    const double round = angle - angles.front(), within = round - turn * std::floor(round / turn) + angles.front();
    const auto behind = std::upper_bound(angles.begin() + 1, angles.end(), within);
    const auto i = static_cast<std::size_t>(behind - angles.begin()) - 1;
    return {i, (i + 1) % angles.size(), round_.width(i), (within - angles[i]) / round_.width(i)};
}

void OutOfRound::find_nodes(const std::vector<ProfileCurve>& slices, std::span<const DerivativeShares> shares) {
    double longest = 0;
    for (const ProfileCurve& slice : slices) longest = std::max(longest, slice.end());
    constexpr double rounding = 1e-6;  // mm
    const auto pieces = static_cast<std::size_t>((longest + rounding) / spacing) + 1;
    for (std::size_t k = 0; k <= pieces; ++k) {
        std::vector<double> y, z;
        for (const ProfileCurve& slice : slices) {
            const ProfilePoint at = slice.at(slice.end() * static_cast<double>(k) / static_cast<double>(pieces));
            y.push_back(at.y);
            z.push_back(at.z);
        }
        nodes_.push_back({round_.line(std::move(y), shares), round_.line(std::move(z), shares)});
    }
}

ProfilePoint OutOfRound::node(double angle, std::size_t index) const {
    const auto [slice, next, width, share] = between(angle);
    const QuinticWeights weights = QuinticWeights::of_value(share, width);
    const auto value = [&](const LineAlong& line) {
        return line.values[slice] +
               weights.sum(line.values[next] - line.values[slice], line.derivatives[slice], line.derivatives[next]);
    };
    return {value(nodes_[index].y), value(nodes_[index].z)};
}

OutOfRound::Place OutOfRound::at(double angle, double s) const {
    const auto [i, next, h, t] = between(angle);
    const Slice &from = slices_[i], &to = slices_[next];
    const Along begin = along(from.radius, s), end = along(to.radius, s);
    const Along leaving = along(from.slope, s), arriving = along(to.slope, s);
    const Along bending = along(from.curving, s), unbending = along(to.curving, s);
    const auto sum = [&](const QuinticWeights& weights, double Along::* part) {
        return weights.sum(end.*part - begin.*part, {leaving.*part, bending.*part}, {arriving.*part, unbending.*part});
    };
    const QuinticWeights weights = QuinticWeights::of_value(t, h);
    return {begin.value + sum(weights, &Along::value), sum(QuinticWeights::of_slope(t, h), &Along::value),
            begin.slope + sum(weights, &Along::slope)};
}

}  // namespace contactd::geometry

#include "geometry/placement/out_of_round.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "contactd/error.hpp"
#include "geometry/profile/natural_spline.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double spacing = 0.5;    // mm: of stations along the profile
constexpr double ends_differ = 1;  // mm: at most, of a slice and the first one
constexpr double largest = 20;     // mm: out of round by more no wheel is

/// The slope at a point from those of the two intervals on either side.
double slope_between(double before_that, double before, double behind, double behind_that) {
    const auto weight = [](double near, double far) { return std::abs(far - near) + 0.5 * std::abs(far + near); };
    const double of_before = weight(behind, behind_that), of_behind = weight(before_that, before);
    const double sum = of_before + of_behind;
    if (sum == 0) return 0;
    // Steeper than that, a cubic leaves what its slices have between them, the farther the longer it is.
    const double steepest = 3 * std::min(std::abs(before), std::abs(behind));
    return std::clamp((of_before * before + of_behind * behind) / sum, -steepest, steepest);
}

}  // namespace

OutOfRound::OutOfRound(std::vector<double> angles, const std::vector<ProfileCurve>& slices)
    : angles_(std::move(angles)) {
    const ProfileCurve& first = slices.front();
    const auto pieces = static_cast<std::size_t>(std::ceil(first.end() / spacing));
    for (std::size_t k = 0; k <= pieces; ++k)
        stations_.push_back(first.end() * static_cast<double>(k) / static_cast<double>(pieces));
    const std::size_t count = slices.size();
    for (std::size_t i = 0; i < count; ++i) radii_.push_back({radii_beside(slices[i], first, i), {}});
    slopes_.resize(count);
    for (std::size_t k = 0; k < stations_.size(); ++k) {
        const auto chord = [&](std::size_t i) {
            i %= count;
            return (radii_[(i + 1) % count].values[k] - radii_[i].values[k]) / width(i);
        };
        for (std::size_t i = 0; i < count; ++i) {
            slopes_[i].values.push_back(
                slope_between(chord(i + 2 * count - 2), chord(i + count - 1), chord(i), chord(i + 1)));
            // Between slices a cubic is at most half again as steep as the chord and as both ends.
            steepest_ = std::max({steepest_, std::abs(slopes_[i].values.back()), 1.5 * std::abs(chord(i))});
        }
    }
    for (auto* lines : {&radii_, &slopes_})
        for (Line& line : *lines) line.curving = natural_curving(stations_, line.values);
}

std::vector<double> OutOfRound::radii_beside(const ProfileCurve& slice, const ProfileCurve& first,
                                             std::size_t index) const {
    const std::string field = "wheel_slices[" + std::to_string(index) + "].profile";
    const ProfilePoint from = slice.points().front(), to = slice.points().back();
    const ProfilePoint first_from = first.points().front(), first_to = first.points().back();
    if (std::abs(from.y - first_from.y) > ends_differ || std::abs(to.y - first_to.y) > ends_differ)
        throw InvalidArgument(field, "reaches from y = " + short_text(from.y) + " to " + short_text(to.y) +
                                         " mm, and the first slice from " + short_text(first_from.y) + " to " +
                                         short_text(first_to.y) + "; cut all slices at the same y");
    std::vector<double> radii;
    for (const double s : stations_) {
        const ProfilePoint here = first.at(s);
        const auto [at, slope, curving] = slice.place(slice.s_at_y(here.y));
        // Beyond its last points a slice goes on as its tangent.
        const double z = at.z + (slope.y != 0 ? slope.z / slope.y * (here.y - at.y) : 0);
        radii.push_back(&slice == &first ? 0 : z - here.z);
        if (!(std::abs(radii.back()) <= largest))
            throw InvalidArgument(field, "differs by " + short_text(std::abs(radii.back())) +
                                             " mm from the first slice at y = " + short_text(here.y) +
                                             " mm; a wheel is out of round by " + number_text(largest) +
                                             " mm at most: check units, and that all slices have the same coordinates");
    }
    return radii;
}

double OutOfRound::width(std::size_t slice) const {
    return slice + 1 < angles_.size() ? angles_[slice + 1] - angles_[slice] : angles_.front() + turn - angles_.back();
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

OutOfRound::Place OutOfRound::at(double angle, double s) const {
    const double round = angle - angles_.front(), within = round - turn * std::floor(round / turn) + angles_.front();
    const auto behind = std::upper_bound(angles_.begin() + 1, angles_.end(), within);
    const auto i = static_cast<std::size_t>(behind - angles_.begin()) - 1, next = (i + 1) % angles_.size();
    const double h = width(i), t = (within - angles_[i]) / h, u = 1 - t;
    const Along from = along(radii_[i], s), to = along(radii_[next], s);
    const Along leaving = along(slopes_[i], s), arriving = along(slopes_[next], s);
    const double of_to = t * t * (3 - 2 * t), of_leaving = h * t * u * u, of_arriving = -h * t * t * u;
    const auto mixed = [&](double Along::* part) {
        return from.*part + of_to * (to.*part - from.*part) + of_leaving * leaving.*part + of_arriving * arriving.*part;
    };
    return {
        mixed(&Along::value),
        6 * t * u * (to.value - from.value) / h + u * (1 - 3 * t) * leaving.value + t * (3 * t - 2) * arriving.value,
        mixed(&Along::slope)};
}

}  // namespace contactd::geometry

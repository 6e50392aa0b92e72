#include "dang_van.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "smallest_ball.hpp"

namespace contactd {
namespace {

double mean(const StressTensor& stress) {
    return (stress[0] + stress[1] + stress[2]) / 3;
}

/// Returns coordinates whose lengths are those of the tensors.
DeviatorPoint point_of(const StressTensor& stress) {
    using std::numbers::sqrt2;
    return {(2 * stress[2] - stress[0] - stress[1]) / std::sqrt(6.0), (stress[0] - stress[1]) / sqrt2,
            sqrt2 * stress[3], sqrt2 * stress[4], sqrt2 * stress[5]};
}

StressTensor tensor_of(const DeviatorPoint& point) {
    using std::numbers::sqrt2;
    const double zz = 2 * point[0] / std::sqrt(6.0), half = point[1] / sqrt2;
    return {half - zz / 2, 0 - half - zz / 2, zz, point[2] / sqrt2, point[3] / sqrt2, point[4] / sqrt2};
}

/// Returns a point on the cubic through two points whose slopes are those of the chords over their neighbours.
StressTensor between(std::span<const StressTensor> history, std::size_t from, double t) {
    const StressTensor &a = history[from], &b = history[from + 1];
    const StressTensor& before = history[from - std::min<std::size_t>(from, 1)];
    const StressTensor& behind = history[std::min(from + 2, history.size() - 1)];
    StressTensor result{};
    for (std::size_t c = 0; c < result.size(); ++c) {
        const double slope_a = (b[c] - before[c]) / 2, slope_b = (behind[c] - a[c]) / 2;
        const double difference = b[c] - a[c];
        result[c] =
            a[c] +
            t * (slope_a + t * (3 * difference - 2 * slope_a - slope_b + t * (slope_a + slope_b - 2 * difference)));
    }
    return result;
}

/// The centre of a ball on few of its points moves by far more than the distance of these from their curve, so points
/// are added.
std::vector<StressTensor> finer(std::span<const StressTensor> history) {
    constexpr int parts = 4;
    std::vector<StressTensor> result;
    for (std::size_t i = 0; i < history.size(); ++i) {
        result.push_back(history[i]);
        for (int part = 1; i + 1 < history.size() && part < parts; ++part)
            result.push_back(between(history, i, static_cast<double>(part) / parts));
    }
    return result;
}

}  // namespace

// Principal values of a deviator are 2 sqrt(J2/3) cos(theta + 2 pi k/3), cos 3 theta = (3 sqrt 3/2) J3/J2^(3/2).
double largest_shear(const StressTensor& stress) {
    const double middle = mean(stress);
    const double x = stress[0] - middle, y = stress[1] - middle, z = stress[2] - middle;
    const double xy = stress[3], xz = stress[4], yz = stress[5];
    const double J2 = (x * x + y * y + z * z) / 2 + xy * xy + xz * xz + yz * yz;
    if (!(J2 > 0)) return 0;
    const double J3 = x * (y * z - yz * yz) - xy * (xy * z - yz * xz) + xz * (xy * yz - y * xz);
    const double cosine = std::clamp(1.5 * std::numbers::sqrt3 * J3 / (J2 * std::sqrt(J2)), -1.0, 1.0);
    return std::sqrt(J2) * std::sin(std::acos(cosine) / 3 + std::numbers::pi / 3);
}

double dang_van_stress(std::span<const StressTensor> passage, double a_DV, double residual) {
    const std::vector<StressTensor> history = finer(passage);
    std::vector<DeviatorPoint> points{DeviatorPoint{}};
    for (const StressTensor& stress : history) points.push_back(point_of(stress));
    const DeviatorPoint centre = smallest_ball(points).centre;
    const auto value_of = [&](const StressTensor& stress) {
        DeviatorPoint point = point_of(stress);
        for (std::size_t c = 0; c < point.size(); ++c) point[c] -= centre[c];
        return largest_shear(tensor_of(point)) + a_DV * (residual + mean(stress));
    };
    double largest = value_of(StressTensor{});
    std::size_t place = history.size();
    for (std::size_t i = 0; i < history.size(); ++i) {
        const double value = value_of(history[i]);
        if (value <= largest) continue;
        largest = value;
        place = i;
    }
    if (place == history.size()) return largest;
    // Peaks have edges, which lie between points.
    constexpr int parts = 4;
    for (std::size_t from = place - std::min<std::size_t>(place, 1); from <= place && from + 1 < history.size(); ++from)
        for (int part = 1; part < parts; ++part)
            largest = std::max(largest, value_of(between(history, from, static_cast<double>(part) / parts)));
    return largest;
}

}  // namespace contactd

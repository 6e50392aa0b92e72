#include "branch.hpp"

#include <cmath>

namespace contactd {

std::size_t regions_in(const WheelRailSolution& solution) {
    std::size_t regions = 0;
    for (const WheelRailPatch& patch : solution.patches) regions += patch.place.regions.size();
    return regions;
}

std::optional<double> nearest_height(const std::function<bool(double z)>& is_on_branch, double z, double end) {
    constexpr int steps = 16;
    constexpr double close = 1e-7;  // mm
    double others = z, there = z;
    bool found = false;
    for (int step = 1; step <= steps && !found; ++step) {
        others = there;
        there = z + (end - z) * step / steps;
        found = is_on_branch(there);
    }
    if (!found) return std::nullopt;
    while (std::abs(there - others) > close) {
        const double middle = 0.5 * (others + there);
        (is_on_branch(middle) ? there : others) = middle;
    }
    return there;
}

}  // namespace contactd

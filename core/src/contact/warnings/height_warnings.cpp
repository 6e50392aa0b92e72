#include "contact/warnings/height_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include "types/number_text.hpp"

namespace contactd {
namespace {

/// Rises from element to element of a distance that is given: how many there are, how many are steeper than 45 degrees,
/// and the largest.
struct Rises {
    std::size_t count = 0, steep = 0;
    double largest = 0;
};

/// Elements that are excluded by a large distance do not count.
Rises rises_of(const Grid& grid, const std::vector<double>& heights) {
    const auto nx = static_cast<std::size_t>(grid.nx), ny = static_cast<std::size_t>(grid.ny);
    const double excluded = 1e3 * std::max(grid.nx * grid.dx, grid.ny * grid.dy);
    Rises rises;
    const auto add = [&](std::size_t from, std::size_t to, double size) {
        if (std::abs(heights[from]) > excluded || std::abs(heights[to]) > excluded) return;
        const double rise = std::abs(heights[to] - heights[from]) / size;
        ++rises.count;
        if (rise > 1) ++rises.steep;
        rises.largest = std::max(rises.largest, rise);
    };
    for (std::size_t i = 0; i < nx * ny; ++i) {
        if (i % nx + 1 < nx) add(i, i + 1, grid.dx);
        if (i + nx < nx * ny) add(i, i + nx, grid.dy);
    }
    return rises;
}

}  // namespace

std::vector<std::string> height_warnings(const ContactProblem& problem, const ContactSolution& solution) {
    constexpr double flattest = 1e-4, rounding = 1e-12;
    const auto* heights = problem.gap ? std::get_if<std::vector<double>>(&*problem.gap) : nullptr;
    if (heights == nullptr) return {};
    const Rises rises = rises_of(problem.grid, *heights);
    if (2 * rises.steep > rises.count)
        return {"gap rises by more than 45 degrees between most of its elements, by up to " +
                short_text(rises.largest) + " mm a mm. Give heights in mm, not in micrometres."};
    if (rises.largest > rounding && rises.largest < flattest &&
        static_cast<std::size_t>(solution.elements.contact) == heights->size())
        return {"gap rises by no more than " + short_text(rises.largest) +
                " mm a mm, and is pressed flat as a whole: all elements are in contact. Give heights in mm, "
                "not in m."};
    return {};
}

}  // namespace contactd

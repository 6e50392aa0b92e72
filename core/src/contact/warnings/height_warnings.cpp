#include "contact/warnings/height_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include "types/units/plain_text.hpp"

namespace contactd {
namespace {

/// Describes slopes of a given gap between neighbouring elements: their number, the number steeper than 45 degrees, and
/// the sum of their squares.
struct Rises {
    std::size_t count = 0, steep = 0;
    double squares = 0;

    double mean() const { return count == 0 ? 0 : std::sqrt(squares / static_cast<double>(count)); }
};

/// Computes the slopes, without elements that are excluded by a large distance.
Rises rises_of(const Grid& grid, const std::vector<double>& heights) {
    const auto nx = static_cast<std::size_t>(grid.nx), ny = static_cast<std::size_t>(grid.ny);
    const double excluded = 1e3 * std::max(grid.nx * grid.dx, grid.ny * grid.dy);
    Rises rises;
    const auto add = [&](std::size_t first, std::size_t count, std::size_t to_next, double size) {
        double squares = 0;
        for (std::size_t i = first; i < first + count; ++i) {
            if (std::abs(heights[i]) > excluded || std::abs(heights[i + to_next]) > excluded) continue;
            const double rise = std::abs(heights[i + to_next] - heights[i]);
            ++rises.count;
            if (rise > size) ++rises.steep;
            squares += rise * rise;
        }
        rises.squares += squares / (size * size);
    };
    for (std::size_t row = 0; row < ny; ++row) add(row * nx, nx - 1, 1, grid.dx);
    add(0, nx * (ny - 1), nx, grid.dy);
    return rises;
}

}  // namespace

std::vector<std::string> height_warnings(const ContactProblem& problem, const ContactSolution& solution) {
    constexpr double flattest = 5e-4;   // Roughness has slopes of 0.01 to 0.5, and bodies in contact at least 1e-3.
    constexpr double rounding = 1e-12;  // slope of a flat surface, from rounding
    const auto* heights = problem.gap ? std::get_if<std::vector<double>>(&*problem.gap) : nullptr;
    if (heights == nullptr) return {};
    const Rises rises = rises_of(problem.grid, *heights);
    const auto mean = [&] { return plain_text(rises.mean()) + " mm per mm (root mean square)"; };
    if (2 * rises.steep > rises.count)
        return {"gap rises by more than 45 degrees between most of its elements, by " + mean() +
                ". Give heights in mm, not in micrometres."};
    if (rises.mean() > rounding && rises.mean() < flattest &&
        static_cast<std::size_t>(solution.elements.contact) == heights->size())
        return {"gap rises by only " + mean() + ", and all elements are in contact. Give heights in mm, not in m."};
    return {};
}

}  // namespace contactd

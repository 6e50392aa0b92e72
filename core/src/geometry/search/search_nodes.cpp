#include "geometry/search/search_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace contactd::geometry {
namespace {

/// Returns the number of lines over a length, which is odd, so that one of them is in the middle.
std::size_t lines_over(double length, double step, std::size_t rows) {
    const std::size_t lines = lines_within_bound(std::round(length / step + 2), rows);
    return lines + (lines % 2 == 0 ? 1 : 0);
}

NodeMesh of_round(const WheelSurface& wheel, double dx) {
    constexpr double step = 1.5, small_wheel = 30.5;  // in elements; mm
    const double radius = wheel.nominal_radius(), reach = radius * (radius < small_wheel ? 0.242 : 0.125);
    const std::size_t columns = lines_over(2 * reach, step * dx, wheel.profile().knots().size());
    std::vector<Vector3> nodes;
    for (const double s : wheel.profile().knots()) {
        if (s < wheel.visible().from || s > wheel.visible().to) continue;
        for (std::size_t i = 0; i < columns; ++i) {
            const double x = -reach + 2 * reach * static_cast<double>(i) / static_cast<double>(columns - 1);
            nodes.push_back(wheel.frame().outside(wheel.in_wheel(x, s)));
        }
    }
    return {columns, std::move(nodes), NodeMesh::Between::straight};
}

NodeMesh of_slices(const WheelSurface& wheel, double dx) {
    constexpr double step = 4, reach = 0.2;  // in elements; rad
    const auto [first, last] = wheel.seen_slice_nodes();
    const std::size_t columns = lines_over(2 * reach * wheel.nominal_radius(), step * dx, last - first + 1);
    std::vector<Vector3> nodes;
    for (std::size_t row = first; row <= last; ++row)
        for (std::size_t i = 0; i < columns; ++i) {
            const double ahead = -reach + 2 * reach * static_cast<double>(i) / static_cast<double>(columns - 1);
            nodes.push_back(wheel.frame().outside(wheel.slice_node(ahead, row)));
        }
    return {columns, std::move(nodes), NodeMesh::Between::straight};
}

}  // namespace

NodeMesh search_nodes(const WheelSurface& wheel, double dx) {
    return wheel.is_round() ? of_round(wheel, dx) : of_slices(wheel, dx);
}

}  // namespace contactd::geometry

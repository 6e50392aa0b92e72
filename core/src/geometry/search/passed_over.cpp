#include "geometry/search/passed_over.hpp"

#include <algorithm>

#include "geometry/search/edges_along.hpp"

namespace contactd::geometry {
namespace {

constexpr double coarse_x = 1, coarse_y = 0.5;  // mm
constexpr double least_depth = 0.005;           // mm: least overlap that matters
constexpr double part_of_depth = 0.1;           // least overlap over the deepest one

}  // namespace

CoarseMesh::CoarseMesh(const WheelSurface& wheel, const RailSurface& rail, const Observer& observer)
    : mesh_(wheel, rail, coarse_x, coarse_y, observer) {}

std::optional<PassedOver> CoarseMesh::passed_over(const Locus& locus, double z) {
    mesh_.look_below(z);
    const double deepest = z - std::min(locus.least_gap(), mesh_.least_gap());
    const double least = std::max(least_depth, part_of_depth * deepest);
    PassedOver found;
    const auto& [from, to] = mesh_.looked_at();
    for (std::size_t row = from.row; row <= to.row; ++row)
        for (std::size_t column = from.column; column <= to.column; ++column) {
            const double gap = mesh_.gap({column, row}), depth = z - gap;
            if (!(depth > std::max(least, found.depth))) continue;
            const double expected = expected_gap(locus, mesh_.x(column), mesh_.y(row));
            if (expected > z && gap < expected - known_gap) found = {depth, mesh_.x(column), mesh_.y(row)};
        }
    return found.depth > 0 ? std::optional(found) : std::nullopt;
}

}  // namespace contactd::geometry

#include "geometry/search/mesh_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace contactd::geometry {
namespace {

using Node = GapMesh::Node;

}  // namespace

std::vector<OverlapRegion> MeshSearch::regions(double z) {
    mesh_.look_below(z);
    std::vector<OverlapRegion> regions;
    for (const std::vector<Node>& nodes : mesh_.connected_below(z)) regions.push_back(region_of(nodes, z));
    std::stable_sort(regions.begin(), regions.end(),
                     [](const OverlapRegion& a, const OverlapRegion& b) { return a.reference.y > b.reference.y; });
    return regions;
}

// Extents are those of the lines next to the last ones that overlap.
OverlapRegion MeshSearch::region_of(const std::vector<Node>& nodes, double z) const {
    OverlapRegion region;
    ContactReference mean;
    double sum = 0;
    Node first = nodes.front(), last = first, deepest = first;
    for (const Node& node : nodes) {
        const double depth = z - mesh_.gap(node), weight = std::max(depth * depth, 1e-10);
        sum += weight;
        mean.x += weight * mesh_.x(node.column);
        mean.y += weight * mesh_.y(node.row);
        mean.angle += weight * mesh_.rows()[node.row].angle;
        if (depth > region.penetration) deepest = node;
        region.penetration = std::max(region.penetration, depth);
        first = {std::min(first.column, node.column), std::min(first.row, node.row)};
        last = {std::max(last.column, node.column), std::max(last.row, node.row)};
    }
    first = {first.column - (first.column > 0), first.row - (first.row > 0)};
    last = {std::min(last.column + 1, mesh_.columns() - 1), std::min(last.row + 1, mesh_.rows().size() - 1)};
    region.reference = {mean.x / sum, mean.y / sum, 0, mean.angle / sum};
    const auto height = [&](double y) {
        return rail_.height(region.reference.x, y, 0.5 * (rail_.visible().from + rail_.visible().to));
    };
    region.reference.z = height(region.reference.y);
    // The mean of a region around the end of a part of the rail may have no rail below it.
    if (!std::isfinite(region.reference.z)) {
        region.reference.x = mesh_.x(deepest.column);
        region.reference.y = mesh_.y(deepest.row);
        region.reference.z = height(region.reference.y);
    }
    region.x = {mesh_.x(first.column), mesh_.x(last.column)};
    region.y = {mesh_.y(first.row), mesh_.y(last.row)};
    const auto height_or = [](double z_there, double otherwise) {
        return std::isfinite(z_there) ? z_there : otherwise;
    };
    region.z = {height_or(height(region.y.from), region.reference.z),
                height_or(height(region.y.to), region.reference.z)};
    region.size = mesh_.step_x() * mesh_.step_y() * sum;
    return region;
}

template <class Visit>
void MeshSearch::for_each(double z, const RegionGroup& group, const Visit& visit) const {
    const auto& [from, to] = mesh_.looked_at();
    for (std::size_t row = from.row; row <= to.row; ++row) {
        if (mesh_.y(row) < group.y.from || mesh_.y(row) > group.y.to) continue;
        for (std::size_t column = from.column; column <= to.column; ++column) {
            if (mesh_.x(column) < group.x.from || mesh_.x(column) > group.x.to) continue;
            const Node node{column, row};
            if (mesh_.gap(node) < z) visit(node, z - mesh_.gap(node));
        }
    }
}

// The mean square of the distance over an ellipse's paraboloid is a sixth of the square of its semi-axis, and the
// volume is half of approach times area.
EquivalentEllipse MeshSearch::ellipse(double z, const RegionGroup& group) const {
    double volume = 0, x_first = 0, x_second = 0, y_first = 0, y_second = 0;
    for_each(z, group, [&](const Node& node, double depth) {
        const double ahead = mesh_.x(node.column) - group.reference.x, aside = mesh_.y(node.row) - group.reference.y;
        volume += depth;
        x_first += depth * ahead;
        x_second += depth * ahead * ahead;
        y_first += depth * aside;
        y_second += depth * aside * aside;
    });
    // A node represents its surroundings, which matters if there are few.
    const auto semi_axis = [&](double first, double second, double step) {
        const double mean = first / volume;
        return std::sqrt(6 * (second / volume - mean * mean + step * step / 12));
    };
    EquivalentEllipse ellipse;
    ellipse.along = semi_axis(x_first, x_second, mesh_.step_x());
    const double across = semi_axis(y_first, y_second, mesh_.step_y()) / std::abs(std::cos(group.reference.angle));
    ellipse.across = std::clamp(across, ellipse.along / most_slender_ellipse, ellipse.along * most_slender_ellipse);
    ellipse.approach =
        2 * volume * mesh_.step_x() * mesh_.step_y() / (std::numbers::pi * ellipse.along * ellipse.across);
    return ellipse;
}

QualityFlags MeshSearch::quality_flags(double z, const RegionGroup& group) const {
    QualityFlags flags;
    const double cosine = std::abs(std::cos(group.reference.angle));
    const std::size_t last_column = mesh_.columns() - 1, last_row = mesh_.rows().size() - 1;
    for_each(z, group, [&](const Node& node, double depth) {
        if (depth * cosine > surely_pressed)
            flags.bend = std::max(flags.bend, std::abs(mesh_.rows()[node.row].angle - group.reference.angle));
        const bool at_border = node.column == 0 || node.column == last_column || node.row == 0 || node.row == last_row;
        flags.at_end = flags.at_end || at_border || !std::isfinite(mesh_.gap({node.column, node.row - 1})) ||
                       !std::isfinite(mesh_.gap({node.column, node.row + 1}));
    });
    return flags;
}

}  // namespace contactd::geometry

#include "geometry/distance/node_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "contactd/count_of.hpp"

namespace contactd::geometry {
namespace {

constexpr double slack = 1e-9;
constexpr int most_nodes = 4'000'000;

/// Returns whether a fraction is before its side, on it or behind it: -1, 0 or 1.
int beside(double share) {
    return share < -slack ? -1 : share > 1 + slack ? 1 : 0;
}

/// Moves to the adjacent cell; returns false at the border.
bool go(std::size_t& cell, int step, std::size_t nodes) {
    if ((step < 0 && cell == 0) || (step > 0 && cell + 2 >= nodes)) return false;
    cell += static_cast<std::size_t>(step);
    return true;
}

}  // namespace

std::size_t lines_within_bound(double columns, std::size_t rows) {
    const int most = most_nodes / static_cast<int>(std::clamp<std::size_t>(rows, 1, most_nodes));
    return static_cast<std::size_t>(
        count_of(columns, {"dx", "is too small for a wheel with " + std::to_string(rows) + " points across",
                           "lines across it", "make it larger, or give the wheel fewer points", most}));
}

NodeMesh::NodeMesh(std::size_t columns, std::vector<Vector3> nodes, Between between)
    : columns_(columns), rows_(nodes.size() / columns), nodes_(std::move(nodes)), between_(between) {}

// Searches by bisection along the last row's column and row, because nodes are unevenly distributed and a walk from
// cell to cell is long.
void NodeMesh::start_at(double x, double y) {
    const auto cell = [](std::size_t count, const auto& is_before) {
        std::size_t low = 0, high = count - 1;
        while (high - low > 1) (is_before((low + high) / 2) ? low : high) = (low + high) / 2;
        return low;
    };
    row_ = cell(rows_, [&](std::size_t row) { return node(column_, row).y <= y; });
    column_ = cell(columns_, [&](std::size_t column) { return node(column, row_).x <= x; });
    row_ = cell(rows_, [&](std::size_t row) { return node(column_, row).y <= y; });
}

double NodeMesh::height(double x, double y) {
    constexpr int few = 4;
    Shares at = inside_cell(x, y);
    for (int moves = 0; beside(at.u) != 0 || beside(at.v) != 0; ++moves) {
        if (!std::isfinite(at.u + at.v) || moves > static_cast<int>(columns_ + rows_)) return no_height;
        if (moves == few) {
            start_at(x, y);
        } else {
            const bool aside = beside(at.u) != 0 && go(column_, beside(at.u), columns_);
            const bool up = beside(at.v) != 0 && go(row_, beside(at.v), rows_);
            if (!aside && !up) {
                if (moves > few) return no_height;
                moves = few - 1;
                start_at(x, y);
            }
        }
        at = inside_cell(x, y);
    }
    return std::isfinite(at.u + at.v) ? value(at) : no_height;
}

// Solves by Newton's method: x and y are bilinear between the corners.
NodeMesh::Shares NodeMesh::inside_cell(double x, double y) const {
    const Vector3 &a = node(column_, row_), &b = node(column_ + 1, row_), &c = node(column_, row_ + 1),
                  &d = node(column_ + 1, row_ + 1);
    double u = 0.5, v = 0.5;
    for (int iteration = 0; iteration < 6; ++iteration) {
        const Vector3 by_u = (1 - v) * (b - a) + v * (d - c), by_v = (1 - u) * (c - a) + u * (d - b);
        const Vector3 at = a + u * (b - a) + v * by_v;
        const double area = by_u.x * by_v.y - by_u.y * by_v.x, off_x = x - at.x, off_y = y - at.y;
        const double step_u = (off_x * by_v.y - off_y * by_v.x) / area;
        const double step_v = (by_u.x * off_y - by_u.y * off_x) / area;
        u += step_u;
        v += step_v;
        if (std::abs(step_u) + std::abs(step_v) < 1e-12) break;
    }
    return {u, v};
}

NodeMesh::Weights NodeMesh::weights(double share, std::size_t cell, std::size_t count) const {
    const double t = share;
    if (between_ == Between::straight) return {0, 1 - t, t, 0};
    const double leaving = t * (1 - t) * (1 - t), arriving = -t * t * (1 - t), end = t * t * (3 - 2 * t);
    Weights weights{0, 1 - end, end, 0};
    const bool first = cell == 0, last = cell + 2 >= count;
    const double from = first ? 1 : 0.5, to = last ? 1 : 0.5;
    weights[2] += leaving * from;
    weights[first ? 1 : 0] -= leaving * from;
    weights[last ? 2 : 3] += arriving * to;
    weights[1] -= arriving * to;
    return weights;
}

double NodeMesh::value(const Shares& at) const {
    const Weights along = weights(at.u, column_, columns_), across = weights(at.v, row_, rows_);
    double sum = 0;
    for (std::size_t j = 0; j < across.size(); ++j)
        for (std::size_t i = 0; i < along.size(); ++i)
            if (across[j] != 0 && along[i] != 0) sum += across[j] * along[i] * node(column_ + i - 1, row_ + j - 1).z;
    return sum;
}

}  // namespace contactd::geometry

#include "geometry/search/gap_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contactd/count_of.hpp"
#include "geometry/distance/heights.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

using Node = GapMesh::Node;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double part_of_radius = 0.125;  // how far to both sides
constexpr std::size_t side = 8;           // of a square, in steps
constexpr double least_dent = 0.02;       // mm: by how much a gap within a square may be less than those at its corners
constexpr double slope_dent = 0.5;        // and of the difference of these
constexpr int most_nodes = 10'000'000;    // 80 MB of gaps
constexpr double unknown_dent = 0.5;      // of the square's width, where there is a corner without wheel or rail

std::size_t squares_of(std::size_t lines) {
    return (lines - 1 + side - 1) / side;
}

}  // namespace

GapMesh::GapMesh(const WheelSurface& wheel, const RailSurface& rail, double step_x, double step_y,
                 const Observer& observer)
    : wheel_(wheel), rail_(rail), observer_(observer), step_x_(step_x), step_y_(step_y), least_gap_(infinite) {
    const Span& seen = rail.visible();
    const double beside = std::ceil(part_of_radius * wheel.nominal_radius() / step_x);
    const double nodes = (2 * beside + 1) * ((seen.high - seen.low) / step_y + 1);
    count_of(nodes, {"dx", "and dy make steps of " + number_text(step_x) + " and " + number_text(step_y) + " mm",
                     "nodes along a wheel and a rail of these sizes", "make them larger", most_nodes});
    const auto half = static_cast<std::size_t>(beside);
    columns_ = 2 * half + 1;
    first_x_ = -static_cast<double>(half) * step_x;
    const auto count = std::max<std::size_t>(2, static_cast<std::size_t>((seen.high - seen.low) / step_y) + 1);
    double s = seen.from;
    for (std::size_t i = 0; i < count; ++i) {
        const double y = std::min(seen.low + static_cast<double>(i) * step_y, seen.high);
        rail.find_y(y, s);
        const auto place = rail.place(s);
        rows_.push_back({y, place.at.z, std::atan2(place.slope.z, place.slope.y)});
    }
    gaps_.assign(columns_ * count, infinite);
    done_.assign(squares_of(columns_) * squares_of(count), false);
    look_at({{0, 0}, {columns_ - 1, count - 1}}, side);
    if (least_gap_ < infinite) look_below(least_gap_);
}

GapMesh::Square GapMesh::square(std::size_t column, std::size_t row) const {
    return {{column * side, row * side},
            {std::min((column + 1) * side, columns_ - 1), std::min((row + 1) * side, rows_.size() - 1)}};
}

// The last lines are looked at whatever `every` leaves out.
void GapMesh::look_at(const Square& square, std::size_t every) {
    const ContactReference plane{0, 0.5 * (rail_.visible().low + rail_.visible().high), 0, 0};
    const auto& [from, to] = square;
    const auto next = [every](std::size_t line, std::size_t last) {
        return line < last ? std::min(line + every, last) : line + 1;
    };
    for (std::size_t row = from.row; row <= to.row; row = next(row, to.row)) {
        observer_.throw_if_cancelled();
        const double y = rows_[row].y - plane.y;
        const auto look = [&](std::size_t first, std::size_t count, std::size_t step) {
            const double dx = static_cast<double>(step) * step_x_;
            const Grid grid{static_cast<int>(count), 1, dx, 1, x(first) - 0.5 * dx, y - 0.5};
            const std::vector<double> wheel = wheel_heights(wheel_, plane, grid);
            for (std::size_t i = 0; i < count; ++i) {
                const Node node{first + i * step, row};
                const double gap = rail_.z_at(x(node.column), rows_[row].y, rows_[row].rail_z) - wheel[i];
                gaps_[index(node)] = std::isnan(gap) ? infinite : gap;
                least_gap_ = std::min(least_gap_, gaps_[index(node)]);
            }
        };
        const std::size_t count = (to.column - from.column) / every + 1;
        look(from.column, count, every);
        if (from.column + (count - 1) * every < to.column) look(to.column, 1, 1);
    }
}

bool GapMesh::may_be_below(const Square& square, double height) const {
    const auto& [from, to] = square;
    double least = infinite, largest = -infinite;
    bool known = true;
    for (const Node& corner : {from, Node{to.column, from.row}, Node{from.column, to.row}, to}) {
        const double gap = gaps_[index(corner)];
        known = known && gap < infinite;
        least = std::min(least, gap);
        if (gap < infinite) largest = std::max(largest, gap);
    }
    // An edge of an out-of-round wheel, midway, may lie deeper by what both sides of it rise.
    const double edge = 0.5 * wheel_.steepest() * static_cast<double>(side) * step_x_;
    double dent = least_dent + edge + (least < infinite ? slope_dent * (largest - least) : 0);
    if (!known) dent += unknown_dent * static_cast<double>(side) * std::max(step_x_, step_y_);
    return least - dent <= height;
}

void GapMesh::look_below(double height) {
    const std::size_t across = squares_of(columns_);
    for (std::size_t k = 0; k < done_.size(); ++k) {
        if (done_[k]) continue;
        const Square here = square(k % across, k / across);
        if (!may_be_below(here, height)) continue;
        done_[k] = true;
        look_at(here, 1);
    }
}

std::vector<std::vector<Node>> GapMesh::connected_below(double z) const {
    std::vector<std::vector<Node>> parts;
    std::vector<bool> seen(gaps_.size());
    for (std::size_t i = gaps_.size(); i-- > 0;)
        if (gaps_[i] < z && !seen[i]) parts.push_back(spread({i % columns_, i / columns_}, z, seen));
    return parts;
}

std::vector<Node> GapMesh::spread(const Node& start, double z, std::vector<bool>& seen) const {
    std::vector<Node> nodes{start};
    seen[index(start)] = true;
    for (std::size_t done = 0; done < nodes.size(); ++done) {
        const Node node = nodes[done];
        const std::size_t last_column = std::min(node.column + 1, columns_ - 1);
        const std::size_t last_row = std::min(node.row + 1, rows_.size() - 1);
        for (std::size_t row = node.row - (node.row > 0); row <= last_row; ++row)
            for (std::size_t column = node.column - (node.column > 0); column <= last_column; ++column) {
                const Node beside{column, row};
                if (seen[index(beside)] || !(gap(beside) < z)) continue;
                seen[index(beside)] = true;
                nodes.push_back(beside);
            }
    }
    return nodes;
}

}  // namespace contactd::geometry

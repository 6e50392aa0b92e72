#include "geometry/search/gap_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contactd/count_of.hpp"
#include "geometry/distance/heights.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

using Node = GapMesh::Node;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double part_of_radius = 0.125;  // extent to both sides of the wheel's middle
constexpr double steepest_flange = 4;     // slope that determines how far contacts lead and trail by yaw
constexpr std::size_t side = 8;           // of a square, in steps
// A gap within a square may be less than those at its corners by this much (mm).
constexpr double least_dent = 0.02;
constexpr double coarsely_settled = 1e-3;  // mm: error of gaps at corners, small compared with least_dent
constexpr double slope_dent = 0.5;         // additional part of the difference of gaps at corners
constexpr int most_nodes = 10'000'000;     // 80 MB of gaps
constexpr double unknown_dent = 0.5;       // in widths of the square, if there is a corner without wheel or rail

void check_nodes(double nodes, double step_x, double step_y) {
    count_of(nodes, {"dx", "and dy result in steps of " + number_text(step_x) + " and " + number_text(step_y) + " mm",
                     "nodes along a wheel and a rail of these sizes", "increase them", most_nodes});
}

std::size_t squares_of(std::size_t lines) {
    return (lines - 1 + side - 1) / side;
}

}  // namespace

// The middle of a yawed wheel lies ahead of the axle's or behind it, and its flange touches farther ahead or behind.
double reach_along(const WheelSurface& wheel) {
    const Frame& axes = wheel.frame();
    const double yawed = std::abs(axes.outside({0, 1, 0}).x - axes.outside({0, 0, 0}).x);
    return (part_of_radius + std::max(0.0, steepest_flange * yawed - 0.5 * part_of_radius)) * wheel.nominal_radius();
}

GapMesh::GapMesh(const WheelSurface& wheel, const RailSurface& rail, double step_x, double step_y,
                 const Observer& observer)
    : GapMesh(wheel, rail, lines_around(wheel, rail, step_x, step_y), std::nullopt, observer) {}

GapMesh::GapMesh(const WheelSurface& wheel, const RailSurface& rail, NodeMesh nodes, double step_y,
                 const Observer& observer)
    : GapMesh{wheel, rail, lines_of(nodes, rail, step_y), std::optional(std::move(nodes)), observer} {}  // in order

GapMesh::Lines GapMesh::lines_around(const WheelSurface& wheel, const RailSurface& rail, double step_x, double step_y) {
    const Span& seen = rail.visible();
    const double beside = std::ceil(reach_along(wheel) / step_x);
    const double middle = step_x * std::round(wheel.profile_origin().x / step_x);
    check_nodes((2 * beside + 1) * ((seen.high - seen.low) / step_y + 1), step_x, step_y);
    const auto half = static_cast<std::size_t>(beside);
    return {middle - static_cast<double>(half) * step_x, step_x, 2 * half + 1, seen.low, seen.high, step_y};
}

GapMesh::Lines GapMesh::lines_of(const NodeMesh& nodes, const RailSurface& rail, double step_y) {
    double from = infinite, to = -infinite;
    for (std::size_t row = 0; row < nodes.rows(); ++row)
        for (std::size_t column = 0; column < nodes.columns(); ++column) {
            from = std::min(from, nodes.node(column, row).x);
            to = std::max(to, nodes.node(column, row).x);
        }
    const double step_x = (to - from) / static_cast<double>(nodes.columns() - 1);
    const Span& seen = rail.visible();
    const std::vector<double>& knots = rail.profile().knots();
    const std::size_t third = std::min<std::size_t>(2, knots.size() - 1);
    const double first = rail.place(knots[third]).at.y, last = rail.place(knots[knots.size() - 1 - third]).at.y;
    const double first_y = first + step_y * std::max(0.0, std::ceil((seen.low - first) / step_y));
    check_nodes(static_cast<double>(nodes.columns()) * ((seen.high - seen.low) / step_y + 1), step_x, step_y);
    return {from, step_x, nodes.columns(), first_y, std::min(last, seen.high), step_y};
}

GapMesh::GapMesh(const WheelSurface& wheel, const RailSurface& rail, const Lines& lines, std::optional<NodeMesh> nodes,
                 const Observer& observer)
    : wheel_(wheel),
      rail_(rail),
      observer_(observer),
      step_x_(lines.step_x),
      step_y_(lines.step_y),
      first_x_(lines.first_x),
      columns_(lines.columns),
      nodes_(std::move(nodes)),
      least_gap_(infinite) {
    constexpr double rounding = 1e-6;  // of a step
    const double steps = std::max(0.0, (lines.last_y - lines.first_y) / lines.step_y + rounding);
    const auto count = std::max<std::size_t>(2, static_cast<std::size_t>(steps) + 1);
    double s = rail.visible().from;
    for (std::size_t i = 0; i < count; ++i) {
        const double y = std::min(lines.first_y + static_cast<double>(i) * lines.step_y, rail.visible().high);
        rail.find_y(y, s);
        const auto place = rail.place(s);
        rows_.push_back({y, place.at.z, std::atan2(place.slope.z, place.slope.y)});
    }
    gaps_.assign(columns_ * count, infinite);
    const double least = look_at({{0, 0}, {columns_ - 1, count - 1}}, side, coarsely_settled);
    const std::size_t across = squares_of(columns_), along = squares_of(count);
    for (std::size_t k = 0; k < across * along; ++k) floors_.push_back(floor_of(square(k % across, k / across)));
    if (!(least < infinite)) return;
    look_below(least + coarsely_settled);
    look_below(least_gap_);
}

GapMesh::Square GapMesh::square(std::size_t column, std::size_t row) const {
    return {{column * side, row * side},
            {std::min((column + 1) * side, columns_ - 1), std::min((row + 1) * side, rows_.size() - 1)}};
}

// The last lines are always evaluated, whatever `every` skips.
double GapMesh::look_at(const Square& square, std::size_t every, double settled) {
    observer_.throw_if_cancelled();
    const ContactReference plane{0, 0.5 * (rail_.visible().low + rail_.visible().high), 0, 0};
    const auto& [from, to] = square;
    std::vector<std::size_t> rows;
    for (std::size_t row = from.row; row < to.row; row += every) rows.push_back(row);
    rows.push_back(to.row);
    std::vector<double> y;
    for (const std::size_t row : rows) y.push_back(rows_[row].y - plane.y);
    double least = infinite;
    const auto look = [&](std::size_t first, std::size_t count, std::size_t step) {
        const double dx = static_cast<double>(step) * step_x_;
        const Grid columns{static_cast<int>(count), 1, dx, step_y_, x(first) - 0.5 * dx, 0};
        const std::vector<double> wheel = wheel_heights_at(plane, columns, y, settled);
        for (std::size_t j = 0; j < rows.size(); ++j)
            for (std::size_t i = 0; i < count; ++i) {
                const Node node{first + i * step, rows[j]};
                const GapMesh::Row& row = rows_[node.row];
                const double gap = rail_.z_at(x(node.column), row.y, row.rail_z) - wheel[j * count + i];
                gaps_[index(node)] = std::isnan(gap) ? infinite : gap;
                least = std::min(least, gaps_[index(node)]);
            }
    };
    const std::size_t count = (to.column - from.column) / every + 1;
    look(from.column, count, every);
    if (from.column + (count - 1) * every < to.column) look(to.column, 1, 1);
    return least;
}

std::vector<double> GapMesh::wheel_heights_at(const ContactReference& plane, const Grid& columns, std::vector<double> y,
                                              double settled) {
    if (!nodes_) return wheel_heights(wheel_, plane, {columns, std::move(y)}, settled);
    std::vector<double> heights;
    for (const double row : y)
        for (int i = 0; i < columns.nx; ++i) heights.push_back(nodes_->height(columns.x(i), plane.y + row));
    return heights;
}

double GapMesh::floor_of(const Square& square) const {
    const auto& [from, to] = square;
    double least = infinite, largest = -infinite;
    bool known = true;
    for (const Node& corner : {from, Node{to.column, from.row}, Node{from.column, to.row}, to}) {
        const double gap = gaps_[index(corner)];
        known = known && gap < infinite;
        least = std::min(least, gap);
        if (gap < infinite) largest = std::max(largest, gap);
    }
    // An edge of an out-of-round wheel, midway, may lie deeper by the rise of both sides of it.
    const double edge = 0.5 * wheel_.steepest() * static_cast<double>(side) * step_x_;
    double dent = least_dent + edge + (least < infinite ? slope_dent * (largest - least) : 0);
    if (!known) dent += unknown_dent * static_cast<double>(side) * std::max(step_x_, step_y_);
    return least - dent;
}

// Adjacent squares are evaluated together, because a wheel is smooth along a row.
void GapMesh::look_below(double height) {
    constexpr double done = infinite, settled = 1e-8;  // mm: the neglected part of a circle is a thousand times less
    const std::size_t across = squares_of(columns_);
    for (std::size_t k = 0; k < floors_.size();) {
        if (!(floors_[k] <= height)) {
            ++k;
            continue;
        }
        const Square first = square(k % across, k / across);
        Square last = first;
        const std::size_t end_of_row = (k / across + 1) * across;
        for (; k < end_of_row && floors_[k] <= height; ++k) {
            floors_[k] = done;
            last = square(k % across, k / across);
        }
        least_gap_ = std::min(least_gap_, look_at({first.from, last.to}, 1, settled));
        looked_at_.from = {std::min(looked_at_.from.column, first.from.column),
                           std::min(looked_at_.from.row, first.from.row)};
        looked_at_.to = {std::max(looked_at_.to.column, last.to.column), std::max(looked_at_.to.row, last.to.row)};
    }
}

std::vector<std::vector<Node>> GapMesh::connected_below(double z) const {
    std::vector<std::vector<Node>> parts;
    std::vector<bool> seen(gaps_.size());
    if (looked_at_.from.row > looked_at_.to.row) return parts;
    for (std::size_t row = looked_at_.to.row + 1; row-- > looked_at_.from.row;)
        for (std::size_t column = looked_at_.to.column + 1; column-- > looked_at_.from.column;) {
            const std::size_t i = index({column, row});
            if (gaps_[i] < z && !seen[i]) parts.push_back(spread({column, row}, z, seen));
        }
    if (nodes_) join_boxes(parts);
    return parts;
}

void GapMesh::join_boxes(std::vector<std::vector<Node>>& parts) const {
    const auto box_of = [](const std::vector<Node>& nodes) {
        Square box{nodes.front(), nodes.front()};
        for (const Node& node : nodes) {
            box.from = {std::min(box.from.column, node.column), std::min(box.from.row, node.row)};
            box.to = {std::max(box.to.column, node.column), std::max(box.to.row, node.row)};
        }
        return box;
    };
    for (std::size_t i = 0; i < parts.size();) {
        const auto [from, to] = box_of(parts[i]);
        const auto is_near = [&from = from, &to = to](const Node& node) {
            return node.column + 1 >= from.column && node.column <= to.column + 1 && node.row + 1 >= from.row &&
                   node.row <= to.row + 1;
        };
        const auto other = std::find_if(parts.begin(), parts.end(), [&](const std::vector<Node>& part) {
            return &part != &parts[i] && std::ranges::any_of(part, is_near);
        });
        if (other == parts.end()) {
            ++i;
            continue;
        }
        parts[i].insert(parts[i].end(), other->begin(), other->end());
        if (other - parts.begin() < static_cast<std::ptrdiff_t>(i)) --i;
        parts.erase(other);
    }
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

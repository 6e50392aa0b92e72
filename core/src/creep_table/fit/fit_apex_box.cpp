#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "creep_table/contraction.hpp"
#include "creep_table/fit/fit_spline.hpp"
#include "creep_table/fit/node_arrays.hpp"
#include "creep_table/spline_fit.hpp"

namespace contactd::creep_table {
namespace {

constexpr double rounding = 1e-12;

bool is_at_end(const SplineAxis& box, const SplineAxis& table, bool last) {
    const double distance = last ? table.to - box.to : box.from - table.from;
    return distance <= rounding * (table.to - table.from);
}

/// States the end of a box on one axis for one component. The value is zero there if it lies inside the table.
SplineEnd end_of(const TableAxes& box, const CreepGrid& grid, int axis, bool last, int component) {
    if (!is_at_end(box[axis], grid.axes[axis], last)) return SplineEnd::slope;
    if (axis == log_ratio) return SplineEnd::not_a_knot;
    return component == 0 ? SplineEnd::odd : SplineEnd::even;  // z_b = pi/2, where X changes its sign
}

/// Identifies a node of the box.
struct Node {
    std::array<int, axis_count> index{};
    std::array<double, axis_count> point{};

    Node(const TableAxes& box, std::size_t number) {
        for (int axis = axis_count - 1; axis >= 0; --axis) {
            index[axis] = static_cast<int>(number % nodes_of(box[axis]));
            point[axis] = box[axis].node(index[axis]);
            number /= nodes_of(box[axis]);
        }
    }
};

bool vanishes_at(const Node& node, const TableAxes& box, const CreepGrid& grid, int component) {
    for (int axis = 0; axis < axis_count; ++axis)
        for (const bool last : {false, true}) {
            const SplineEnd end = end_of(box, grid, axis, last, component);
            const bool is_zero = end == SplineEnd::slope || end == SplineEnd::odd;
            if (is_zero && node.index[axis] == (last ? box[axis].cells : 0)) return true;
        }
    return false;
}

}  // namespace

std::optional<TableAxes> apex_box(const CreepGrid& grid) {
    const auto& [ratios, angles_a, angles_b, lengths] = grid.axes;
    const auto part = [](const SplineAxis& whole, int from, int to, int halved) {
        return SplineAxis{whole.node(from), whole.node(to), (1 + halved) * (to - from)};
    };
    const int first = std::max(0, static_cast<int>(std::floor((std::log(2) - ratios.from) / ratios.step() + 1e-9)));
    const int side = angles_a.cells / 4;
    if (ratios.cells - first < 4) return std::nullopt;
    return TableAxes{part(ratios, first, ratios.cells, 0), part(angles_a, side, angles_a.cells - side, 1),
                     part(angles_b, 5 * angles_b.cells / 8, angles_b.cells, 1),
                     part(lengths, 3 * lengths.cells / 8, (11 * lengths.cells + 15) / 16, 1)};
}

bool is_inside(const TableAxes& box, const CreepGrid& grid) {
    for (int axis = 0; axis < axis_count; ++axis) {
        const SplineAxis &inner = box[axis], &outer = grid.axes[axis];
        const double slack = rounding * (outer.to - outer.from);
        if (!(inner.from >= outer.from - slack && inner.to <= outer.to + slack && inner.from < inner.to)) return false;
        const bool may_touch_first = axis == log_ratio, may_touch_last = axis == log_ratio || axis == z_b;
        if (!may_touch_first && is_at_end(inner, outer, false)) return false;
        if (!may_touch_last && is_at_end(inner, outer, true)) return false;
    }
    return true;
}

std::vector<float> fit_apex_box(const CreepGrid& grid, std::span<const float> spline, const TableAxes& box,
                                std::span<const double> forces) {
    if (!is_inside(box, grid))
        throw InvalidArgument("box", "must lie inside the table; only z_b may reach its last end, and a/b both ends");
    std::size_t count = 1;
    for (const SplineAxis& axis : box) count *= nodes_of(axis);
    require_node_values(forces.size(), 3 * count);
    std::array<Values, 3> rest;
    for (std::size_t k = 0; k < count; ++k) {
        const Node node(box, k);
        SplineSums sums;
        add_spline(grid.axes, spline.data(), node.point, sums);
        for (int c = 0; c < 3; ++c)
            rest[c].push_back(vanishes_at(node, box, grid, c) ? 0 : forces[3 * k + c] - double{sums.value[c]});
    }
    for (int c = 0; c < 3; ++c) {
        std::size_t after = 1;
        for (int axis = axis_count - 1; axis >= 0; --axis) {
            const SplineEnd first = end_of(box, grid, axis, false, c), last = end_of(box, grid, axis, true, c);
            rest[c] = multiply_along(spline_fit(box[axis].cells, first, last),
                                     with_zero_ends(rest[c], box[axis].cells + 1, after), after);
            after *= static_cast<std::size_t>(box[axis].coefficients());
        }
    }
    return interleaved(rest);
}

}  // namespace contactd::creep_table

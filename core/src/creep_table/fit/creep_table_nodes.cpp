#include "contactd/creep_table_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

#include "creep_table/creep_curves.hpp"
#include "creep_table/file/table_file.hpp"
#include "creep_table/fit/fit_spline.hpp"
#include "creep_table/fit/node_arrays.hpp"
#include "creep_table/open_table.hpp"

namespace contactd {
namespace {

using namespace creep_table;

constexpr int curve_cells = 64;  // of the scales, which are smooth in log(a/b)

CreepGrid grid_of(const CreepTablePlan& plan) {
    for (const int count : plan.cells)
        if (count < 4 || count > 512)
            throw InvalidArgument("cells", "has " + std::to_string(count) + "; each axis has 4 to 512 cells");
    const auto [from, to] = plan.ratios;
    if (!(from >= 1.0 / 32 && from < to && to <= 32))
        throw InvalidArgument("ratios", "must ascend and lie between 1/32 and 32");
    return creep_grid(from, to, plan.cells);
}

using Index = std::array<int, axis_count>;

/// Refers to the nodes of a spline whose forces are solved: from the first to the last on each axis.
struct SolvedNodes {
    TableAxes axes;
    Index first, last;

    int count(int axis) const { return last[axis] - first[axis] + 1; }
    int rows() const { return count(log_ratio) * count(z_a); }

    /// Calls use(index) for each node of a row.
    template <class Use>
    void for_each(int row, const Use& use) const {
        const int ratio = first[log_ratio] + row / count(z_a), angle = first[z_a] + row % count(z_a);
        const bool is_pole = angle == 0 || angle == axes[z_a].cells;
        for (int j = first[z_b]; j <= (is_pole ? first[z_b] : last[z_b]); ++j)
            for (int k = first[u]; k <= last[u]; ++k) use(Index{ratio, angle, j, k});
    }

    void add_counts(std::vector<int>& counts) const {
        for (int row = 0; row < rows(); ++row) {
            counts.push_back(0);
            for_each(row, [&](const Index&) { ++counts.back(); });
        }
    }

    /// Takes the forces of these nodes from the beginning of `forces`, and returns the array of a fit, which has
    /// `lengths` values of u from `from` on. It is zero at other nodes.
    std::vector<double> array(std::span<const double>& forces, int from, std::size_t lengths) const {
        std::vector<double> nodes(3 * nodes_of(axes[log_ratio]) * nodes_of(axes[z_a]) * nodes_of(axes[z_b]) * lengths);
        for (int row = 0; row < rows(); ++row)
            for_each(row, [&](const Index& index) {
                const std::size_t angle = index[log_ratio] * nodes_of(axes[z_a]) + index[z_a];
                const std::size_t node = (angle * nodes_of(axes[z_b]) + index[z_b]) * lengths + (index[u] - from);
                std::copy_n(forces.begin(), 3, nodes.begin() + static_cast<std::ptrdiff_t>(3 * node));
                forces = forces.subspan(3);
            });
        return nodes;
    }
};

SolvedNodes of_table(const CreepGrid& grid) {
    const auto& [ratios, angles_a, angles_b, lengths] = grid.axes;
    return {grid.axes, {0, 0, 0, 1}, {ratios.cells, angles_a.cells, angles_b.cells, lengths.cells - 1}};
}

/// Without the faces inside the table, where the box vanishes.
SolvedNodes of_box(const TableAxes& box, const CreepGrid& grid) {
    const bool is_at_end = box[log_ratio].from == grid.axes[log_ratio].from;
    return {box,
            {is_at_end ? 0 : 1, 1, 1, 1},
            {box[log_ratio].cells, box[z_a].cells - 1, box[z_b].cells, box[u].cells - 1}};
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

std::vector<int> creep_table_rows(const CreepTablePlan& plan) {
    const CreepGrid grid = grid_of(plan);
    std::vector<int> counts;
    of_table(grid).add_counts(counts);
    if (const std::optional<TableAxes> box = apex_box(grid)) of_box(*box, grid).add_counts(counts);
    return counts;
}

CreepTableRow creep_table_row(const CreepTablePlan& plan, double nu, int row) {
    const std::size_t rows = creep_table_rows(plan).size();
    if (row < 0 || static_cast<std::size_t>(row) >= rows)
        throw InvalidArgument("row", "is " + std::to_string(row) + "; this table has " + std::to_string(rows));
    const CreepGrid grid = grid_of(plan);
    SolvedNodes nodes = of_table(grid);
    if (row >= nodes.rows()) {
        row -= nodes.rows();
        nodes = of_box(*apex_box(grid), grid);
    }
    CreepTableRow result;
    nodes.for_each(row, [&](const Index& index) {
        std::array<double, axis_count> point{};
        for (int axis = 0; axis < axis_count; ++axis) point[axis] = nodes.axes[axis].node(index[axis]);
        result.a_over_b = std::exp(point[log_ratio]);
        const Triple w = creepages_at(grid, nu, point);
        result.creepages.insert(result.creepages.end(), w.begin(), w.end());
    });
    return result;
}

std::vector<double> creep_table_creepages(const CreepTablePlan& plan, double nu, std::span<const double> points) {
    const CreepGrid grid = grid_of(plan);
    std::vector<double> creepages;
    for (; points.size() >= 4; points = points.subspan(4)) {
        const Triple w = creepages_at(grid, nu, {points[0], points[1], points[2], points[3]});
        creepages.insert(creepages.end(), w.begin(), w.end());
    }
    return creepages;
}

void write_creep_table(const std::filesystem::path& path, const CreepTablePlan& plan, std::span<const double> forces,
                       std::string_view description) {
    CreepFile file;
    file.grid = grid_of(plan);
    file.box = apex_box(file.grid);
    file.nu = plan.nu;
    file.curve_cells = curve_cells;
    file.description = description;
    const SolvedNodes table = of_table(file.grid), box = file.box ? of_box(*file.box, file.grid) : SolvedNodes{};
    const std::vector<int> counts = creep_table_rows(plan);
    require_node_values(forces.size(),
                        3 * plan.nu.size() * std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
    std::vector<double> curves;
    std::vector<float> coefficients, box_coefficients;
    for (const double nu : plan.nu) {
        const auto fitted = fit_creep_spline(file.grid, nu, table.array(forces, 1, nodes_of(table.axes[u]) - 2));
        if (file.box)
            append(box_coefficients,
                   fit_apex_box(file.grid, fitted, box.axes, box.array(forces, 0, nodes_of(box.axes[u]))));
        append(coefficients, fitted);
        append(curves, creep_curves(file.curve_axis(), nu));
    }
    file.curves = curves;
    file.coefficients = coefficients;
    file.box_coefficients = box_coefficients;
    write_creep_file(path, file);
}

void certify_creep_table(const std::filesystem::path& path, const std::array<int, 4>& cells,
                         std::span<const float> bounds, std::string_view description) {
    const CreepTable::Contents contents(path, std::nullopt);
    CreepFile file = contents.file;
    file.bound_cells = cells;
    file.bounds = bounds;
    file.description = description;
    write_creep_file(path, file);
}

}  // namespace contactd

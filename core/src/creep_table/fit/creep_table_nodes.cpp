#include "contactd/creep_table_nodes.hpp"

#include <cmath>
#include <string>

#include "creep_table/creep_curves.hpp"
#include "creep_table/file/table_file.hpp"
#include "creep_table/fit/fit_spline.hpp"
#include "creep_table/fit/node_arrays.hpp"

namespace contactd {
namespace {

using namespace creep_table;

constexpr int curve_cells = 64;  // of the scales, which are smooth in log(a/b)

CreepGrid grid_of(const CreepTablePlan& plan) {
    for (const int count : plan.cells)
        if (count < 4 || count > 1024)
            throw InvalidArgument("cells", "has " + std::to_string(count) + "; each axis has 4 to 1024 cells");
    const auto [from, to] = plan.ratios;
    if (!(from >= 1.0 / 32 && from < to && to <= 32))
        throw InvalidArgument("ratios", "must ascend and lie between 1/32 and 32");
    return creep_grid(from, to, plan.cells);
}

void require_node(const char* field, int index, const SplineAxis& axis) {
    if (index < 0 || index > axis.cells)
        throw InvalidArgument(
            field, "is " + std::to_string(index) + "; it must lie between 0 and " + std::to_string(axis.cells));
}

}  // namespace

double creep_table_ratio(const CreepTablePlan& plan, int ratio) {
    const SplineAxis axis = grid_of(plan).axes[log_ratio];
    require_node("ratio", ratio, axis);
    return std::exp(axis.node(ratio));
}

std::vector<double> creep_table_creepages(const CreepTablePlan& plan, double nu, int ratio, int angle) {
    const CreepGrid grid = grid_of(plan);
    const auto& [ratios, angles_a, angles_b, lengths] = grid.axes;
    require_node("ratio", ratio, ratios);
    require_node("angle", angle, angles_a);
    const bool is_pole = angle == 0 || angle == angles_a.cells;
    std::vector<double> creepages;
    for (int j = 0; j <= angles_b.cells; ++j)
        for (int k = 1; k < lengths.cells; ++k) {
            const Triple w = creepages_at(
                grid, nu, {ratios.node(ratio), angles_a.node(angle), angles_b.node(is_pole ? 0 : j), lengths.node(k)});
            creepages.insert(creepages.end(), w.begin(), w.end());
        }
    return creepages;
}

void write_creep_table(const std::filesystem::path& path, const CreepTablePlan& plan, std::span<const double> forces,
                       std::string_view description) {
    CreepFile file;
    file.grid = grid_of(plan);
    file.nu = plan.nu;
    file.curve_cells = curve_cells;
    file.description = description;
    const std::size_t of_nu = node_values(file.grid);
    require_node_values(forces.size(), of_nu * plan.nu.size());
    std::vector<double> curves;
    std::vector<float> coefficients;
    for (const double nu : plan.nu) {
        const std::vector<float> fitted = fit_creep_spline(file.grid, nu, forces.first(of_nu));
        const std::vector<double> scales = creep_curves(file.curve_axis(), nu);
        coefficients.insert(coefficients.end(), fitted.begin(), fitted.end());
        curves.insert(curves.end(), scales.begin(), scales.end());
        forces = forces.subspan(of_nu);
    }
    file.curves = curves;
    file.coefficients = coefficients;
    write_creep_file(path, file);
}

}  // namespace contactd

// Invents smooth creep forces with the limits and symmetries of the full theory, and makes tables of them.
#pragma once

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "closed_forms/kalker_coefficients.hpp"
#include "creep_table/creep_curves.hpp"
#include "creep_table/evaluate.hpp"
#include "creep_table/fit/fit_spline.hpp"

namespace contactd::creep_table {

/// Returns (C w + rho^2 F_inf)/(1 + rho)^2.
inline Triple blended_forces(double a_over_b, double nu, const Triple& w) {
    const Triple scale = full_slip(a_over_b, nu);
    const double rho = std::hypot(w[0] / scale[0], w[1] / scale[1], w[2] / scale[2]);
    if (rho == 0) return {};
    const KalkerCoefficients C = kalker_coefficients(a_over_b, nu);
    const auto matrix = creepage_matrix(C.C11, C.C22, C.C23, C.C33);
    const Triple limit = forces_at_infinite_creepage(a_over_b, w);
    Triple forces{};
    for (int i = 0; i < 3; ++i) {
        const double linear = matrix[i][0] * w[0] + matrix[i][1] * w[1] + matrix[i][2] * w[2];
        forces[i] = (linear + rho * rho * limit[i]) / ((1 + rho) * (1 + rho));
    }
    return forces;
}

/// Calls use(point) for each node of some axes in the order of an array. Ends of the last axis are left out if
/// requested.
template <class Use>
void for_each_node(const TableAxes& axes, int left_out, Use use) {
    for (int i = 0; i <= axes[0].cells; ++i)
        for (int j = 0; j <= axes[1].cells; ++j)
            for (int k = 0; k <= axes[2].cells; ++k)
                for (int l = left_out; l <= axes[3].cells - left_out; ++l)
                    use(std::array<double, 4>{axes[0].node(i), axes[1].node(j), axes[2].node(k), axes[3].node(l)});
}

inline std::vector<double> blended_nodes(const CreepGrid& grid, const TableAxes& axes, int left_out, double nu) {
    std::vector<double> nodes;
    for_each_node(axes, left_out, [&](const std::array<double, 4>& point) {
        const Triple forces = blended_forces(std::exp(point[0]), nu, creepages_at(grid, nu, point));
        nodes.insert(nodes.end(), forces.begin(), forces.end());
    });
    return nodes;
}

/// Owns the arrays of a table of blended forces.
struct BlendedTable {
    CreepGrid grid = creep_grid(0.5, 3, {6, 12, 8, 12});
    double nu = 0.28;
    std::vector<double> nodes = blended_nodes(grid, grid.axes, 1, nu);
    std::vector<float> coefficients = fit_creep_spline(grid, nu, nodes);
    SplineAxis curve_axis{grid.axes[0].from, grid.axes[0].to, 16};
    std::vector<double> curves = creep_curves(curve_axis, nu);

    CreepSpline spline() const {
        CreepSpline result;
        result.grid = grid;
        result.curve_axis = curve_axis;
        result.curves = curves;
        result.coefficients = coefficients;
        return result;
    }
};

inline const BlendedTable& blended_table() {
    static const BlendedTable table;
    return table;
}

/// Draws log(a/b) and creepages in units of mu Fn/(G c^2).
struct RandomStates {
    std::mt19937 engine{7};

    double uniform(double from, double to) { return from + (to - from) * static_cast<double>(engine()) / 4294967296.0; }
    double log_ratio() { return uniform(std::log(0.51), std::log(2.95)); }
    Triple creepages() {
        const double size = std::exp(uniform(std::log(0.02), std::log(5.0)));
        return {size * uniform(-1, 1), size * uniform(-1, 1), size * uniform(-1, 1)};
    }
};

}  // namespace contactd::creep_table

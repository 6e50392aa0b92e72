#include "fit_spline.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "closed_forms/kalker_coefficients.hpp"
#include "creep_table/creep_curves.hpp"
#include "creep_table/fit/node_arrays.hpp"
#include "creep_table/spline_fit.hpp"

namespace contactd::creep_table {
namespace {

using enum SplineEnd;

/// The sign of each component when Y and S change theirs.
constexpr Triple mirrored{1, -1, -1};

// Returns data of splines in u at all angles of one a/b, for each component of shape [z_a + 1, z_b + 1, u + 3].
std::array<Values, 3> data_along_u(const CreepGrid& grid, double nu, double log_a_over_b, const double* forces) {
    const double ratio = std::exp(log_a_over_b);
    const Triple scale = full_slip(ratio, nu);
    const KalkerCoefficients C = kalker_coefficients(ratio, nu);
    const auto matrix = creepage_matrix(C.C11, C.C22, C.C23, C.C33);
    const double rho_per_cell = std::numbers::pi / 4 * grid.axes[u].step();
    std::array<Values, 3> data;
    for (int i = 0; i <= grid.axes[z_a].cells; ++i)
        for (int j = 0; j <= grid.axes[z_b].cells; ++j) {
            Triple w = scaled_direction(grid, log_a_over_b, grid.axes[z_a].node(i), grid.axes[z_b].node(j));
            for (int c = 0; c < 3; ++c) w[c] *= scale[c];
            const Triple limit = forces_at_infinite_creepage(ratio, w);
            for (int c = 0; c < 3; ++c) {
                const double by_rho = matrix[c][0] * w[0] + matrix[c][1] * w[1] + matrix[c][2] * w[2];
                data[c].insert(data[c].end(), {rho_per_cell * by_rho, 0});
                for (int k = 1; k < grid.axes[u].cells; ++k) data[c].push_back(forces[3 * (k - 1) + c]);
                data[c].insert(data[c].end(), {limit[c], 0});
            }
            forces += 3 * (grid.axes[u].cells - 1);
        }
    return data;
}

// Makes the poles of the angles single-valued and opposite to each other. Values have the shape [z_a + 1, z_b + 1,
// rest].
void join_poles(Values& values, int cells_a, std::size_t nodes_b) {
    const std::size_t row = values.size() / (cells_a + 1), rest = row / nodes_b;
    double *const first = values.data(), *const last = first + cells_a * row;
    for (std::size_t k = 0; k < rest; ++k) {
        const double value = (first[k] - last[k]) / 2;
        for (std::size_t j = 0; j < nodes_b; ++j) {
            first[j * rest + k] = value;
            last[j * rest + k] = -value;
        }
    }
}

// Returns coefficients in z_b. Beyond z_b = 0, the function continues at pi - z_a, so its parts that are even and odd
// about z_a = pi/2 have different ends there.
Values fit_along_z_b(const Values& values, int cells_a, int cells_b, int component) {
    const std::size_t row = values.size() / (cells_a + 1), rest = row / (cells_b + 1);
    const SplineEnd last = component == 0 ? odd : even;
    Values even_part(values.size()), odd_part(values.size());
    for (int i = 0; i <= cells_a; ++i)
        for (std::size_t k = 0; k < row; ++k) {
            if (last == odd && k >= cells_b * rest) continue;
            const double here = values[i * row + k], there = mirrored[component] * values[(cells_a - i) * row + k];
            even_part[i * row + k] = (here + there) / 2;
            if (k >= rest) odd_part[i * row + k] = (here - there) / 2;
        }
    const auto fitted = [&](const Values& part, SplineEnd first) {
        return multiply_along(spline_fit(cells_b, first, last), with_zero_ends(part, cells_b + 1, rest), rest);
    };
    Values sum = fitted(even_part, even);
    const Values odd_sum = fitted(odd_part, odd);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += odd_sum[k];
    return sum;
}

}  // namespace

std::size_t node_values(const CreepGrid& grid) {
    const std::size_t finite = static_cast<std::size_t>(grid.axes[u].cells) - 1;
    return 3 * nodes_of(grid.axes[log_ratio]) * nodes_of(grid.axes[z_a]) * nodes_of(grid.axes[z_b]) * finite;
}

std::vector<float> fit_creep_spline(const CreepGrid& grid, double nu, std::span<const double> forces) {
    require_node_values(forces.size(), node_values(grid));
    const auto& [ratios, angles_a, angles_b, lengths] = grid.axes;
    const std::size_t of_ratio = forces.size() / nodes_of(ratios);
    const Eigen::MatrixXd in_u = spline_fit(lengths.cells, slope, not_a_knot);
    const Eigen::MatrixXd in_z_a = spline_fit(angles_a.cells, antiperiodic, antiperiodic);
    std::array<Values, 3> all;
    for (int i = 0; i <= ratios.cells; ++i) {
        auto data = data_along_u(grid, nu, ratios.node(i), forces.data() + i * of_ratio);
        for (int c = 0; c < 3; ++c) {
            Values values = multiply_along(in_u, data[c], 1);
            join_poles(values, angles_a.cells, nodes_of(angles_b));
            values = fit_along_z_b(values, angles_a.cells, angles_b.cells, c);
            const std::size_t rest = values.size() / nodes_of(angles_a);
            values = multiply_along(in_z_a, with_zero_ends(values, angles_a.cells + 1, rest), rest);
            all[c].insert(all[c].end(), values.begin(), values.end());
        }
    }
    const Eigen::MatrixXd in_ratio = spline_fit(ratios.cells, not_a_knot, not_a_knot);
    for (Values& values : all) {
        const std::size_t rest = values.size() / nodes_of(ratios);
        values = multiply_along(in_ratio, with_zero_ends(values, ratios.cells + 1, rest), rest);
    }
    return interleaved(all);
}

}  // namespace contactd::creep_table

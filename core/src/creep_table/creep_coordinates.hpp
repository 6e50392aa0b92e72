// Defines the coordinates of a creep-force table: log(a/b), two angles of the direction of the scaled creepages
// (X, Y, S) = (xi/xi_f, eta/eta_f, phi/phi_f), and u = (4/pi) atan of their length rho, 2 being infinite creepage.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "creep_table/full_slip.hpp"
#include "creep_table/spline_axis.hpp"

namespace contactd::creep_table {

/// The axes of a table in the order of its arrays. The u of a table always runs from 0 to 2, z_a from 0 to pi and z_b
/// from 0 to pi/2; an apex box covers a part of each.
enum TableAxis : int { log_ratio, z_a, z_b, u, axis_count };
using TableAxes = std::array<SplineAxis, axis_count>;

/// States how the angles are refined around the axis of spin: kx = x (a/b)^x_power, ky = y (a/b)^y_power.
struct AngleScales {
    double x = 1.4, x_power = 0.17, y = 2, y_power = 0;

    double kx(double log_ratio) const { return x * std::exp(x_power * log_ratio); }
    double ky(double log_ratio) const { return y * std::exp(y_power * log_ratio); }
};

/// Describes the coordinates and the cells of a table.
struct CreepGrid {
    TableAxes axes{};
    AngleScales scales{};
};

/// Returns the grid with all directions, for a/b in this range, and these cells.
inline CreepGrid creep_grid(double a_over_b_from, double a_over_b_to, const std::array<int, axis_count>& cells,
                            const AngleScales& scales = {}) {
    constexpr double pi = std::numbers::pi;
    return {{{{std::log(a_over_b_from), std::log(a_over_b_to), cells[log_ratio]},
              {0, pi, cells[z_a]},
              {0, pi / 2, cells[z_b]},
              {0, 2, cells[u]}}},
            scales};
}

/// Returns the direction of the scaled creepages of two angles, of length 1, where z_a = atan2(hypot(kx X, S), ky Y)
/// and z_b = atan2(S, kx X).
inline Triple scaled_direction(const CreepGrid& grid, double log_a_over_b, double angle_a, double angle_b) {
    const auto exact = [](double value) { return std::abs(value) < 1e-15 ? 0 : value; };  // zero at a multiple of pi/2
    const double sin_a = exact(std::sin(angle_a)), cos_a = exact(std::cos(angle_a));
    const double X = sin_a * exact(std::cos(angle_b)) / grid.scales.kx(log_a_over_b);
    const double Y = cos_a / grid.scales.ky(log_a_over_b), S = sin_a * exact(std::sin(angle_b));
    const double length = std::hypot(X, Y, S);
    return {X / length, Y / length, S / length};
}

/// Returns the creepages (xi, eta, phi c) G c^2/(mu Fn) at a point of the table, of which u is below 2. A table is
/// built from the forces there.
inline Triple creepages_at(const CreepGrid& grid, double nu, const std::array<double, axis_count>& point) {
    const Triple direction = scaled_direction(grid, point[log_ratio], point[z_a], point[z_b]);
    const Triple scale = full_slip(std::exp(point[log_ratio]), nu);
    const double rho = std::tan(std::numbers::pi / 4 * point[u]);
    return {rho * direction[0] * scale[0], rho * direction[1] * scale[1], rho * direction[2] * scale[2]};
}

}  // namespace contactd::creep_table

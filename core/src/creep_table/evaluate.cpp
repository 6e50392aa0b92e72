#include "evaluate.hpp"

#include <cmath>
#include <numbers>

#include "contactd/error.hpp"
#include "creep_table/contraction.hpp"
#include "creep_table/creep_curves.hpp"

namespace contactd::creep_table {
namespace {

using std::numbers::pi;

/// Below this length of the scaled creepages, rounding of the coefficients would spoil derivatives by the angles, and
/// the forces are linear.
constexpr double linear_below = 5e-4;
/// Closer to the pole of the angles, relative to the length, the Jacobian is its limit at the pole.
constexpr double at_pole_below = 1e-3;

using Point = std::array<double, axis_count>;

SplineSums spline_at(const CreepSpline& table, const Point& point) {
    SplineSums sums;
    add_spline(table.grid.axes, table.coefficients.data(), point, sums);
    if (!table.box) return sums;
    for (int axis = 0; axis < axis_count; ++axis)
        if (!(*table.box)[axis].contains(point[axis])) return sums;
    add_spline(*table.box, table.box_coefficients.data(), point, sums);
    return sums;
}

void set_bounds(const CreepSpline& table, const Point& point, ScaledForces& result) {
    if (table.bounds.empty()) return;
    std::size_t index = 0;
    for (int axis = 0; axis < axis_count; ++axis)
        index = index * table.bound_axes[axis].cells + table.bound_axes[axis].cell(point[axis]);
    result.bounds = {table.bounds[2 * index], table.bounds[2 * index + 1]};
}

/// Refers the forces to creepages of the quadrant that the table holds: F(sign w) = sign F(w) for these signs.
Triple signs_of(const Triple& w) {
    const double turned = w[2] != 0 ? w[2] : w[1];
    return {std::copysign(1.0, w[0] + 0.0), std::copysign(1.0, turned + 0.0), std::copysign(1.0, turned + 0.0)};
}

/// Restores signs, and removes rounding errors from what vanishes by symmetry.
void apply_symmetries(const Triple& w, const Triple& sign, ScaledForces& result) {
    const bool no_x = w[0] == 0, only_x = w[1] == 0 && w[2] == 0;
    for (int i = 0; i < 3; ++i) {
        const bool vanishes = i == 0 ? no_x : only_x;
        result.forces[i] = vanishes ? 0 : sign[i] * result.forces[i];
        result.by_log_ratio[i] = vanishes ? 0 : sign[i] * result.by_log_ratio[i];
        for (int j = 0; j < 3; ++j) {
            const bool mixed = (i == 0) != (j == 0);
            result.by_creepage[i][j] = mixed && (no_x || only_x) ? 0 : sign[i] * sign[j] * result.by_creepage[i][j];
        }
    }
}

ScaledForces linear(const CurvePoint& curves, const Triple& w) {
    ScaledForces result;
    result.by_creepage = creepage_matrix(curves.value(C11), curves.value(C22), curves.value(C23), curves.value(C33));
    const auto by_ratio = creepage_matrix(curves.slope(C11), curves.slope(C22), curves.slope(C23), curves.slope(C33));
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            result.forces[i] += result.by_creepage[i][j] * w[j];
            result.by_log_ratio[i] += by_ratio[i][j] * w[j];
        }
    return result;
}

/// Holds derivatives of one force by p = kx X, q = ky Y and S, at constant u.
struct AngleSlopes {
    double p, q, S;
};

/// Evaluates at positive X and S. p, q and S are the creepages that define the angles.
struct Directions {
    double p, q, S, h, square;  ///< h^2 = p^2 + S^2, square = h^2 + q^2

    Directions(double p_, double q_, double S_)
        : p(p_), q(q_), S(S_), h(std::sqrt(p * p + S * S)), square(h * h + q * q) {}

    bool is_at_pole() const { return h * h < at_pole_below * at_pole_below * square; }

    AngleSlopes slopes(double by_a, double by_b) const {
        const double radial = by_a * q / (square * h), around = by_b / (h * h);
        return {radial * p - around * S, -by_a * h / square, radial * S + around * p};
    }
};

}  // namespace

ScaledForces evaluate(const CreepSpline& table, double log_a_over_b, const Triple& w) {
    const CurvePoint curves(table.curves, table.curve_axis, log_a_over_b);
    const Triple sign = signs_of(w);
    Triple scale, scaled, by_ratio;
    for (int i = 0; i < 3; ++i) {
        scale[i] = curves.value(inverse_xi + i);
        scaled[i] = sign[i] * w[i] * scale[i] + 0.0;  // The sum removes a negative zero, which would change angles.
        by_ratio[i] = sign[i] * w[i] * curves.slope(inverse_xi + i);
    }
    const auto [X, Y, S] = scaled;
    const double square = X * X + Y * Y + S * S;
    if (!std::isfinite(square)) throw InvalidArgument("creepages", "are not finite, or too large for a table");
    const double rho = std::sqrt(square);
    const AngleScales& scales = table.grid.scales;
    const double kx = scales.kx(log_a_over_b), ky = scales.ky(log_a_over_b);
    const Directions at(kx * X, ky * Y, S);
    const Point point{log_a_over_b, std::atan2(at.h, at.q), std::atan2(at.S, at.p), 4 / pi * std::atan(rho)};

    ScaledForces result;
    if (rho < linear_below) {
        result = linear(curves, w);
        set_bounds(table, point, result);
        apply_symmetries(w, {1, 1, 1}, result);
        return result;
    }
    const SplineSums sums = spline_at(table, point);
    SplineSums along_x, along_spin;
    if (at.is_at_pole()) {
        along_x = spline_at(table, {point[0], point[1], 0, point[3]});
        along_spin = spline_at(table, {point[0], point[1], pi / 2, point[3]});
    }
    const double u_by_rho = 4 / pi / (1 + square) / rho;
    const double p_by_ratio = kx * (by_ratio[0] + scales.x_power * X),
                 q_by_ratio = ky * (by_ratio[1] + scales.y_power * Y);
    for (int i = 0; i < 3; ++i) {
        AngleSlopes angles = at.slopes(sums.slope[z_a][i], sums.slope[z_b][i]);
        if (at.is_at_pole()) {
            angles.p = along_x.slope[z_a][i] / at.q;
            angles.S = along_spin.slope[z_a][i] / at.q;
        }
        const double by_rho = sums.slope[u][i] * u_by_rho;
        result.forces[i] = sums.value[i];
        result.by_creepage[i] = {(kx * angles.p + by_rho * X) * scale[0], (ky * angles.q + by_rho * Y) * scale[1],
                                 (angles.S + by_rho * S) * scale[2]};
        result.by_log_ratio[i] = sums.slope[log_ratio][i] + angles.p * p_by_ratio + angles.q * q_by_ratio +
                                 angles.S * by_ratio[2] +
                                 by_rho * (X * by_ratio[0] + Y * by_ratio[1] + S * by_ratio[2]);
    }
    set_bounds(table, point, result);
    apply_symmetries(w, sign, result);
    return result;
}

}  // namespace contactd::creep_table

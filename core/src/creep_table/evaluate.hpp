// Evaluates a creep-force table in scaled variables.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>

#include "creep_table/creep_coordinates.hpp"

namespace contactd::creep_table {

/// Refers to the parts of a table at one Poisson's ratio. Shapes are those of fit_creep_spline, fit_apex_box and
/// creep_curves; `bounds` has the shape [cells of bound_axes, 2], or is empty.
struct CreepSpline {
    CreepGrid grid{};
    SplineAxis curve_axis{};
    std::span<const double> curves{};
    std::span<const float> coefficients{};
    std::optional<TableAxes> box{};
    std::span<const float> box_coefficients{};
    TableAxes bound_axes{};
    std::span<const float> bounds{};
};

/// Holds (Fx, Fy, Mz/c)/(mu Fn) with the sign of the creepages.
struct ScaledForces {
    Triple forces{};
    std::array<Triple, 3> by_creepage{};  ///< rows by (xi, eta, phi c) G c^2/(mu Fn)
    Triple by_log_ratio{};                ///< by log(a/b) at constant creepages
    /// Bounds of the errors of (Fx, Fy) and of Mz/c, or NaN if the table states none.
    std::array<double, 2> bounds{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
};

/// Returns the forces for the creepages w = (xi, eta, phi c) G c^2/(mu Fn), without allocation or locks. log(a/b)
/// beyond the ends counts as the end. Throws InvalidArgument ("creepages") if the length of w is not finite.
ScaledForces evaluate(const CreepSpline& table, double log_a_over_b, const Triple& w);

}  // namespace contactd::creep_table

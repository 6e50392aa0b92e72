// Evaluates the tensor-product spline of a creep-force table.
#pragma once

#include <array>

#include "creep_table/creep_coordinates.hpp"

namespace contactd::creep_table {

/// Holds (Fx, Fy, Mz/c, 0) and its derivatives by the coordinates of the table.
struct SplineSums {
    float value[4]{};
    float slope[axis_count][4]{};
};

/// Adds the spline with these coefficients, of shape [log_ratio + 3, z_a + 3, z_b + 3, u + 3, 4], at a point.
/// Coordinates beyond the ends count as the ends.
void add_spline(const TableAxes& axes, const float* coefficients, const std::array<double, axis_count>& point,
                SplineSums& sums);

}  // namespace contactd::creep_table

// Makes the coefficients of a creep-force table from forces at its nodes.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "creep_table/creep_coordinates.hpp"

namespace contactd::creep_table {

/// Returns the number of values that fit_creep_spline needs.
std::size_t node_values(const CreepGrid& grid);

/// Returns the coefficients of the spline through forces at the nodes, of shape [log_ratio + 3, z_a + 3, z_b + 3, u +
/// 3, 4], where log_ratio, ... are the cells of the axes and the fourth number is zero. `forces` are (Fx, Fy, Mz/c)/(mu
/// Fn) with the sign of the creepages, of shape [log_ratio + 1, z_a + 1, z_b + 1, u - 1, 3], at creepages_at of all
/// knots between u = 0 and u = 2. Forces and slopes at u = 0 and forces at u = 2 are added. Symmetric nodes are
/// averaged; at z_a = 0 and pi, the forces are those of the first z_b. Ends in u at infinity and in log(a/b) are
/// not-a-knot. Each axis has at least 4 cells. Throws InvalidArgument ("nodes").
std::vector<float> fit_creep_spline(const CreepGrid& grid, double nu, std::span<const double> forces);

/// Returns the coefficients of an apex box: a spline on finer cells of a part of the table, which is added to `spline`
/// there. `forces` are given at all knots of the box, of shape [log_ratio + 1, z_a + 1, z_b + 1, u + 1, 3]. Values and
/// slopes of the box vanish at its faces inside the table, whatever the forces there; at z_b = pi/2 it is symmetric,
/// and at the ends of log(a/b) not-a-knot. Throws InvalidArgument ("box", "nodes").
std::vector<float> fit_apex_box(const CreepGrid& grid, std::span<const float> spline, const TableAxes& box,
                                std::span<const double> forces);

/// Returns the box around the apex, X = Y = 0 and S = 1, for a/b from about 2 to the end of the table: the cells of the
/// table, halved along z_a, z_b and u. Returns nothing if the table has fewer than 4 cells there.
std::optional<TableAxes> apex_box(const CreepGrid& grid);

/// Returns whether a box lies in a table as fit_apex_box requires: between the ends of z_a and u, and above z_b = 0.
bool is_inside(const TableAxes& box, const CreepGrid& grid);

}  // namespace contactd::creep_table

// Makes a creep-force table from forces at its nodes, which its builder solves, and adds the bounds of its errors.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace contactd {

/// Describes the nodes of a table: equidistant in log(a/b), in both angles of the scaled creepages, and in u, (4/pi)
/// atan of their length (core/src/creep_table/creep_coordinates.hpp). Around the apex, which is pure spin at full slip,
/// a table that has 4 cells above a/b 2 has a box with halved cells of the angles and u.
struct CreepTablePlan {
    std::array<double, 2> ratios{0.05, 20};    ///< range of a/b, within 1/32 to 32
    std::array<int, 4> cells{32, 40, 16, 32};  ///< of a/b, both angles, and u; 4 to 512 each
    std::vector<double> nu{0.28};              ///< Poisson's ratios: ascending, at most 8, within 0 to 0.5
};

/// Holds nodes with one a/b and one first angle: of all second angles and u, except those whose forces are known. At
/// the first and the last angle of the table, all second angles are equal, and the row holds one.
struct CreepTableRow {
    double a_over_b = 0;
    std::vector<double> creepages{};  ///< (xi, eta, phi c) G c^2/(mu Fn), c^2 = ab, of shape [nodes, 3]
};

/// Returns the number of nodes of each row at one Poisson's ratio: those of the table, then those of the box, by a/b
/// and angle. Throws InvalidArgument ("ratios", "cells").
std::vector<int> creep_table_rows(const CreepTablePlan& plan);

/// Returns a row. Throws InvalidArgument ("ratios", "cells", "row").
CreepTableRow creep_table_row(const CreepTablePlan& plan, double nu, int row);

/// Returns the creepages (xi, eta, phi c) G c^2/(mu Fn) of points (log(a/b), first angle, second angle, u), of shapes
/// [points, 3] and [points, 4]; u is below 2. Throws InvalidArgument ("ratios", "cells").
std::vector<double> creep_table_creepages(const CreepTablePlan& plan, double nu, std::span<const double> points);

/// Fits the table and writes its file. `forces` are (Fx, Fy, Mz/c)/(mu Fn) with the sign of the creepages, of all nodes
/// of all rows at the first Poisson's ratio, then at the next. `description` is JSON. Throws InvalidArgument ("ratios",
/// "cells", "nodes", "table") and StoreError.
void write_creep_table(const std::filesystem::path& path, const CreepTablePlan& plan, std::span<const double> forces,
                       std::string_view description);

/// Writes bounds of the errors and another description into a file. The bounds of (Fx, Fy)/(mu Fn) and Mz/(mu Fn c)
/// have the shape [cells, 2], where these cells divide the axes of the table evenly. Throws what CreepTable does, and
/// InvalidArgument ("table") if the sizes disagree.
void certify_creep_table(const std::filesystem::path& path, const std::array<int, 4>& cells,
                         std::span<const float> bounds, std::string_view description);

}  // namespace contactd

// Makes a creep-force table from forces at its nodes, which its builder solves.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace contactd {

/// Describes the nodes of a table: equidistant in log(a/b), in both angles of the scaled creepages, and in u, (4/pi)
/// atan of their length (core/src/creep_table/creep_coordinates.hpp).
struct CreepTablePlan {
    std::array<double, 2> ratios{0.05, 20};    ///< range of a/b, within 1/32 to 32
    std::array<int, 4> cells{32, 40, 16, 32};  ///< of a/b, both angles, and u; 4 to 1024 each
    std::vector<double> nu{0.28};              ///< Poisson's ratios: ascending, at most 8, within 0 to 0.5
};

/// Returns a/b of a node, from 0 to cells[0].
double creep_table_ratio(const CreepTablePlan& plan, int ratio);

/// Returns the creepages (xi, eta, phi c) G c^2/(mu Fn), c^2 = ab, at the nodes of one a/b and one first angle, of
/// shape [cells[2] + 1, cells[3] - 1, 3]: without those of zero and infinite creepage. At the first and the last angle,
/// all rows are equal. Throws InvalidArgument ("ratios", "cells", "ratio", "angle").
std::vector<double> creep_table_creepages(const CreepTablePlan& plan, double nu, int ratio, int angle);

/// Fits the table and writes its file. `forces` are (Fx, Fy, Mz/c)/(mu Fn) with the sign of the creepages, of shape
/// [nu, cells[0] + 1, cells[1] + 1, cells[2] + 1, cells[3] - 1, 3]. `description` is JSON. Throws InvalidArgument
/// ("ratios", "cells", "nodes", "table") and StoreError.
void write_creep_table(const std::filesystem::path& path, const CreepTablePlan& plan, std::span<const double> forces,
                       std::string_view description);

}  // namespace contactd

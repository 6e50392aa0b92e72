// Reads and writes files of creep-force tables: flat and little-endian, so that a table is used where it is mapped.
//
//     header            512 bytes: magic, version, sizes, ranges, Poisson's ratios
//     description       JSON text, padded with spaces to a multiple of 64 bytes
//     curves            float64 [nu, 7, curve cells + 3]: splines over log(a/b) of 1/xi_f, 1/eta_f, 1/phi_f, C11, C22,
//     C23, C33 coefficients      float32 [nu, a/b + 3, z_a + 3, z_b + 3, u + 3, 4], where a/b, ... are numbers of cells
//     box coefficients  float32, the same for the apex box, if there is one
//     bounds            float32 [a/b, z_a, z_b, u, 2] of (Fx, Fy)/(mu Fn) and Mz/(mu Fn c), if the table is certified
//     digest            64 hexadecimal digits: the SHA-256 of all bytes before it
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "creep_table/creep_coordinates.hpp"

namespace contactd::creep_table {

/// Refers to the parts of a file. It owns the list of Poisson's ratios only.
struct CreepFile {
    CreepGrid grid{};
    std::vector<double> nu{};  ///< ascending, at most 8
    int curve_cells = 0;
    std::optional<TableAxes> box{};
    std::array<int, axis_count> bound_cells{};  ///< of the whole table, zero without bounds
    std::string_view description{};
    std::span<const double> curves{};
    std::span<const float> coefficients{}, box_coefficients{}, bounds{};

    /// Curves cover the same range of a/b as the table.
    SplineAxis curve_axis() const { return {grid.axes[log_ratio].from, grid.axes[log_ratio].to, curve_cells}; }
    TableAxes bound_axes() const;
};

/// Returns the number of coefficients of a spline on these axes.
std::size_t spline_size(const TableAxes& axes);

/// Returns the parts of a file after checking every size, range and the digest. `bytes` start at a multiple of 8, and
/// `name` names the file in exceptions. Throws DamagedTable and NewerFormat.
CreepFile parse_creep_file(std::span<const unsigned char> bytes, const std::string& name);

/// Writes a file so that `path` is never incomplete. Throws InvalidArgument ("table") if the parts do not fit together,
/// and StoreError.
void write_creep_file(const std::filesystem::path& path, const CreepFile& file);

}  // namespace contactd::creep_table

// Defines the header of a creep-force table's file.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

#include "creep_table/file/table_file.hpp"

namespace contactd::creep_table {

static_assert(std::endian::native == std::endian::little, "Files of tables are read where they lie.");

inline constexpr std::string_view file_magic = "contactd creep-force table\n";
inline constexpr std::uint64_t file_version = 1;
inline constexpr std::size_t digest_size = 64, most_nu = 8;

/// Holds the first 512 bytes. Arrays are in the order of TableAxis; the ranges of a whole table are known except that
/// of log(a/b).
struct FileHeader {
    std::array<char, 32> magic{};
    std::uint64_t version = file_version, file_size = 0, description_size = 0, nu_count = 0, curve_cells = 0;
    std::array<std::uint64_t, axis_count> cells{}, box_cells{}, bound_cells{};
    double log_ratio_from = 0, log_ratio_to = 0;
    AngleScales scales{};
    std::array<double, axis_count> box_from{}, box_to{};
    std::array<double, most_nu> nu{};
    std::array<std::uint64_t, 21> unused{};
};
static_assert(sizeof(FileHeader) == 512);

/// Holds the number of bytes in front of each part of a file.
struct FileOffsets {
    std::uint64_t description, curves, coefficients, box_coefficients, bounds, digest, end;
};

/// Returns the offsets. The header must have passed sizes_are_valid.
FileOffsets offsets_of(const FileHeader& header);
/// Returns whether all numbers are small enough to compute with.
bool sizes_are_valid(const FileHeader& header);
/// Returns whether ranges and Poisson's ratios are those of a table, and the box lies inside.
bool ranges_are_valid(const FileHeader& header);

FileHeader header_of(const CreepFile& file);
/// Returns the file described by a valid header, without its arrays.
CreepFile file_of(const FileHeader& header);

}  // namespace contactd::creep_table

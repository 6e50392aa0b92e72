#include "file_header.hpp"

#include <algorithm>
#include <cmath>

#include "creep_table/creep_curves.hpp"
#include "creep_table/fit/fit_spline.hpp"

namespace contactd::creep_table {
namespace {

constexpr std::uint64_t least_cells = 4, most_cells = 1024, longest_description = 1 << 24;
using Cells = std::array<std::uint64_t, axis_count>;

bool all_between(const Cells& cells, std::uint64_t least, std::uint64_t most) {
    return std::ranges::all_of(cells, [&](std::uint64_t n) { return n >= least && n <= most; });
}

bool all_zero(const Cells& cells) {
    return all_between(cells, 0, 0);
}

// Returns the bytes of a spline, which are zero for no cells.
std::uint64_t spline_bytes(const Cells& cells) {
    if (all_zero(cells)) return 0;
    std::uint64_t bytes = 4 * sizeof(float);
    for (const std::uint64_t n : cells) bytes *= n + 3;
    return bytes;
}

Cells cells_of(const TableAxes& axes) {
    Cells cells{};
    for (int axis = 0; axis < axis_count; ++axis) cells[axis] = static_cast<std::uint64_t>(axes[axis].cells);
    return cells;
}

}  // namespace

std::size_t spline_size(const TableAxes& axes) {
    return static_cast<std::size_t>(spline_bytes(cells_of(axes)) / sizeof(float));
}

TableAxes CreepFile::bound_axes() const {
    TableAxes axes = grid.axes;
    for (int axis = 0; axis < axis_count; ++axis) axes[axis].cells = bound_cells[axis];
    return axes;
}

bool sizes_are_valid(const FileHeader& header) {
    return header.nu_count >= 1 && header.nu_count <= most_nu && header.description_size <= longest_description &&
           header.description_size % 64 == 0 && header.curve_cells >= least_cells && header.curve_cells <= most_cells &&
           all_between(header.cells, least_cells, most_cells) &&
           (all_zero(header.box_cells) || all_between(header.box_cells, least_cells, most_cells)) &&
           (all_zero(header.bound_cells) || all_between(header.bound_cells, 1, most_cells));
}

FileOffsets offsets_of(const FileHeader& header) {
    std::uint64_t bounds = all_zero(header.bound_cells) ? 0 : 2 * sizeof(float);
    for (const std::uint64_t n : header.bound_cells) bounds *= n;
    FileOffsets offsets{};
    offsets.description = sizeof header;
    offsets.curves = offsets.description + header.description_size;
    offsets.coefficients = offsets.curves + header.nu_count * curve_count * (header.curve_cells + 3) * sizeof(double);
    offsets.box_coefficients = offsets.coefficients + header.nu_count * spline_bytes(header.cells);
    offsets.bounds = offsets.box_coefficients + header.nu_count * spline_bytes(header.box_cells);
    offsets.digest = offsets.bounds + bounds;
    offsets.end = offsets.digest + digest_size;
    return offsets;
}

bool ranges_are_valid(const FileHeader& header) {
    const auto is_between = [](double value, double least, double most) { return value >= least && value <= most; };
    const double widest = std::log(32) * (1 + 1e-12);  // Kalker's coefficients end there
    const AngleScales& scales = header.scales;
    for (std::size_t i = 0; i < header.nu_count; ++i)
        if (!is_between(header.nu[i], 0, 0.5) || (i > 0 && !(header.nu[i] > header.nu[i - 1]))) return false;
    const CreepFile file = file_of(header);
    return is_between(header.log_ratio_from, -widest, widest) && is_between(header.log_ratio_to, -widest, widest) &&
           header.log_ratio_from < header.log_ratio_to && is_between(scales.x, 0.01, 100) &&
           is_between(scales.y, 0.01, 100) && is_between(scales.x_power, -1, 1) && is_between(scales.y_power, -1, 1) &&
           (!file.box || is_inside(*file.box, file.grid));
}

FileHeader header_of(const CreepFile& file) {
    FileHeader header;
    std::ranges::copy(file_magic, header.magic.begin());
    header.description_size = (file.description.size() + 63) / 64 * 64;
    header.nu_count = file.nu.size();
    std::copy_n(file.nu.begin(), std::min(file.nu.size(), most_nu), header.nu.begin());
    header.curve_cells = static_cast<std::uint64_t>(file.curve_cells);
    header.cells = cells_of(file.grid.axes);
    header.log_ratio_from = file.grid.axes[log_ratio].from;
    header.log_ratio_to = file.grid.axes[log_ratio].to;
    header.scales = file.grid.scales;
    header.bound_cells = cells_of(file.bound_axes());
    if (file.box) header.box_cells = cells_of(*file.box);
    for (int axis = 0; file.box && axis < axis_count; ++axis) {
        header.box_from[axis] = (*file.box)[axis].from;
        header.box_to[axis] = (*file.box)[axis].to;
    }
    return header;
}

CreepFile file_of(const FileHeader& header) {
    CreepFile file;
    std::array<int, axis_count> cells{};
    std::ranges::copy(header.cells, cells.begin());
    file.grid = creep_grid(1, 1, cells, header.scales);
    file.grid.axes[log_ratio].from = header.log_ratio_from;
    file.grid.axes[log_ratio].to = header.log_ratio_to;
    file.nu.assign(header.nu.begin(), header.nu.begin() + static_cast<std::ptrdiff_t>(header.nu_count));
    file.curve_cells = static_cast<int>(header.curve_cells);
    for (int axis = 0; axis < axis_count; ++axis) file.bound_cells[axis] = static_cast<int>(header.bound_cells[axis]);
    if (all_zero(header.box_cells)) return file;
    file.box.emplace();
    for (int axis = 0; axis < axis_count; ++axis)
        (*file.box)[axis] = {header.box_from[axis], header.box_to[axis], static_cast<int>(header.box_cells[axis])};
    return file;
}

}  // namespace contactd::creep_table

#include "contactd/patch_influence.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "bodies/column_influence.hpp"
#include "contactd/column_spectrum.hpp"
#include "contactd/error.hpp"
#include "influence/rotated/rotated_half_space.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

constexpr double most_values = 5e7;  // of each of nine components: 3.6 GB

void check_size(const Grid& grid) {
    if (static_cast<double>(grid.nx) * grid.ny * grid.ny > most_values)
        throw InvalidArgument("dy", "is " + number_text(grid.dy) + ", which makes a patch of " +
                                        std::to_string(grid.ny) + " rows of " + std::to_string(grid.nx) +
                                        " elements; where coefficients differ from row to row, rows squared times "
                                        "elements of a row may be at most 5e7");
}

/// In the axes of the wheel; of the rail in the reverse order, as an upper body's columns are.
ColumnTable rotated_pair(const ContactProblem& problem, std::vector<ColumnFrame> frames, const Observer& observer) {
    const Grid& grid = problem.grid;
    const auto table_of = [&](const Material& material) {
        if (material.is_rigid()) return ColumnTable(grid.nx, grid.ny);
        return rotated_half_space({frames, grid.dy, 0, grid.dx, grid.nx}, material, LoadShape::constant, 0, observer);
    };
    const auto [rail, wheel] = problem.bodies.materials();
    ColumnTable lower = table_of(wheel);
    std::reverse(frames.begin(), frames.end());
    return pair_of(table_of(rail), std::move(lower));
}

ColumnSpectrum part_of(const ColumnSpectrum& whole, int first, int columns) {
    ColumnSpectrum part = whole;
    part.columns = columns;
    part.frames.assign(whole.frames.begin() + first, whole.frames.begin() + first + columns);
    part.values.clear();
    part.values.reserve(part.nodes.size() * part.component_size());
    for (std::size_t node = 0; node < part.nodes.size(); ++node)
        for (int a = 0; a < 3 * columns; ++a)
            for (int b = 0; b <= a; ++b)
                part.values.push_back(whole.values[whole.index(node, 3 * first + a, 3 * first + b)]);
    return part;
}

/// As the section numbers its columns. Of finite elements' transform only the part that is needed becomes a table.
ColumnTable table_of(const std::optional<BodyColumns>& columns, const Grid& grid, const IcRecord* record,
                     const Observer& observer) {
    if (!columns) return {grid.nx, grid.ny};
    if (!std::holds_alternative<ColumnSpectrum>(record->tables))
        return cropped(std::get<ColumnTable>(body_table(*record, columns->spec, 1, observer)), columns->first, grid.ny,
                       grid.nx);
    const ColumnSpectrum part = part_of(std::get<ColumnSpectrum>(record->tables), columns->first, grid.ny);
    return column_table(part, grid.dx / grid.dy, grid.nx, 0, grid.dy / columns->spec.material.G, 1, observer);
}

}  // namespace

ContactInfluence patch_influence(const ContactProblem& problem, const PatchColumns& columns, const IcRecord* of_rail,
                                 const IcRecord* of_wheel, const Observer& observer) {
    const Grid& grid = problem.grid;
    check_size(grid);
    if (!columns.of_sections())
        return column_influence(problem, rotated_pair(problem, columns.frames, observer), observer);
    // A rail's columns run to the right and a wheel's to the left, as those of bodies that lie on each other do; rows
    // run to the right.
    ColumnTable wheel = table_of(columns.wheel, grid, of_wheel, observer);
    return column_influence(
        problem, mirrored(pair_of(table_of(columns.rail, grid, of_rail, observer), std::move(wheel))), observer);
}

}  // namespace contactd

#include "influence/rotated/screened_columns.hpp"

#include "influence/rotated/midway_values.hpp"
#include "influence/rotated/screened_half_space.hpp"

namespace contactd {

ColumnTable screened_table(const ColumnGrid& grid, double nu, double xi0, double shift) {
    const auto midway = midway_values(grid, nu, static_cast<std::size_t>(grid.nx), [&](double s, std::size_t k) {
        return screened_integrals(static_cast<double>(k) * grid.dx + shift, s, grid.dx, grid.ds, xi0);
    });
    return midway_table(grid, midway, 1);
}

std::vector<double> screened_spectrum(const ColumnGrid& grid, double nu, double xi0, double xi) {
    const auto midway =
        midway_values(grid, nu, 1, [&](double s, std::size_t) { return screened_transform(xi, s, grid.ds, xi0); });
    return in_column_axes(grid, midway, 1);
}

}  // namespace contactd

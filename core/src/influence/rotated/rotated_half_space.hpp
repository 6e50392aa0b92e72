// Coefficients of a body that is uniform along x, by half-spaces that are turned from column to column.
#pragma once

#include <span>
#include <vector>

#include "contactd/column_table.hpp"
#include "contactd/ic_spec.hpp"
#include "influence/rotated/column_values.hpp"

namespace contactd {

/// Columns of a section and the elements on them.
struct ColumnGrid {
    std::span<const ColumnFrame> frames;
    double ds = 0;         ///< arc length of a column (mm)
    double perimeter = 0;  ///< of a closed curve all round which columns may lie (mm); 0: an open one
    double dx = 0;         ///< length of an element along x (mm)
    int nx = 0;            ///< offsets 0..nx-1
};

/// Blanco-Lorenzo et al. (2016): the half-space's coefficients at the distance along the surface, between axes midway.
/// mm^3/N, at the offsets k dx + shift. On flat columns it is the table of the half-space.
ColumnTable rotated_half_space(const ColumnGrid& grid, const Material& material, LoadShape load, double shift = 0);

/// The same of screened half-spaces (constant loads), and its transform at one wavenumber, per unit of length along x:
/// shape [3, 3, columns, columns], i, j, I, J; G = 1.
ColumnTable screened_table(const ColumnGrid& grid, double nu, double xi0, double shift = 0);
std::vector<double> screened_spectrum(const ColumnGrid& grid, double nu, double xi0, double xi);

}  // namespace contactd

// Coefficients of a body that is uniform along x by half-spaces that turn with its surface, from column to column.
#pragma once

#include "contactd/column_table.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/observer.hpp"
#include "influence/rotated/column_grid.hpp"

namespace contactd {

/// mm^3/N, at the offsets k dx + shift, k >= 0: the closed form of the half-space at the distance along the surface, in
/// axes midway between those of the two columns, then turned by half the angle between them (Blanco-Lorenzo et al.). On
/// flat columns it is the half-space's table. Throws Cancelled when the observer, which is asked column by column, says
/// so.
ColumnTable rotated_half_space(const ColumnGrid& grid, const Material& material, LoadShape load, double shift = 0,
                               const Observer& observer = {});

}  // namespace contactd

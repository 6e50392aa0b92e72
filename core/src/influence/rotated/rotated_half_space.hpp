// Computes coefficients of a body that is uniform along x by half-spaces that rotate with its surface, from strip to
// strip.
#pragma once

#include "contactd/ic_spec.hpp"
#include "contactd/observer.hpp"
#include "contactd/strip_table.hpp"
#include "influence/rotated/strip_grid.hpp"

namespace contactd {

/// Returns coefficients (mm^3/N) at the offsets k dx + shift, k >= 0: the closed form of the half-space at the distance
/// along the surface, in axes midway between those of the two strips, then rotated by half the angle between them
/// (Blanco-Lorenzo et al.). On flat strips the table is that of the half-space. Throws Cancelled if the observer, which
/// is called for each strip, cancels.
StripTable rotated_half_space(const StripGrid& grid, const Material& material, LoadShape load, double shift = 0,
                              const Observer& observer = {});

}  // namespace contactd

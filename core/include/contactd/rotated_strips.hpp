// Computes coefficients of a body from its cross-section without finite elements.
#pragma once

#include <string>

#include "contactd/grid.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/observer.hpp"
#include "contactd/section.hpp"
#include "contactd/strip_table.hpp"

namespace contactd {

/// Returns coefficients (mm^3/N) at the offsets k dx + shift, k = 0..nx-1, between the grid.ny strips of the section,
/// each grid.dy wide. They are the half-space's closed form at the distance along the surface, in axes midway between
/// those of the two strips, then rotated by half the angle between them (Blanco-Lorenzo et al.). They include
/// curvature, but not edges, thickness, or the clamping of the body. On flat strips the table is that of the
/// half-space. Throws InvalidArgument as strip_frames(), and Cancelled; the observer can cancel after each strip.
StripTable rotated_strips(const Section& section, const Grid& grid, const Material& material, LoadShape load,
                          double shift = 0, const std::string& field = "section", const Observer& observer = {});

}  // namespace contactd

// Closed-form influence coefficients of the elastic half-space (Boussinesq and Cerruti; Johnson, Contact Mechanics,
// chapter 3; Kalker 1990, section 5.A).
#pragma once

#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"

namespace contactd {

/// Displacement along i (mm) at (x, y) of the surface of the half-space z <= 0, for a unit traction (1 N/mm^2) along j
/// over the rectangle dx x dy centred at the origin. Any sign of x and y, axes and edges included.
double half_space_coefficient(Axis i, Axis j, double x, double y, double dx, double dy, const Material& material);

/// All nine components for the offsets of `spec` (whose source must be analytic), in mm^3/N.
IcTable half_space_table(const IcSpec& spec);

/// Fills the error fields of `evidence` for a table made from `spec` by another method.
void compare_with_half_space(const IcSpec& spec, const IcTable& table, IcEvidence& evidence);

}  // namespace contactd

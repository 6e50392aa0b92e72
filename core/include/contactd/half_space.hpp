// Computes closed-form influence coefficients of the elastic half-space (Boussinesq and Cerruti; Johnson, Contact
// Mechanics, chapter 3; Kalker 1990, section 5.A).
#pragma once

#include <array>

#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Returns the displacement along i (mm) at (x, y) on the half-space z <= 0, for a unit traction (1 N/mm^2) along j
/// over the rectangle dx x dy centred at the origin. Any x and y are valid, also on axes and edges.
double half_space_coefficient(Axis i, Axis j, double x, double y, double dx, double dy, const Material& material);

/// Returns the coefficient of the bilinear hat function of tractions, (1 - |x|/dx)(1 - |y|/dy) on |x| <= dx, |y| <= dy
/// (paper, Remark 1). It equals the coefficient of the constant load averaged over an element. Its relative accuracy is
/// 1e-12 of the largest component there.
double half_space_bilinear_coefficient(Axis i, Axis j, double x, double y, double dx, double dy,
                                       const Material& material);

/// Returns the displacement (x, y, z; mm) at the point (x, y, z), z <= 0, of the half-space under the load of `spec`
/// along `load` at the origin. It is computed from Boussinesq's and Cerruti's point loads (Johnson, section 3.2 and
/// 3.6) at Gauss points of the load. Use it for points at distances larger than the load: the relative error is 1e-8
/// from three times max(dx, dy). Throws InvalidArgument ("point") above the surface. `spec` is not checked otherwise.
std::array<double, 3> half_space_displacement(const IcSpec& spec, Axis load, const std::array<double, 3>& point);

/// Returns all nine components, for the load shape and the offsets of `spec` (whose source must be analytic), in
/// mm^3/N. The observer can cancel after each row, which throws Cancelled.
IcTable half_space_table(const IcSpec& spec, const Observer& observer = {});

/// Coefficients of a block vanish near its clamped faces, and change sign before them if it is nearly incompressible.
/// Therefore, errors of a block are relative to at least this fraction of the half-space's coefficient.
inline constexpr double block_error_floor = 0.05;

/// Returns the unit of the errors of xx, yy and zz, which is |exact|, and for a block at least the floor.
IcTable error_unit(const IcSpec& spec, const IcTable& exact);

/// Sets the errors in `evidence` from the difference of `table` to a better one of the same spec.
void compare_tables(const IcSpec& spec, const IcTable& table, const IcTable& exact, IcEvidence& evidence);

/// Compares a table of `spec` by another method with the closed form. Throws InvalidArgument if the table has another
/// extent or the body is a block.
void compare_with_half_space(const IcSpec& spec, const IcTable& table, IcEvidence& evidence);

}  // namespace contactd

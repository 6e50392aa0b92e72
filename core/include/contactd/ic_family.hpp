// Interpolates tables over Poisson's ratio, so that one family serves every ratio. Tables lie at the Chebyshev-Lobatto
// points of two halves, [0, family_break] and (family_break, largest_family_nu], each with its own meshes (Trefethen,
// Approximation Theory and Approximation Practice, chapters 2 and 5).
#pragma once

#include <array>
#include <vector>

#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"

namespace contactd {

/// Returns n >= 2 Chebyshev-Lobatto points of each half, ascending, 2n in total. family_break is the last one of the
/// lower half and the first one of the upper, whose mesh may differ. The points of 2n - 1 include those of n.
std::vector<double> family_points(int n);

/// Interpolates `family`, tables of G = 1 at family_points(n), to `nu` in [0, largest_family_nu] (barycentric). Only
/// the tables of nu's half are used; nu rounded to twelve digits, as in keys, determines the half. Throws
/// InvalidArgument: "material.nu" if outside, "family" for an invalid family.
IcTable interpolated(const std::vector<IcTable>& family, double nu);

/// Returns the error that interpolation adds to that of the tables themselves, estimated from the last two Chebyshev
/// coefficients. It is the largest over the table and nu, relative for xx, yy and zz, and times 2 pi rho / (dx dy) for
/// the others.
double interpolation_error(const IcSpec& spec, const std::vector<IcTable>& family);
/// Returns this error for the lower and for the upper half.
std::array<double, 2> interpolation_errors(const IcSpec& spec, const std::vector<IcTable>& family);

}  // namespace contactd

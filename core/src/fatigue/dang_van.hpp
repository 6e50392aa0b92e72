// Computes Dang Van's stress of a history.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace contactd {

/// Holds xx, yy, zz, xy, xz, yz (N/mm^2).
using StressTensor = std::array<double, 6>;

/// Returns the largest tau_a + a_DV (sigma_h + residual) of a steady passage, also between its equidistant points. The
/// history begins and ends without stress. tau_a is half the difference of the principal values of the deviator minus
/// the centre of the smallest ball around all deviators. sigma_h is the mean of the normal stresses, and `residual`
/// that of the residual ones.
double dang_van_stress(std::span<const StressTensor> history, double a_DV, double residual);

/// Returns half the difference of the largest and the smallest principal value of a tensor (N/mm^2).
double largest_shear(const StressTensor& stress);

}  // namespace contactd

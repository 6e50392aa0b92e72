// Computes Gauss's rule on [0, 1] of any number of points.
#pragma once

#include <vector>

#include "influence/gauss_rules.hpp"

namespace contactd {

/// Returns nodes, ascending in (0, 1), and weights that sum to one, by Newton's iteration on Legendre's polynomial.
std::vector<GaussPoint> gauss_legendre(int points);

}  // namespace contactd

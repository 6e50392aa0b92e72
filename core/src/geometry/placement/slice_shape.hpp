// Computes factors on the derivatives of smooth polynomials that keep the shape of slices. They are the same for all
// points of a slice.
#pragma once

#include <span>
#include <vector>

#include "geometry/placement/knots_along.hpp"

namespace contactd::geometry {

/// Holds the factors at a knot on the first and the second derivative of the polynomial through the values around it.
struct DerivativeShares {
    double slope = 1, curving = 1;
};

/// Holds the coordinates of all points of a slice, in the same order for all slices.
using SlicePoints = std::vector<double>;

/// Holds weights of the values at some knots in the first and the second derivative at one.
struct DerivativeStencil {
    std::vector<std::size_t> knots;
    std::vector<double> first, second;
};

/// Selects the curve between two slices with equal values. It is constant, or it may pass an extremum if the two are as
/// close to each other as to their neighbours and the second differences at four knots around show one.
enum class EqualValues { stay, may_flank_extremum };

/// Returns the factors at all knots, as described in quintic_spline.hpp.
std::vector<DerivativeShares> shares_of_shape(const KnotsAlong& knots, std::span<const DerivativeStencil> stencils,
                                              std::span<const SlicePoints> slices, EqualValues equal);

}  // namespace contactd::geometry

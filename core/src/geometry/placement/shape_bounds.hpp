// Bounds slope and second derivative of a curve so that it keeps the shape of its values.
#pragma once

#include <cstddef>
#include <span>

#include "geometry/placement/knots_along.hpp"

namespace contactd::geometry {

/// Computes bounds from the values at a knot and at three on both sides of it. They apply to positive derivatives:
/// reverse signs of values so that those of the polynomials are positive.
class ShapeBounds {
   public:
    ShapeBounds(const KnotsAlong& knots, std::span<const double> values) : knots_(knots), values_(values) {}

    double largest_slope(std::size_t knot) const;
    double largest_curving(std::size_t knot) const;
    /// Returns whether there is an extremum between two equal values, smooth enough for four second differences to show
    /// it.
    bool is_top(std::ptrdiff_t piece) const;

   private:
    double chord(std::ptrdiff_t piece) const;
    /// Returns the second divided difference around a knot, or zero if one side is missing.
    double bend(std::ptrdiff_t knot) const;
    /// Returns how smooth the second differences around a knot are: 0 if the least is a quarter of the largest or less,
    /// 1 if it is a half or more.
    double smoothness(std::ptrdiff_t knot) const;

    const KnotsAlong& knots_;
    std::span<const double> values_;
};

inline constexpr double same_value = 1e-9;   ///< mm: largest difference of values that count as equal
inline constexpr double steepest_slope = 3;  ///< over the lesser chord

}  // namespace contactd::geometry

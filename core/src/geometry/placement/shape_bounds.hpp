// How steep a curve through values may be, and how bent, if it is to keep their shape.
#pragma once

#include <cstddef>
#include <span>

#include "geometry/placement/knots_along.hpp"

namespace contactd::geometry {

/// Bounds by the values at a knot and at three on both sides of it. They hold for derivatives that are positive: values
/// are to be turned so that those of the polynomials are.
class ShapeBounds {
   public:
    ShapeBounds(const KnotsAlong& knots, std::span<const double> values) : knots_(knots), values_(values) {}

    double largest_slope(std::size_t knot) const;
    double largest_curving(std::size_t knot) const;
    /// Returns whether the values turn between two equal ones, smoothly enough for four second differences to show it.
    bool is_top(std::ptrdiff_t piece) const;

   private:
    double chord(std::ptrdiff_t piece) const;
    /// Second divided difference around a knot; zero where one side is missing.
    double bend(std::ptrdiff_t knot) const;
    /// Measures how smooth the second differences around a knot are: 0 where the least is a quarter of the
    /// largest or less, 1 where it is a half or more.
    double smoothness(std::ptrdiff_t knot) const;

    const KnotsAlong& knots_;
    std::span<const double> values_;
};

inline constexpr double same_value = 1e-9;   ///< mm: of values that are equal
inline constexpr double steepest_slope = 3;  ///< over the lesser chord

}  // namespace contactd::geometry

// Computes curves from slice to slice, of all kinds that a set-up may request.
#pragma once

#include <span>
#include <vector>

#include "contactd/wheel_rail_setup.hpp"
#include "geometry/placement/quintic_spline.hpp"

namespace contactd::geometry {

/// Holds a curve by its values and derivatives at the knots. Between two knots it is the quintic with these ends, which
/// includes cubics.
struct LineAlong {
    std::vector<double> values;
    std::vector<KnotDerivatives> derivatives;

    /// Returns the value between a knot and the next one.
    double between(std::size_t knot, const QuinticWeights& weights) const {
        return values[knot] + weights.sum(values[knot + 1] - values[knot], derivatives[knot], derivatives[knot + 1]);
    }
};

/// Computes splines of one kind over common knots.
class SplineAlong {
   public:
    /// There are at least two ascending knots. With a period the first one follows the last one. Without a period, both
    /// ends of a cubic spline are natural, and an approximating one passes through the first and the last value. With a
    /// period, both end at pieces that are four times as wide as their neighbours, where nothing is known: they pass
    /// through the values there, with zero slope.
    SplineAlong(std::vector<double> knots, SliceSpline kind, double period = 0, EqualValues equal = EqualValues::stay);

    /// Returns the factors that the lines of all points of the slices share.
    std::vector<DerivativeShares> shares(std::span<const SlicePoints> slices) const;
    /// Returns the curve of a point from its values at the knots. An approximating spline does not pass through them.
    LineAlong line(std::vector<double> values, std::span<const DerivativeShares> shares) const;
    /// Returns the curve of slices with a single value each.
    LineAlong line(std::vector<double> values) const;

    const std::vector<double>& knots() const { return preserving_.knots(); }
    double width(std::size_t knot) const { return preserving_.width(knot); }

   private:
    double knot(std::ptrdiff_t index) const;
    double value(std::span<const double> values, std::ptrdiff_t index) const;
    LineAlong cubic(std::span<const double> values) const;
    LineAlong approximating(std::span<const double> values) const;
    LineAlong between_gaps(std::vector<double> values) const;
    bool is_gap(std::ptrdiff_t piece) const { return period_ > 0 && preserving_.along().support(piece) == 0; }

    QuinticSpline preserving_;
    SliceSpline kind_;
    double period_;
    bool has_gaps_ = false;
};

}  // namespace contactd::geometry

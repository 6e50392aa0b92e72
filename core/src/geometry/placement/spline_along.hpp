// Curves from slice to slice, of all kinds that a set-up may ask for.
#pragma once

#include <span>
#include <vector>

#include "contactd/wheel_rail_setup.hpp"
#include "geometry/placement/quintic_spline.hpp"

namespace contactd::geometry {

/// A curve by what it is at the knots; between two it is the quintic with these ends, which a cubic is, too.
struct LineAlong {
    std::vector<double> values;
    std::vector<KnotDerivatives> derivatives;

    /// Returns the value between a knot and the next one.
    double between(std::size_t knot, const QuinticWeights& weights) const {
        return values[knot] + weights.sum(values[knot + 1] - values[knot], derivatives[knot], derivatives[knot + 1]);
    }
};

/// Splines of one kind over common knots.
class SplineAlong {
   public:
    /// Knots ascend; there are two at least. With a period the first one comes again after it. Both ends of a cubic
    /// spline without a period are natural; an approximating one passes through the first value and the last. With a
    /// period both end at pieces that are four times as wide as those on both sides, where nothing is known: they pass
    /// through the values there, and have no slope.
    SplineAlong(std::vector<double> knots, SliceSpline kind, double period = 0, EqualValues equal = EqualValues::stay);

    /// Returns what the lines of all points of the slices have in common.
    std::vector<DerivativeShares> shares(std::span<const SlicePoints> slices) const;
    /// The curve of the values of a point at the knots, which those of an approximating spline are not.
    LineAlong line(std::vector<double> values, std::span<const DerivativeShares> shares) const;
    /// The curve of slices with a single value each.
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

// Computes curves from slice to slice with continuous curvature and without overshoot.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/placement/knots_along.hpp"
#include "geometry/placement/slice_shape.hpp"

namespace contactd::geometry {

/// Holds the first and second derivative at a knot.
struct KnotDerivatives {
    double slope = 0, curving = 0;
};

/// Computes derivatives at knots with which quintic Hermite splines through slices keep their shape.
///
/// If slices vary smoothly, the derivatives are those of the polynomials through five of them, so that the error of
/// curvature is of third order in the spacing. They are limited in three steps:
/// - Between slices that are equal to 1e-9 mm, values are constant (EqualValues): at both, the derivatives are zero.
/// - Slopes are at most three times the lesser chord (Fritsch and Carlson, SIAM J. Numer. Anal. 17, 1980). If the
///   second differences on both sides agree that slices pass an extremum, the limit is 1.5 times the parabolas' slope
///   (Huynh, SIAM J. Numer. Anal. 30, 1993), unless the piece between is much wider than its neighbours. Second
///   derivatives have the sign of the second difference.
/// - If a piece must ascend or descend throughout, the ordinates of its Bezier polygon must, which is sufficient: both
///   derivatives of a knot are scaled until they do.
/// Limits scale derivatives by factors that all points of a slice share. So the curve between slices is a weighted sum
/// of slices: between slices that are moved, tilted or stretched copies of one profile, all profiles are such copies,
/// whatever the rounding of their points. The spline of a single point that ascends or descends throughout does so as
/// well.
class QuinticSpline {
   public:
    /// There are at least two ascending knots. With a period the first one follows the last one.
    explicit QuinticSpline(std::vector<double> knots, double period = 0, EqualValues equal = EqualValues::stay);

    std::vector<DerivativeShares> shares(std::span<const SlicePoints> slices) const;
    /// Returns the derivatives at the knots for the values of one point at all slices.
    std::vector<KnotDerivatives> derivatives(std::span<const double> values,
                                             std::span<const DerivativeShares> shares) const;
    /// Returns the derivatives for slices with a single value each.
    std::vector<KnotDerivatives> derivatives(std::span<const double> values) const;

    const KnotsAlong& along() const { return knots_; }
    const std::vector<double>& knots() const { return knots_.all(); }
    /// Returns the distance from a knot to the next one; for the last one only with a period.
    double width(std::size_t knot) const { return knots_.width(static_cast<std::ptrdiff_t>(knot)); }

   private:
    DerivativeStencil stencil_at(std::size_t knot) const;

    KnotsAlong knots_;
    EqualValues equal_;
    std::vector<DerivativeStencil> stencils_;
};

/// Holds weights of the values and derivatives at both ends of a piece, at a fraction t of its width h.
struct QuinticWeights {
    double to, leaving, arriving, bending,
        unbending;  ///< value at the end minus that at the beginning; slopes; second derivatives

    static QuinticWeights of_value(double t, double h);
    static QuinticWeights of_slope(double t, double h);

    double sum(double rise, const KnotDerivatives& from, const KnotDerivatives& at_end) const {
        return to * rise + leaving * from.slope + arriving * at_end.slope + bending * from.curving +
               unbending * at_end.curving;
    }
};

/// Returns ordinates of the Bezier polygon of a piece, minus the value at its beginning.
std::array<double, 6> bezier_ordinates(double h, double rise, const KnotDerivatives& from, const KnotDerivatives& to);

}  // namespace contactd::geometry

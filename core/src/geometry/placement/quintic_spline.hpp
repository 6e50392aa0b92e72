// Curves from slice to slice whose curvature is continuous and that do not swing beyond the slices.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/placement/knots_along.hpp"
#include "geometry/placement/slice_shape.hpp"

namespace contactd::geometry {

/// First and second derivative at a knot.
struct KnotDerivatives {
    double slope = 0, curving = 0;
};

/// The derivatives at knots that make quintic Hermite splines through slices keep their shape.
///
/// Where slices vary smoothly the derivatives are those of the polynomials through five of them, so that curvature errs
/// by the third power of the spacing. They are limited in three steps:
/// - slices that are equal to 1e-9 mm are equal all between (EqualValues): at both, the derivatives are zero;
/// - slopes are three times the lesser chord at most (Fritsch and Carlson, SIAM J. Numer. Anal. 17, 1980), but where
///   the second differences on both sides agree that slices pass an extremum, 1.5 times the parabolas' slope (Huynh,
///   SIAM J. Numer. Anal. 30, 1993), unless the piece between is much wider than those beside it; second derivatives
///   have the sign of the second difference;
/// - where a piece is to ascend or descend throughout, the ordinates of its Bezier polygon must, which is sufficient:
///   both derivatives of a knot are scaled until they do.
/// Limits scale derivatives, by shares that all points of a slice have in common. So what lies between slices is a sum
/// of slices with weights: slices that are moved, tilted or stretched copies of one profile have such a copy all
/// between, whatever the rounding of their points. A single point that ascends or descends throughout is joined by a
/// spline that does, too.
class QuinticSpline {
   public:
    /// Knots ascend; there are two at least. With a period the first one comes again after it.
    explicit QuinticSpline(std::vector<double> knots, double period = 0, EqualValues equal = EqualValues::stay);

    std::vector<DerivativeShares> shares(std::span<const SlicePoints> slices) const;
    /// Returns the derivatives at the knots for the values of one point at all slices.
    std::vector<KnotDerivatives> derivatives(std::span<const double> values,
                                             std::span<const DerivativeShares> shares) const;
    /// Returns the derivatives for slices with a single value each.
    std::vector<KnotDerivatives> derivatives(std::span<const double> values) const;

    const KnotsAlong& along() const { return knots_; }
    const std::vector<double>& knots() const { return knots_.all(); }
    /// From a knot to the next one; of the last one with a period only.
    double width(std::size_t knot) const { return knots_.width(static_cast<std::ptrdiff_t>(knot)); }

   private:
    DerivativeStencil stencil_at(std::size_t knot) const;

    KnotsAlong knots_;
    EqualValues equal_;
    std::vector<DerivativeStencil> stencils_;
};

/// Weights of the values and derivatives at both ends of a piece, at a share t of its width h.
struct QuinticWeights {
    double to, leaving, arriving, bending,
        unbending;  ///< value at the end less that at the beginning; slopes; curvings

    static QuinticWeights of_value(double t, double h);
    static QuinticWeights of_slope(double t, double h);

    double sum(double rise, const KnotDerivatives& from, const KnotDerivatives& at_end) const {
        return to * rise + leaving * from.slope + arriving * at_end.slope + bending * from.curving +
               unbending * at_end.curving;
    }
};

/// Ordinates of the Bezier polygon of a piece, less the value at its beginning.
std::array<double, 6> bezier_ordinates(double h, double rise, const KnotDerivatives& from, const KnotDerivatives& to);

}  // namespace contactd::geometry

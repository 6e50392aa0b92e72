// Curves from slice to slice whose curvature is continuous and that do not swing beyond the slices.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace contactd::geometry {

/// First and second derivative at a knot.
struct KnotDerivatives {
    double slope = 0, curving = 0;
};

/// Whether values that are equal are equal all between: always, or unless the second differences at four knots around
/// agree that the values pass an extremum there.
enum class EqualValues { stay, may_flank_extremum };

/// The derivatives at knots that make a quintic Hermite spline through values keep their shape.
///
/// Where values are smooth the derivatives are those of the polynomials through five of them, so that curvature errs by
/// the third power of the spacing. They are limited in three steps:
/// - values that are equal to 1e-9 mm are equal all between (EqualValues): at both, the derivatives are zero;
/// - slopes are three times the lesser chord at most (Fritsch and Carlson, SIAM J. Numer. Anal. 17, 1980), but where
///   the second differences on both sides agree that values pass an extremum, 1.5 times the parabolas' slope (Huynh,
///   SIAM J. Numer. Anal. 30, 1993); second derivatives have the sign of the second difference;
/// - where a piece is to ascend or descend throughout, the ordinates of its Bezier polygon must, which is sufficient:
///   both derivatives of a knot are scaled until they do.
/// Values that ascend or descend throughout are joined by a spline that does, too.
class QuinticSpline {
   public:
    /// Knots ascend; there are two at least. With a period the first one comes again after it.
    explicit QuinticSpline(std::vector<double> knots, double period = 0, EqualValues equal = EqualValues::stay);

    std::vector<KnotDerivatives> derivatives(std::span<const double> values) const;

    const std::vector<double>& knots() const { return knots_; }
    /// From a knot to the next one; of the last one with a period only.
    double width(std::size_t knot) const;

   private:
    struct Stencil {
        std::vector<std::size_t> knots;
        std::vector<double> first, second;  // weights of both derivatives
    };
    class Limiter;

    Stencil stencil_at(std::size_t knot) const;
    std::ptrdiff_t wrapped(std::ptrdiff_t knot) const;
    double place(std::ptrdiff_t knot) const;

    std::vector<double> knots_;
    double period_;
    EqualValues equal_;
    std::vector<Stencil> stencils_;
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

// Implements the loops of the tangential solvers over the elements in contact without branches. Arrays have m values;
// those of one call do not overlap. n is the direction of the traction, p/g, in slip and zero in adhesion, so that
// projecting on the free components, a - (a . n) n, needs no branch.
#pragma once

#include <cstddef>

namespace contactd {

struct Vectors {
    const double *x, *y;
};
struct MutableVectors {
    double *x, *y;
    operator Vectors() const { return {x, y}; }
};

/// Returns a . b; the order of the sums is always the same.
double dot_product(std::size_t m, const double* a, const double* b);
/// Holds a . b and a . c.
struct TwoProducts {
    double b = 0, c = 0;
};
TwoProducts dot_products(std::size_t m, const double* a, const double* b, const double* c);
/// Holds arrays for to += sum factors[k] values[k].
struct FourArrays {
    double factors[4];
    const double* values[4];
};
void add_four(std::size_t m, const FourArrays& arrays, double* to);

/// Computes out = factor a.
void multiply(std::size_t m, const double* factor, const double* a, double* out);
/// Computes out = factor a + other b.
void multiply_two(std::size_t m, const double* factor, const double* a, const double* other, const double* b,
                  double* out);

/// Computes to += factor a.
void add_product(std::size_t m, const double* factor, const double* a, double* to);
/// Sets to = a where chosen.
void take_where(std::size_t m, const char* chosen, const double* a, double* to);

/// Changes a to a - (a . n) n.
void project_out(std::size_t m, Vectors n, MutableVectors a);

/// Computes n, the tangent stiffness D = max(-s . n, 0)/g, and the residual r = -s projected.
void linearise_law(std::size_t m, const char* slips, Vectors p, Vectors s, const double* inverse_g, MutableVectors n,
                   double* tangent_stiffness, MutableVectors r);

/// Applies the Jacobian to a step with a known response: the response projected, plus D times the step projected.
void jacobian_times(std::size_t m, Vectors n, const double* tangent_stiffness, Vectors step, Vectors response,
                    MutableVectors image);

/// Holds squares of the free part of a step and of the rest.
struct StepParts {
    double inside = 0, against = 0;
};
StepParts step_parts(std::size_t m, Vectors n, Vectors step);

/// Holds sums of both components of the free part of a step.
struct Sums {
    double x = 0, y = 0;
};
Sums free_sums(std::size_t m, Vectors n, Vectors step);
/// Returns sums of both components.
Sums sums(std::size_t m, Vectors a);
/// Returns the sum of squares of w with (x, y) added to it.
double squares_with(std::size_t m, Vectors w, double x, double y);

/// Returns the sum over slip of the squares of s . n where that is positive: slip along the traction.
double pushes(std::size_t m, Vectors n, Vectors s);

/// Computes p += step. Tractions that slip or are longer than g (1 + on_bound) are moved to g, and slip.
void move_tractions(std::size_t m, Vectors step, const double* g, double on_bound, MutableVectors p, char* slips);

/// Changes z to scale z + diagonal r, projected; returns the sum of its squares.
double combine(std::size_t m, const double* scale, const double* diagonal, Vectors r, Vectors n, MutableVectors z);

/// Changes v to z + beta v, projected; returns r . v.
double next_direction(std::size_t m, Vectors z, double beta, Vectors n, Vectors r, MutableVectors v);

/// Computes p += alpha v, in slip moved to g, and s += alpha q. Returns the squares of the change and of the effect of
/// scaling.
struct MoveParts {
    double change = 0, scaling = 0;
};
MoveParts move_along(std::size_t m, double alpha, Vectors v, Vectors q, const char* slips, const double* g,
                     MutableVectors p, MutableVectors s);

/// Computes out = numerator/(added + a).
void shifted_reciprocal(std::size_t m, const double* a, const double* added, const double* numerator, double* out);

/// Holds the stiffnesses at which one level passes into the next, and the diagonal that is added to a single element,
/// in units.
struct LevelPassages {
    double to_second, to_local, local_diagonal;
};
/// Computes the shares of two levels and of the remainder, for stiffnesses D of d units: first^2 = 1/(1 +
/// (d/to_second)^2), the remainder b = 1 - 1/(1 + (d/to_local)^2), second^2 the rest to 1; local = b/((d +
/// local_diagonal) unit).
void weigh_levels(std::size_t m, const LevelPassages& passages, double unit, const double* stiffness, double* first,
                  double* second, double* local);

/// Ends slip where s . p > push g.
void end_slip(std::size_t m, Vectors p, Vectors s, double push, const double* g, char* slips);

/// Computes the differences of tractions and slip to those before a step.
void take_differences(std::size_t m, Vectors p, Vectors s, Vectors before_p, Vectors before_s, double push,
                      const double* g, char* slips, MutableVectors change, MutableVectors response);

}  // namespace contactd

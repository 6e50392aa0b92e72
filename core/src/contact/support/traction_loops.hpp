// The loops of the tangential solvers over the elements in contact, free of branches. Arrays have m values; those of
// one call do not overlap. n is the direction of the traction, p/g, in slip and zero in adhesion, so that projecting on
// what is free, a - (a . n) n, needs no branch.
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

/// a . b; the order of the sums is always the same.
double dot_product(std::size_t m, const double* a, const double* b);
/// a . b and a . c
struct TwoProducts {
    double b = 0, c = 0;
};
TwoProducts dot_products(std::size_t m, const double* a, const double* b, const double* c);
/// to += sum factors[k] values[k]
struct FourArrays {
    double factors[4];
    const double* values[4];
};
void add_four(std::size_t m, const FourArrays& arrays, double* to);

/// out = factor a
void multiply(std::size_t m, const double* factor, const double* a, double* out);
/// out = factor a + other b
void multiply_two(std::size_t m, const double* factor, const double* a, const double* other, const double* b,
                  double* out);

/// to += factor a
void add_product(std::size_t m, const double* factor, const double* a, double* to);
/// to = a where chosen
void take_where(std::size_t m, const char* chosen, const double* a, double* to);

/// a -> a - (a . n) n
void project_out(std::size_t m, Vectors n, MutableVectors a);

/// n, the tangent stiffness D = max(-s . n, 0)/g, and the residual r = -s projected.
void linearise_law(std::size_t m, const char* slips, Vectors p, Vectors s, const double* inverse_g, MutableVectors n,
                   double* tangent_stiffness, MutableVectors r);

/// Applies the Jacobian to a step with a known response: the response projected, plus D times the step projected.
void jacobian_times(std::size_t m, Vectors n, const double* tangent_stiffness, Vectors step, Vectors response,
                    MutableVectors image);

/// Squares of a step along and across what is free.
struct StepParts {
    double inside = 0, against = 0;
};
StepParts step_parts(std::size_t m, Vectors n, Vectors step);

/// Sums of both components of a step, of what of it is free.
struct Sums {
    double x = 0, y = 0;
};
Sums free_sums(std::size_t m, Vectors n, Vectors step);
/// Sums of both components.
Sums sums(std::size_t m, Vectors a);
/// The sum of squares of w with (x, y) added to it.
double squares_with(std::size_t m, Vectors w, double x, double y);

/// The sum over slip of the squares of s . n where that is positive: slip along the traction.
double pushes(std::size_t m, Vectors n, Vectors s);

/// p += step; where it slips or is longer than g (1 + on_bound) it is brought to g, and slips.
void move_tractions(std::size_t m, Vectors step, const double* g, double on_bound, MutableVectors p, char* slips);

/// z -> scale z + diagonal r, projected; returns the sum of its squares.
double combine(std::size_t m, const double* scale, const double* diagonal, Vectors r, Vectors n, MutableVectors z);

/// v -> z + beta v, projected; returns r . v.
double next_direction(std::size_t m, Vectors z, double beta, Vectors n, Vectors r, MutableVectors v);

/// p += alpha v, in slip brought to g; s += alpha q. Returns the squares of the change and of what scaling did.
struct MoveParts {
    double change = 0, scaling = 0;
};
MoveParts move_along(std::size_t m, double alpha, Vectors v, Vectors q, const char* slips, const double* g,
                     MutableVectors p, MutableVectors s);

/// out = numerator/(added + a)
void shifted_reciprocal(std::size_t m, const double* a, const double* added, const double* numerator, double* out);

/// Stiffnesses at which one level passes into the next, and what an element adds where it is alone; in units.
struct LevelPassages {
    double to_second, to_local, local_diagonal;
};
/// Shares of two levels and of what is beyond, for stiffnesses D of d units: first^2 = 1/(1 + (d/to_second)^2), beyond
/// b = 1 - 1/(1 + (d/to_local)^2), second^2 the rest to 1; local = b/((d + local_diagonal) unit).
void weigh_levels(std::size_t m, const LevelPassages& passages, double unit, const double* stiffness, double* first,
                  double* second, double* local);

/// Slip ends where s . p > push g.
void end_slip(std::size_t m, Vectors p, Vectors s, double push, const double* g, char* slips);

/// Takes the differences of tractions and slips to those before a step.
void take_differences(std::size_t m, Vectors p, Vectors s, Vectors before_p, Vectors before_s, double push,
                      const double* g, char* slips, MutableVectors change, MutableVectors response);

}  // namespace contactd

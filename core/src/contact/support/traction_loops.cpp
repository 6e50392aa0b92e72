#include "traction_loops.hpp"

#include <algorithm>
#include <cmath>

#include "types/simd.hpp"

// `omp simd` does not need OpenMP at run time. It states that arrays do not overlap, and allows sums to be computed in
// several parts.
namespace contactd {

// Four partial sums of four numbers are computed side by side, because each addition waits for the previous one.
CONTACTD_SIMD
double dot_product(std::size_t m, const double* __restrict a, const double* __restrict b) {
    Four sums[4] = {};
    std::size_t e = 0;
    for (; e + 16 <= m; e += 16)
        for (std::size_t k = 0; k < 4; ++k) sums[k] += four(a + e + 4 * k) * four(b + e + 4 * k);
    const Four four_sums = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    double sum = (four_sums[0] + four_sums[1]) + (four_sums[2] + four_sums[3]);
    for (; e < m; ++e) sum += a[e] * b[e];
    return sum;
}

CONTACTD_SIMD
TwoProducts dot_products(std::size_t m, const double* __restrict a, const double* __restrict b,
                         const double* __restrict c) {
    Four with_b[2] = {}, with_c[2] = {};
    std::size_t e = 0;
    for (; e + 8 <= m; e += 8)
        for (std::size_t k = 0; k < 2; ++k) {
            const Four& here = four(a + e + 4 * k);
            with_b[k] += here * four(b + e + 4 * k);
            with_c[k] += here * four(c + e + 4 * k);
        }
    const Four b_sums = with_b[0] + with_b[1], c_sums = with_c[0] + with_c[1];
    TwoProducts sum{(b_sums[0] + b_sums[1]) + (b_sums[2] + b_sums[3]),
                    (c_sums[0] + c_sums[1]) + (c_sums[2] + c_sums[3])};
    for (; e < m; ++e) {
        sum.b += a[e] * b[e];
        sum.c += a[e] * c[e];
    }
    return sum;
}

CONTACTD_SIMD
void add_four(std::size_t m, const FourArrays& arrays, double* __restrict to) {
    // clang does not accept structured bindings in an OpenMP loop.
    const double p = arrays.factors[0], q = arrays.factors[1], r = arrays.factors[2], s = arrays.factors[3];
    const double *a = arrays.values[0], *b = arrays.values[1], *c = arrays.values[2], *d = arrays.values[3];
#pragma omp simd
    for (std::size_t e = 0; e < m; ++e) to[e] += (p * a[e] + q * b[e]) + (r * c[e] + s * d[e]);
}

CONTACTD_SIMD
void multiply(std::size_t m, const double* __restrict factor, const double* __restrict a, double* __restrict out) {
    for (std::size_t e = 0; e < m; ++e) out[e] = factor[e] * a[e];
}

CONTACTD_SIMD
void multiply_two(std::size_t m, const double* __restrict factor, const double* __restrict a,
                  const double* __restrict other, const double* b, double* out) {
    // out and b may be the same array.
#pragma omp simd
    for (std::size_t e = 0; e < m; ++e) out[e] = factor[e] * a[e] + other[e] * b[e];
}

CONTACTD_SIMD
void add_product(std::size_t m, const double* __restrict factor, const double* __restrict a, double* __restrict to) {
#pragma omp simd
    for (std::size_t e = 0; e < m; ++e) to[e] += factor[e] * a[e];
}

CONTACTD_SIMD
void take_where(std::size_t m, const char* __restrict chosen, const double* __restrict a, double* __restrict to) {
#pragma omp simd
    for (std::size_t e = 0; e < m; ++e) to[e] = chosen[e] != 0 ? a[e] : to[e];
}

CONTACTD_SIMD
void project_out(std::size_t m, Vectors n, MutableVectors a) {
#pragma omp simd
    for (std::size_t e = 0; e < m; ++e) {
        const double along = a.x[e] * n.x[e] + a.y[e] * n.y[e];
        a.x[e] -= along * n.x[e];
        a.y[e] -= along * n.y[e];
    }
}

CONTACTD_SIMD
void linearise_law(std::size_t m, const char* slips, Vectors p, Vectors s, const double* inverse_g, MutableVectors n,
                   double* tangent_stiffness, MutableVectors r) {
#pragma omp simd
    for (std::size_t e = 0; e < m; ++e) {
        const double scale = slips[e] != 0 ? inverse_g[e] : 0;
        const double x = p.x[e] * scale, y = p.y[e] * scale, along = s.x[e] * x + s.y[e] * y;
        n.x[e] = x;
        n.y[e] = y;
        tangent_stiffness[e] = (along < 0 ? -along : 0) * inverse_g[e];
        r.x[e] = along * x - s.x[e];
        r.y[e] = along * y - s.y[e];
    }
}

CONTACTD_SIMD
void jacobian_times(std::size_t m, Vectors n, const double* tangent_stiffness, Vectors step, Vectors response,
                    MutableVectors image) {
#pragma omp simd
    for (std::size_t e = 0; e < m; ++e) {
        const double x = response.x[e] + tangent_stiffness[e] * step.x[e],
                     y = response.y[e] + tangent_stiffness[e] * step.y[e];
        const double along = x * n.x[e] + y * n.y[e];
        image.x[e] = x - along * n.x[e];
        image.y[e] = y - along * n.y[e];
    }
}

CONTACTD_SIMD
StepParts step_parts(std::size_t m, Vectors n, Vectors step) {
    double all = 0, against = 0;
#pragma omp simd reduction(+ : all, against)
    for (std::size_t e = 0; e < m; ++e) {
        const double x = step.x[e], y = step.y[e], across = x * n.x[e] + y * n.y[e];
        all += x * x + y * y;
        against += across * across;
    }
    return {all - against, against};
}

CONTACTD_SIMD
Sums free_sums(std::size_t m, Vectors n, Vectors step) {
    double sum_x = 0, sum_y = 0;
#pragma omp simd reduction(+ : sum_x, sum_y)
    for (std::size_t e = 0; e < m; ++e) {
        const double along = step.x[e] * n.x[e] + step.y[e] * n.y[e];
        sum_x += step.x[e] - along * n.x[e];
        sum_y += step.y[e] - along * n.y[e];
    }
    return {sum_x, sum_y};
}

CONTACTD_SIMD
Sums sums(std::size_t m, Vectors a) {
    double x = 0, y = 0;
#pragma omp simd reduction(+ : x, y)
    for (std::size_t e = 0; e < m; ++e) {
        x += a.x[e];
        y += a.y[e];
    }
    return {x, y};
}

CONTACTD_SIMD
double squares_with(std::size_t m, Vectors w, double x, double y) {
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t e = 0; e < m; ++e) sum += (w.x[e] + x) * (w.x[e] + x) + (w.y[e] + y) * (w.y[e] + y);
    return sum;
}

CONTACTD_SIMD
double pushes(std::size_t m, Vectors n, Vectors s) {
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t e = 0; e < m; ++e) {
        const double along = s.x[e] * n.x[e] + s.y[e] * n.y[e], push = along > 0 ? along : 0;
        sum += push * push;
    }
    return sum;
}

CONTACTD_SIMD
void move_tractions(std::size_t m, Vectors step, const double* g, double on_bound, MutableVectors p, char* slips) {
#pragma omp simd
    for (std::size_t e = 0; e < m; ++e) {
        const double x = p.x[e] + step.x[e], y = p.y[e] + step.y[e];
        const double square = x * x + y * y, bound = g[e] * (1 + on_bound);
        const bool beyond = square > bound * bound, slipping = (beyond | (slips[e] != 0)) & (square > 0);
        const double factor = slipping ? g[e] / std::sqrt(square) : 1;
        p.x[e] = x * factor;
        p.y[e] = y * factor;
        slips[e] = slipping ? 1 : 0;
    }
}

CONTACTD_SIMD
double combine(std::size_t m, const double* scale, const double* diagonal, Vectors r, Vectors n, MutableVectors z) {
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t e = 0; e < m; ++e) {
        const double x = scale[e] * z.x[e] + diagonal[e] * r.x[e], y = scale[e] * z.y[e] + diagonal[e] * r.y[e];
        const double along = x * n.x[e] + y * n.y[e];
        z.x[e] = x - along * n.x[e];
        z.y[e] = y - along * n.y[e];
        sum += z.x[e] * z.x[e] + z.y[e] * z.y[e];
    }
    return sum;
}

CONTACTD_SIMD
double next_direction(std::size_t m, Vectors z, double beta, Vectors n, Vectors r, MutableVectors v) {
    double slope = 0;
#pragma omp simd reduction(+ : slope)
    for (std::size_t e = 0; e < m; ++e) {
        const double x = z.x[e] + beta * v.x[e], y = z.y[e] + beta * v.y[e];
        const double along = x * n.x[e] + y * n.y[e];
        v.x[e] = x - along * n.x[e];
        v.y[e] = y - along * n.y[e];
        slope += r.x[e] * v.x[e] + r.y[e] * v.y[e];
    }
    return slope;
}

CONTACTD_SIMD
MoveParts move_along(std::size_t m, double alpha, Vectors v, Vectors q, const char* slips, const double* g,
                     MutableVectors p, MutableVectors s) {
    double change = 0, scaling = 0;
#pragma omp simd reduction(+ : change, scaling)
    for (std::size_t e = 0; e < m; ++e) {
        double x = p.x[e] + alpha * v.x[e], y = p.y[e] + alpha * v.y[e];
        const double length = std::sqrt(x * x + y * y), beyond = slips[e] != 0 ? length - g[e] : 0;
        const double factor = slips[e] != 0 ? g[e] / length : 1;
        scaling += beyond * beyond;
        x *= factor;
        y *= factor;
        change += (x - p.x[e]) * (x - p.x[e]) + (y - p.y[e]) * (y - p.y[e]);
        p.x[e] = x;
        p.y[e] = y;
        s.x[e] += alpha * q.x[e];
        s.y[e] += alpha * q.y[e];
    }
    return {change, scaling};
}

CONTACTD_SIMD
void shifted_reciprocal(std::size_t m, const double* a, const double* added, const double* numerator,
                        double* __restrict out) {
    for (std::size_t e = 0; e < m; ++e) out[e] = numerator[e] / (added[e] + a[e]);
}

CONTACTD_SIMD
void weigh_levels(std::size_t m, const LevelPassages& passages, double unit, const double* __restrict stiffness,
                  double* __restrict first, double* __restrict second, double* __restrict local) {
    const double to_unit = 1 / unit, self = passages.local_diagonal;
    const double low = passages.to_second * passages.to_second, high = passages.to_local * passages.to_local;
#pragma omp simd
    for (std::size_t e = 0; e < m; ++e) {
        const double d = stiffness[e] * to_unit, square = d * d;
        const double lowest = low / (low + square), beyond = square / (high + square);
        first[e] = std::sqrt(lowest);
        second[e] = std::sqrt(std::max(1 - lowest - beyond, 0.0));
        local[e] = beyond * to_unit / (d + self);
    }
}

CONTACTD_SIMD
void end_slip(std::size_t m, Vectors p, Vectors s, double push, const double* g, char* slips) {
#pragma omp simd
    for (std::size_t e = 0; e < m; ++e) {
        const bool pushed_back = s.x[e] * p.x[e] + s.y[e] * p.y[e] > push * g[e];
        slips[e] = pushed_back ? 0 : slips[e];
    }
}

CONTACTD_SIMD
void take_differences(std::size_t m, Vectors p, Vectors s, Vectors before_p, Vectors before_s, double push,
                      const double* g, char* slips, MutableVectors change, MutableVectors response) {
#pragma omp simd
    for (std::size_t e = 0; e < m; ++e) {
        const bool pushed_back = s.x[e] * p.x[e] + s.y[e] * p.y[e] > push * g[e];
        slips[e] = pushed_back ? 0 : slips[e];
        change.x[e] = p.x[e] - before_p.x[e];
        change.y[e] = p.y[e] - before_p.y[e];
        response.x[e] = s.x[e] - before_s.x[e];
        response.y[e] = s.y[e] - before_s.y[e];
    }
}

}  // namespace contactd

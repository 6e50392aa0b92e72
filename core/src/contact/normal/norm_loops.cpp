#include "norm_loops.hpp"

#include <cmath>

#include "types/simd.hpp"

// `omp simd` allows sums to be computed in several parts.
namespace contactd {

CONTACTD_SIMD
NormViolations advance(const NormState& state, double alpha, const double* __restrict v, const double* __restrict q,
                       double approach, double rounding) {
    const double* const __restrict in = state.in, * const __restrict h = state.h;
    double* const __restrict p = state.p, * const __restrict u = state.u, * const __restrict r = state.r;
    const double approach_size = std::abs(approach);
    double defect = 0, reference = 0, suction = 0, overlap = 0;
#pragma omp simd reduction(+ : defect, reference, suction, overlap)
    for (std::size_t i = 0; i < state.n; ++i) {
        const double p_i = p[i] + alpha * v[i], u_i = u[i] + alpha * q[i], in_i = in[i];
        const double distance = h[i] - approach, gap = u_i + distance, r_i = -in_i * gap;
        p[i] = p_i;
        u[i] = u_i;
        r[i] = r_i;
        const double reference_i = in_i * distance, suction_i = p_i < 0 ? p_i : 0;
        const double deepest = gap + rounding * (std::abs(u_i) + std::abs(h[i]) + approach_size);
        const double overlap_i = (1 - in_i) * (deepest < 0 ? deepest : 0);
        defect += r_i * r_i;
        reference += reference_i * reference_i;
        suction += suction_i * suction_i;
        overlap += overlap_i * overlap_i;
    }
    return {defect, reference, suction, overlap};
}

CONTACTD_SIMD
double mean_distance(const NormState& state) {
    const double *const in = state.in, *const h = state.h, *const u = state.u;
    double sum = 0, count = 0;
#pragma omp simd reduction(+ : sum, count)
    for (std::size_t i = 0; i < state.n; ++i) {
        sum += in[i] * (u[i] + h[i]);
        count += in[i];
    }
    return sum / count;
}

CONTACTD_SIMD
double potential(const NormState& state) {
    const double *const p = state.p, *const u = state.u, *const h = state.h;
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = 0; i < state.n; ++i) sum += p[i] * (0.5 * u[i] + h[i]);
    return sum;
}

CONTACTD_SIMD
void update_direction(std::size_t n, const double* __restrict in, const double* __restrict z, double beta,
                      double* __restrict v) {
#pragma omp simd
    for (std::size_t i = 0; i < n; ++i) v[i] = in[i] * z[i] + beta * v[i];
}

CONTACTD_SIMD
void add_multiple(std::size_t n, double factor, const double* __restrict x, double* __restrict y) {
#pragma omp simd
    for (std::size_t i = 0; i < n; ++i) y[i] += factor * x[i];
}

CONTACTD_SIMD
double triple_product(std::size_t n, const double* a, const double* b, const double* c) {
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = 0; i < n; ++i) sum += a[i] * b[i] * c[i];
    return sum;
}

CONTACTD_SIMD
NormSlope slope_along(const NormState& state, const double* v, const double* q) {
    const double *const in = state.in, *const r = state.r;
    double curvature = 0, slope = 0, rise = 0, count = 0;
#pragma omp simd reduction(+ : curvature, slope, rise, count)
    for (std::size_t i = 0; i < state.n; ++i) {
        curvature += v[i] * q[i];
        slope += r[i] * v[i];
        rise += in[i] * q[i];
        count += in[i];
    }
    return {curvature, slope, rise, count};
}

}  // namespace contactd

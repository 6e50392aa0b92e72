#include "contraction.hpp"

#include <cstddef>

#include "types/simd.hpp"

namespace contactd::creep_table {
namespace {

/// Represents two adjacent coefficients along u.
using Eight [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = float;

/// Holds the coefficients of four B-splines in u, each of (Fx, Fy, Mz/c, 0).
struct Row {
    Eight low{}, high{};

    CONTACTD_INLINE void add(float weight, const Row& row) {
        low += weight * row.low;
        high += weight * row.high;
    }
};

CONTACTD_INLINE const Row row_at(const float* knot) {
    return {*reinterpret_cast<const Eight*>(knot), *reinterpret_cast<const Eight*>(knot + 8)};
}

CONTACTD_INLINE void add_along_u(const Row& row, const float (&weights)[4], float (&sums)[4]) {
    for (int c = 0; c < 4; ++c)
        sums[c] += weights[0] * row.low[c] + weights[1] * row.low[c + 4] + weights[2] * row.high[c] +
                   weights[3] * row.high[c + 4];
}

}  // namespace

// The sums over a/b come first, then z_b and z_a, so that each of the 64 rows is read once.
CONTACTD_SIMD
static void contract(const float* corner, const std::ptrdiff_t (&strides)[3], const SplineWeights<float> (&weights)[4],
                     SplineSums& sums) {
    const auto &R = weights[log_ratio], &A = weights[z_a], &B = weights[z_b], &U = weights[u];
    Row sum, by_ratio, by_a, by_b;
    for (int i = 0; i < 4; ++i) {
        Row of_a, of_a_by_ratio, of_a_by_b;
        for (int j = 0; j < 4; ++j) {
            const float* const first = corner + i * strides[z_a] + j * strides[z_b];
            Row of_b, of_b_by_ratio;
            for (int k = 0; k < 4; ++k) {
                const Row row = row_at(first + k * strides[log_ratio]);
                of_b.add(R.value[k], row);
                of_b_by_ratio.add(R.slope[k], row);
            }
            of_a.add(B.value[j], of_b);
            of_a_by_b.add(B.slope[j], of_b);
            of_a_by_ratio.add(B.value[j], of_b_by_ratio);
        }
        sum.add(A.value[i], of_a);
        by_a.add(A.slope[i], of_a);
        by_b.add(A.value[i], of_a_by_b);
        by_ratio.add(A.value[i], of_a_by_ratio);
    }
    add_along_u(sum, U.value, sums.value);
    add_along_u(by_ratio, U.value, sums.slope[log_ratio]);
    add_along_u(by_a, U.value, sums.slope[z_a]);
    add_along_u(by_b, U.value, sums.slope[z_b]);
    add_along_u(sum, U.slope, sums.slope[u]);
}

void add_spline(const TableAxes& axes, const float* coefficients, const std::array<double, axis_count>& point,
                SplineSums& sums) {
    const SplineWeights<float> weights[4]{
        {axes[0], point[0]}, {axes[1], point[1]}, {axes[2], point[2]}, {axes[3], point[3]}};
    const std::ptrdiff_t row = 4 * axes[u].coefficients();
    const std::ptrdiff_t strides[3]{row * axes[z_b].coefficients() * axes[z_a].coefficients(),
                                    row * axes[z_b].coefficients(), row};
    const float* const corner = coefficients + weights[log_ratio].cell * strides[log_ratio] +
                                weights[z_a].cell * strides[z_a] + weights[z_b].cell * strides[z_b] +
                                4 * weights[u].cell;
    contract(corner, strides, weights, sums);
}

}  // namespace contactd::creep_table

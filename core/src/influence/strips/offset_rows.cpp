#include "offset_rows.hpp"

#include <algorithm>
#include <vector>

#include "contactd/finite.hpp"
#include "types/simd.hpp"

namespace contactd {
namespace {

// This number of sums fits into registers.
constexpr std::size_t rows_at_once = 4, offsets_at_once = 8;

}  // namespace

/// `nx` is a multiple of offsets_at_once. Vectors are named variables, because compilers would vectorise over
/// functions, not offsets.
CONTACTD_SIMD
static void add_up_block(std::size_t count, std::size_t nx, const double* __restrict shares,
                         const double* __restrict functions, double* __restrict sums) {
    for (std::size_t k = 0; k < nx; k += offsets_at_once) {
        Four low[rows_at_once] = {}, high[rows_at_once] = {};
        for (std::size_t n = 0; n < count; ++n) {
            const Four &here = four(functions + n * nx + k), &next = four(functions + n * nx + k + 4);
            for (std::size_t r = 0; r < rows_at_once; ++r) {
                low[r] += shares[r * count + n] * here;
                high[r] += shares[r * count + n] * next;
            }
        }
        for (std::size_t r = 0; r < rows_at_once; ++r) {
            four(sums + r * nx + k) = low[r];
            four(sums + r * nx + k + 4) = high[r];
        }
    }
}

bool add_up(std::span<const OffsetRows> rows, double parity, const double* shares, const double* functions,
            std::size_t count, std::size_t nx) {
    const std::size_t whole = (nx + offsets_at_once - 1) / offsets_at_once * offsets_at_once;
    std::vector<double> padded(count * whole), some(rows_at_once * count), sums(rows_at_once * whole);
    for (std::size_t n = 0; n < count; ++n) std::copy_n(functions + n * nx, nx, padded.data() + n * whole);
    bool finite = true;
    for (std::size_t first = 0; first < rows.size(); first += rows_at_once) {
        const std::size_t now = std::min(rows_at_once, rows.size() - first);
        std::copy_n(shares + first * count, now * count, some.data());
        add_up_block(count, whole, some.data(), padded.data(), sums.data());
        finite = all_finite({sums.data(), now * whole}) && finite;
        for (std::size_t r = 0; r < now; ++r) {
            const double* sum = sums.data() + r * whole;
            std::copy_n(sum, nx, rows[first + r].own);
            if (double* mirrored = rows[first + r].mirrored)
                std::transform(sum, sum + nx, mirrored, [&](double value) { return parity * value; });
        }
    }
    return finite;
}

}  // namespace contactd

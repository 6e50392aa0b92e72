// Computes rows of a table of strips as sums of functions of the offset.
#pragma once

#include <cstddef>
#include <span>

namespace contactd {

/// Points to the coefficients of two strips, and to those of both in reverse.
struct OffsetRows {
    double* own;
    double* mirrored;  ///< null: not computed
};

/// Computes rows[r].own[k] as the sum over n of shares[r, n] functions[n, k], and rows[r].mirrored[k] as parity times
/// the same. `functions` has shape [count, nx], `shares` [rows, count]. Returns false if a sum is not finite.
bool add_up(std::span<const OffsetRows> rows, double parity, const double* shares, const double* functions,
            std::size_t count, std::size_t nx);

}  // namespace contactd

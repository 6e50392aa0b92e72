// Rows of a table of strips as sums of functions of the offset.
#pragma once

#include <cstddef>
#include <span>

namespace contactd {

/// Where the coefficients of two strips go, and those of both in reverse.
struct OffsetRows {
    double* own;
    double* mirrored;  ///< null: nowhere
};

/// rows[r].own[k] = the sum over n of shares[r, n] functions[n, k], and rows[r].mirrored[k] = parity times the same.
/// `functions` has shape [count, nx], `shares` [rows, count]. False: a sum is not finite.
bool add_up(std::span<const OffsetRows> rows, double parity, const double* shares, const double* functions,
            std::size_t count, std::size_t nx);

}  // namespace contactd

#include "inverse_symbols.hpp"

#include <algorithm>
#include <cmath>

namespace contactd {
namespace {

// The symbol of a half-space exceeds 0.08 times the diagonal even for elements of 1:1000. This part of the diagonal is
// the least value here, so that the reciprocal is positive even if truncation or errors of the table made the symbol
// negative.
constexpr double smallest_symbol = 0.02;
// This limits the symbol of xy in units of sqrt(xx yy): a half-space has nu/(2 - nu), at most 1/3.
constexpr double largest_coupling = 0.6;

}  // namespace

PaddedFft::Kernel kernel_of(const IcTable& table, Axis i, Axis j) {
    return {&table.values[table.index(i, j, 0, 0)], table.nx, table.ny, parity(i, j)};
}

PaddedFft::Symbol reciprocal_symbol(const PaddedFft& fft, const IcTable& table, Axis i) {
    PaddedFft::Symbol values = fft.symbol(kernel_of(table, i, i));
    const double factor = fft.norm_factor();
    const double least = smallest_symbol * table(i, i, 0, 0) * factor;
    for (double& value : values) value = factor * factor / std::max(value, least);
    return values;
}

TangentialInverse tangential_inverse(const PaddedFft& fft, const IcTable& table) {
    using enum Axis;
    TangentialInverse made{fft.symbol(kernel_of(table, x, x)), fft.symbol(kernel_of(table, y, y)),
                           fft.symbol(kernel_of(table, x, y))};
    const PaddedFft::Symbol yx = fft.symbol(kernel_of(table, y, x));
    const double factor = fft.norm_factor();
    const double least_x = smallest_symbol * table(x, x, 0, 0) * factor;
    const double least_y = smallest_symbol * table(y, y, 0, 0) * factor;
    for (std::size_t at = 0; at < yx.size(); ++at) {
        const double a = std::max(made.xx[at], least_x), b = std::max(made.yy[at], least_y);
        const double most = largest_coupling * std::sqrt(a * b);
        const double c = std::clamp(0.5 * (made.xy[at] + yx[at]), -most, most);
        const double scale = factor * factor / (a * b - c * c);
        made.xx[at] = scale * b;
        made.yy[at] = scale * a;
        made.xy[at] = -scale * c;
    }
    return made;
}

}  // namespace contactd

#include "table_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "contactd/given_ics.hpp"

namespace contactd {
namespace {

using enum Axis;

bool couples(const StripTable& table) {
    double self = 0, largest = 0;
    for (int I = 0; I < table.strips; ++I) self = std::max(self, table(z, z, I, I, 0));
    for (const auto& [i, j] : {std::pair{x, z}, {y, z}, {z, x}, {z, y}}) {
        const double* values = &table.values[table.index(i, j, 0, 0, 0)];
        for (std::size_t at = 0; at < table.component_size(); ++at) largest = std::max(largest, std::abs(values[at]));
    }
    return largest > coupling_tolerance * self;
}

std::vector<double> times(double factor, std::span<const double> values) {
    std::vector<double> result(values.begin(), values.end());
    for (double& value : result) value *= factor;
    return result;
}

}  // namespace

TableCoefficients::TableCoefficients(StripTable table) : table_(std::move(table)), coupled_(couples(table_)) {}

std::size_t TableCoefficients::bytes_of(int nx, int strips) {
    constexpr std::size_t of_table = 9, of_symbols = 7, of_boxes = 4;  // numbers per pair of strips and offset
    return static_cast<std::size_t>(nx) * static_cast<std::size_t>(strips) * static_cast<std::size_t>(strips) *
           (of_table + of_symbols + of_boxes) * sizeof(double);
}

// Calls set(I, J, transform) for all pairs of strips of the extent; if i = j, only for those with J <= I.
template <class Set>
void TableCoefficients::for_pairs(const SymbolExtent& extent, const StripFft& fft, Axis i, Axis j,
                                  const Set& set) const {
    const double sign = parity(i, j).along_x;
    const bool even = (sign > 0) == extent.natural();
    std::vector<double> kernel(static_cast<std::size_t>(extent.offsets)), transform(fft.groups() * Waves::lanes);
    StripWork work(fft, 1);
    const auto strips = static_cast<std::size_t>(extent.strips);
    for (std::size_t I = 0; I < strips; ++I)
        for (std::size_t J = 0; J < (i == j ? I + 1 : strips); ++J) {
            const int at = extent.first_strip + static_cast<int>(I), from = extent.first_strip + static_cast<int>(J);
            const double* here = &table_.values[table_.index(i, j, at, from, 0)];
            const double* there = &table_.values[table_.index(j, i, from, at, 0)];
            for (std::size_t k = 0; k < kernel.size(); ++k) kernel[k] = 0.5 * (here[k] + sign * there[k]);
            fft.symbol(kernel, even, extent.joint, transform, work);
            set(I, J, std::span<const double>(transform));
        }
}

SymmetricSymbol TableCoefficients::normal(const SymbolExtent& extent, const StripFft& fft) const {
    const auto strips = static_cast<std::size_t>(extent.strips);
    SymmetricSymbol symbol(fft.groups(), strips + strips % 2);
    for_pairs(extent, fft, z, z, [&](std::size_t I, std::size_t J, auto transform) { symbol.set(I, J, transform); });
    symbol.trim(extent.left_out);
    return symbol;
}

SymmetricSymbol TableCoefficients::tangential(const SymbolExtent& extent, const StripFft& fft) const {
    SymmetricSymbol symbol(fft.groups(), 2 * static_cast<std::size_t>(extent.strips));
    for_pairs(extent, fft, x, x,
              [&](std::size_t I, std::size_t J, auto transform) { symbol.set(2 * I, 2 * J, transform); });
    for_pairs(extent, fft, y, y,
              [&](std::size_t I, std::size_t J, auto transform) { symbol.set(2 * I + 1, 2 * J + 1, transform); });
    for_pairs(extent, fft, y, x, [&](std::size_t I, std::size_t J, auto transform) {
        symbol.set(2 * I + 1, 2 * J, times(extent.natural() ? 1 : -1, transform));
    });
    symbol.trim(extent.left_out);
    return symbol;
}

RectangularSymbol TableCoefficients::coupling(const SymbolExtent& extent, const StripFft& fft) const {
    const auto strips = static_cast<std::size_t>(extent.strips);
    RectangularSymbol symbol(fft.groups(), 2 * strips, strips + strips % 2);
    for_pairs(extent, fft, x, z, [&](std::size_t I, std::size_t J, auto transform) {
        symbol.set(2 * I, J, times(extent.natural() ? -1 : 1, transform));
    });
    for_pairs(extent, fft, y, z,
              [&](std::size_t I, std::size_t J, auto transform) { symbol.set(2 * I + 1, J, transform); });
    symbol.trim(extent.left_out);
    return symbol;
}

std::shared_ptr<const StripCoefficients> TableCoefficients::coarse(const ElementBox& box, int along_x,
                                                                   int along_y) const {
    const auto number = [](int n, int factor) { return (n + factor - 1) / factor; };
    StripTable result(number(box.nx, along_x), number(box.ny, along_y));
    // If one of a pair of strips lies beyond the last, both are moved back by that much.
    const auto values_of = [&](Axis i, Axis j, int I, int J) {
        const int beyond = std::max({I - (box.ny - 1), J - (box.ny - 1), 0});
        const int at = box.first_y + std::max(I - beyond, 0), from = box.first_y + std::max(J - beyond, 0);
        return &table_.values[table_.index(i, j, at, from, 0)];
    };
    const int last = table_.nx - 1;
    std::vector<double> sums(static_cast<std::size_t>(table_.nx));  // over the pairs of strips of one coarse pair
    const auto fill = [&](Axis i, Axis j, int I, int J) {
        std::fill(sums.begin(), sums.end(), 0.0);
        for (int a = 0; a < along_y; ++a)
            for (int b = 0; b < along_y; ++b) {
                const double* values = values_of(i, j, I * along_y + a, J * along_y + b);
                for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += values[k];
            }
        const double sign = parity(i, j).along_x;
        double* mean = &result(i, j, I, J, 0);
        for (int k = 1 - along_x; k < along_x; ++k) {
            const double weight = static_cast<double>(along_x - std::abs(k)) / along_x / along_y;
            for (int K = 0; K < result.nx; ++K) {
                const int offset = std::min(K * along_x + k, last);
                const double sum = sums[static_cast<std::size_t>(std::abs(offset))];
                mean[K] += weight * (offset < 0 ? sign * sum : sum);
            }
        }
    };
    const auto components = coupled_ ? std::vector{x, y, z} : std::vector{x, y};
    for (int I = 0; I < result.strips; ++I)
        for (int J = 0; J < result.strips; ++J) {
            for (const Axis i : components)
                for (const Axis j : components) fill(i, j, I, J);
            if (!coupled_) fill(z, z, I, J);
        }
    return std::make_shared<const TableCoefficients>(std::move(result));
}

}  // namespace contactd

#include "column_products.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "convolution.hpp"

namespace contactd {
namespace {

using enum Axis;

std::vector<double> times(double factor, std::span<const double> values) {
    std::vector<double> result(values.begin(), values.end());
    for (double& value : result) value *= factor;
    return result;
}

constexpr auto copy = [](std::span<double> u, const double* values) { std::copy_n(values, u.size(), u.begin()); };
constexpr auto add = [](std::span<double> u, const double* values) {
    for (std::size_t k = 0; k < u.size(); ++k) u[k] += values[k];
};

}  // namespace

ColumnProducts::ColumnProducts(std::shared_ptr<const ColumnTable> table, const ElementBox& box, int reach,
                               OffsetParity parity)
    : table_(std::move(table)),
      box_(box),
      parity_(parity),
      offsets_(box.nx + reach),
      period_(smooth_size(2 * offsets_ - 1)),
      columns_(static_cast<std::size_t>(box.ny)),
      fft_(box.nx, period_) {}

// Calls set(I, J, transform) of all pairs of columns of the box, where i = j of those with J <= I.
template <class Set>
void ColumnProducts::for_pairs(Axis i, Axis j, const Set& set) const {
    const double sign = parity(i, j).along_x;
    const bool even = (sign > 0) == (parity_ == OffsetParity::natural);
    std::vector<double> kernel(static_cast<std::size_t>(offsets_)), transform(fft_.groups() * Waves::lanes);
    for (std::size_t I = 0; I < columns_; ++I)
        for (std::size_t J = 0; J < (i == j ? I + 1 : columns_); ++J) {
            const int at = box_.first_y + static_cast<int>(I), from = box_.first_y + static_cast<int>(J);
            const double* here = &table_->values[table_->index(i, j, at, from, 0)];
            const double* there = &table_->values[table_->index(j, i, from, at, 0)];
            for (std::size_t k = 0; k < kernel.size(); ++k) kernel[k] = 0.5 * (here[k] + sign * there[k]);
            fft_.symbol(kernel, even, transform);
            set(I, J, std::span<const double>(transform));
        }
}

// Waves of x are turned by -i on their way in and out (WavePhase). With natural parity that makes all matrices real;
// with the opposite one they are -i times real ones.
SymmetricSymbol ColumnProducts::normal_symbol() const {
    SymmetricSymbol symbol(fft_.groups(), columns_ + columns_ % 2);
    for_pairs(z, z, [&](std::size_t I, std::size_t J, auto transform) { symbol.set(I, J, transform); });
    return symbol;
}

SymmetricSymbol ColumnProducts::tangential_symbol() const {
    SymmetricSymbol symbol(fft_.groups(), 2 * columns_);
    for_pairs(x, x, [&](std::size_t I, std::size_t J, auto transform) { symbol.set(I, J, transform); });
    for_pairs(y, y,
              [&](std::size_t I, std::size_t J, auto transform) { symbol.set(columns_ + I, columns_ + J, transform); });
    for_pairs(y, x, [&](std::size_t I, std::size_t J, auto transform) {
        symbol.set(columns_ + I, J, times(natural() ? 1 : -1, transform));
    });
    return symbol;
}

RectangularSymbol ColumnProducts::coupling_symbol() const {
    RectangularSymbol symbol(fft_.groups(), 2 * columns_, columns_ + columns_ % 2);
    for_pairs(x, z, [&](std::size_t I, std::size_t J, auto transform) {
        symbol.set(I, J, times(natural() ? -1 : 1, transform));
    });
    for_pairs(y, z, [&](std::size_t I, std::size_t J, auto transform) { symbol.set(columns_ + I, J, transform); });
    return symbol;
}

Waves ColumnProducts::normal_waves(std::span<const double> pz) const {
    Waves in(fft_.groups(), columns_ + columns_ % 2);
    fft_.forward(pz, WavePhase::plain, in, 0);
    return in;
}

Waves ColumnProducts::in_waves(std::span<const double> px, std::span<const double> py) const {
    Waves in(fft_.groups(), 2 * columns_);
    fft_.forward(px, WavePhase::along_x, in, 0);
    fft_.forward(py, WavePhase::plain, in, columns_);
    return in;
}

Waves ColumnProducts::tangential_waves(std::span<const double> px, std::span<const double> py) const {
    const Waves in = in_waves(px, py);
    Waves out(fft_.groups(), in.entries);
    tangential_.get([this] { return tangential_symbol(); }).multiply(in, out);
    turn_back(out);
    return out;
}

Waves ColumnProducts::coupled_waves(std::span<const double> pz) const {
    const Waves in = normal_waves(pz);
    Waves out(fft_.groups(), 2 * columns_);
    coupling_.get([this] { return coupling_symbol(); }).multiply(in, out);
    turn_back(out);
    return out;
}

void ColumnProducts::turn_back(Waves& waves) const {
    if (natural()) return;
    std::swap(waves.re, waves.im);
    for (double& value : waves.im) value = -value;
}

// Calls take(to, values) of each column: the elements' displacements, and those of the whole period.
template <class Take>
void ColumnProducts::read(const Waves& waves, std::size_t first, WavePhase phase, std::span<double> u,
                          const Take& take) const {
    const auto nx = static_cast<std::size_t>(box_.nx);
    fft_.inverse(waves, first, columns_, phase,
                 [&](std::size_t column, const double* values) { take(u.subspan(column * nx, nx), values); });
}

template <class Take>
void ColumnProducts::read_tangential(const Waves& waves, std::span<double> ux, std::span<double> uy,
                                     const Take& take) const {
    read(waves, 0, WavePhase::along_x, ux, take);
    read(waves, columns_, WavePhase::plain, uy, take);
}

auto ColumnProducts::difference_to(int ahead) const {
    const auto period = static_cast<std::size_t>(period_);
    const auto shift = static_cast<std::size_t>((ahead + period_) % period_);
    return [=](std::span<double> u, const double* values) {
        for (std::size_t k = 0; k < u.size(); ++k) u[k] = values[k] - values[(k + shift) % period];
    };
}

void ColumnProducts::normal(std::span<const double> pz, std::span<double> uz) const {
    const Waves in = normal_waves(pz);
    Waves out(fft_.groups(), in.entries);
    normal_.get([this] { return normal_symbol(); }).multiply(in, out);
    read(out, 0, WavePhase::plain, uz, copy);
}

void ColumnProducts::normal_of_tangential(std::span<const double> px, std::span<const double> py,
                                          std::span<double> uz) const {
    const Waves in = in_waves(px, py);
    Waves out(fft_.groups(), columns_ + columns_ % 2);
    coupling_.get([this] { return coupling_symbol(); }).multiply_transposed(in, out);
    read(out, 0, WavePhase::plain, uz, copy);
}

void ColumnProducts::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                std::span<double> uy) const {
    read_tangential(tangential_waves(px, py), ux, uy, copy);
}

void ColumnProducts::tangential_of_normal(std::span<const double> pz, std::span<double> ux,
                                          std::span<double> uy) const {
    read_tangential(coupled_waves(pz), ux, uy, copy);
}

void ColumnProducts::add_tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                    std::span<double> uy) const {
    read_tangential(tangential_waves(px, py), ux, uy, add);
}

void ColumnProducts::add_tangential_of_normal(std::span<const double> pz, std::span<double> ux,
                                              std::span<double> uy) const {
    read_tangential(coupled_waves(pz), ux, uy, add);
}

void ColumnProducts::tangential_change(int ahead, std::span<const double> px, std::span<const double> py,
                                       std::span<double> ux, std::span<double> uy) const {
    read_tangential(tangential_waves(px, py), ux, uy, difference_to(ahead));
}

void ColumnProducts::tangential_change_of_normal(int ahead, std::span<const double> pz, std::span<double> ux,
                                                 std::span<double> uy) const {
    read_tangential(coupled_waves(pz), ux, uy, difference_to(ahead));
}

}  // namespace contactd

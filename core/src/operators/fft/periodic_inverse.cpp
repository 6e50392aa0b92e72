#include "periodic_inverse.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "padded_size.hpp"

namespace contactd {
namespace {

using Complex = std::complex<double>;

// This is the least eigenvalue of the symmetric part, in units of the added amount. Without truncation and errors of
// tables, that of C would not be negative.
constexpr double least_part = 0.5;

/// Holds the matrix of the two tangential components at one wavenumber.
struct Block {
    Complex xx, xy, yx, yy;
};

Complex at(const PaddedFft::ComplexSymbol& symbol, std::size_t i) {
    return {symbol.real[i], symbol.imag[i]};
}

void store(const Complex& value, PaddedFft::ComplexSymbol& symbol, std::size_t i) {
    symbol.real[i] = value.real();
    symbol.imag[i] = value.imag();
}

double least_eigenvalue(const Block& m) {
    const double mean = 0.5 * (m.xx.real() + m.yy.real()), half = 0.5 * (m.xx.real() - m.yy.real());
    return mean - std::sqrt(half * half + std::norm(0.5 * (m.xy + std::conj(m.yx))));
}

}  // namespace

class PeriodicInverses::Inverse final : public StepInverse {
   public:
    Inverse(std::shared_ptr<const PaddedFft> fft, TangentialSymbols symbols)
        : fft_(std::move(fft)), symbols_(std::move(symbols)) {}

    void tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                    std::span<double> zy) const override {
        fft_->apply(symbols_.pair(), rx, ry, zx, zy);
    }

   private:
    const std::shared_ptr<const PaddedFft> fft_;
    const TangentialSymbols symbols_;
};

PeriodicInverses::PeriodicInverses(const ShiftedTable& table)
    : fft_(std::make_shared<const PaddedFft>(table.nx, table.ny, periodic_size(table.nx), periodic_size(table.ny))),
      symbols_(TangentialSymbols::of(*fft_, table)) {}

std::shared_ptr<const StepInverse> PeriodicInverses::get(double added) const {
    const std::scoped_lock lock(mutex_);
    for (const auto& [key, made] : cache_)
        if (key == added) return made;
    if (cache_.size() == most_cached) cache_.pop_front();
    cache_.emplace_back(added, std::make_shared<const Inverse>(fft_, inverted(added)));
    return cache_.back().second;
}

TangentialSymbols PeriodicInverses::inverted(double added) const {
    const double factor = fft_->norm_factor(), diagonal = factor * added, least = least_part * diagonal;
    TangentialSymbols result = symbols_;
    for (std::size_t i = 0; i < symbols_.xx.real.size(); ++i) {
        Block m{at(symbols_.xx, i) + diagonal, at(symbols_.xy, i), at(symbols_.of_yx(), i),
                at(symbols_.yy, i) + diagonal};
        const double missing = std::max(least - least_eigenvalue(m), 0.0);
        m.xx += missing;
        m.yy += missing;
        const Complex scale = factor * factor / (m.xx * m.yy - m.xy * m.yx);
        store(scale * m.yy, result.xx, i);
        store(-scale * m.xy, result.xy, i);
        if (!result.yx.real.empty()) store(-scale * m.yx, result.yx, i);
        store(scale * m.xx, result.yy, i);
    }
    return result;
}

}  // namespace contactd

// Creates plans of the transforms and the symbols of kernels.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <mutex>
#include <tuple>

#include "padded_fft_plans.hpp"

namespace contactd {

PaddedFft::Plans::Plans(int nx_, int ny_, int padded_nx_, int padded_ny_, std::size_t lanes)
    : nx(nx_),
      ny(ny_),
      padded_nx(padded_nx_),
      padded_ny(padded_ny_),
      fft(LaneFft::make(padded_nx, padded_ny, lanes)),
      groups((static_cast<std::size_t>(padded_nx) / 2 + fft->lanes()) / fft->lanes()) {}

std::shared_ptr<const PaddedFft::Plans> PaddedFft::Plans::of_size(int nx, int ny, int padded_nx, int padded_ny,
                                                                  std::size_t lanes) {
    constexpr std::size_t most_cached = 256;
    static std::map<std::tuple<int, int, int, int, std::size_t>, std::shared_ptr<const Plans>> made;
    static std::mutex mutex;
    const std::scoped_lock lock(mutex);
    const std::tuple size(nx, ny, padded_nx, padded_ny, lanes);
    if (const auto cached = made.find(size); cached != made.end()) return cached->second;
    if (made.size() >= most_cached)
        std::erase_if(made, [](const auto& entry) { return entry.second.use_count() == 1; });
    return made.emplace(size, std::make_shared<const Plans>(nx, ny, padded_nx, padded_ny, lanes)).first->second;
}

// Stores symbols group after group of columns, each of shape [padded_ny, lanes]. Calls store(real, imaginary) for all
// columns of `spectrum`, whose rows are already transformed.
template <class Store>
void PaddedFft::transform_columns(const double* spectrum, const Store& store) const {
    const Plans& plans = *plans_;
    const std::size_t lanes = fft().lanes();
    const LaneBuffer work(fft().work_size());
    for (std::size_t g = 0; g < plans.groups; ++g) {
        const double* column = fft().columns_forward(spectrum + g * plans.group_size(plans.padded_rows()),
                                                     static_cast<std::size_t>(plans.padded_ny), work.get());
        for (std::size_t at = 0; at < plans.symbol_size(); ++at) {
            const std::size_t real = at / lanes * 2 * lanes + at % lanes;
            store(column[real] * norm_factor(), column[real + lanes] * norm_factor());
        }
    }
}

PaddedFft::Symbol PaddedFft::symbol(const Kernel& kernel) const {
    const Plans& plans = *plans_;
    const auto [along_x, along_y] = kernel.parity;
    const int last_k = std::min(kernel.nx - 1, plans.padded_nx / 2),
              last_l = std::min(kernel.ny - 1, plans.padded_ny / 2);
    const auto length = static_cast<std::size_t>(plans.padded_nx), count = static_cast<std::size_t>(last_l) + 1;
    std::vector<double> rows(count * length);
    for (int l = 0; l <= last_l; ++l) {
        const double* values = kernel.values + static_cast<std::ptrdiff_t>(l) * kernel.nx;
        double* row = &rows[static_cast<std::size_t>(l) * length];
        for (int k = 0; k <= last_k; ++k) row[k] = values[k];
        for (int k = 1; k <= last_k; ++k)  // At half the period, an odd kernel is zero.
            row[plans.padded_nx - k] = 2 * k == plans.padded_nx && along_x < 0 ? 0 : along_x * values[k];
    }
    const LaneBuffer spectrum(plans.group_size(plans.padded_rows()) * plans.groups), work(fft().work_size());
    fft().rows_forward(rows.data(), count, length, {spectrum.get(), plans.padded_rows()}, work.get());
    const std::size_t row_size = plans.group_size(1);
    for (std::size_t g = 0; g < plans.groups; ++g) {
        double* group = spectrum.get() + g * plans.group_size(plans.padded_rows());
        // Clears the rows beyond the kernel: those that fill up its last group, and those of the mirror image.
        const auto end = static_cast<std::size_t>(plans.padded_ny);
        std::fill(group + count * row_size, group + std::max(count, end) * row_size, 0.0);
        for (int l = 1; l <= last_l; ++l) {
            const double* row = group + static_cast<std::size_t>(l) * row_size;
            double* mirrored = group + static_cast<std::size_t>(plans.padded_ny - l) * row_size;
            const double sign = 2 * l == plans.padded_ny && along_y < 0 ? 0 : along_y;
            for (std::size_t at = 0; at < row_size; ++at) mirrored[at] = sign * row[at];
        }
    }
    Symbol symbol;
    symbol.reserve(plans.symbol_size() * plans.groups);
    if (along_x * along_y > 0)
        transform_columns(spectrum.get(), [&](double real, double) { symbol.push_back(real); });
    else
        transform_columns(spectrum.get(), [&](double, double imag) { symbol.push_back(imag); });
    return symbol;
}

PaddedFft::ComplexSymbol PaddedFft::symbol(const SignedKernel& kernel) const {
    const Plans& plans = *plans_;
    const int last_k = std::min(kernel.nx - 1, plans.padded_nx / 2),
              last_l = std::min(kernel.ny - 1, plans.padded_ny / 2);
    const auto place = [](int offset, int period) {
        return static_cast<std::size_t>(offset < 0 ? offset + period : offset);
    };
    const auto share = [](int offset, int period) { return 2 * std::abs(offset) == period ? 0.5 : 1; };
    const auto length = static_cast<std::size_t>(plans.padded_nx), count = static_cast<std::size_t>(plans.padded_ny);
    std::vector<double> rows(count * length);
    for (int l = -last_l; l <= last_l; ++l) {
        const double* values = kernel.values + static_cast<std::ptrdiff_t>(l + kernel.ny - 1) * (2 * kernel.nx - 1);
        double* row = &rows[place(l, plans.padded_ny) * length];
        for (int k = -last_k; k <= last_k; ++k)
            row[place(k, plans.padded_nx)] +=
                share(k, plans.padded_nx) * share(l, plans.padded_ny) * values[k + kernel.nx - 1];
    }
    const LaneBuffer spectrum(plans.group_size(plans.padded_rows()) * plans.groups), work(fft().work_size());
    fft().rows_forward(rows.data(), count, length, {spectrum.get(), plans.padded_rows()}, work.get());
    ComplexSymbol symbol;
    symbol.real.reserve(plans.symbol_size() * plans.groups);
    symbol.imag.reserve(plans.symbol_size() * plans.groups);
    transform_columns(spectrum.get(), [&](double real, double imag) {
        symbol.real.push_back(real);
        symbol.imag.push_back(imag);
    });
    return symbol;
}

PaddedFft::ComplexSymbol PaddedFft::times_along_x(const Symbol& symbol,
                                                  std::span<const std::complex<double>> factor) const {
    const Plans& plans = *plans_;
    const std::size_t lanes = fft().lanes();
    ComplexSymbol result{symbol, std::vector<double>(symbol.size())};
    for (std::size_t at = 0; at < symbol.size(); ++at) {
        const std::size_t column = at / plans.symbol_size() * lanes + at % lanes;
        if (column >= factor.size()) continue;  // only fills up whole groups
        result.real[at] = symbol[at] * factor[column].real();
        result.imag[at] = symbol[at] * factor[column].imag();
    }
    return result;
}

}  // namespace contactd

// Plans of the transforms and the symbols of kernels.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <mutex>
#include <tuple>

#include "padded_fft_plans.hpp"

namespace contactd {
namespace {

constexpr int longest_rows_together = 256;  // numbers; beyond, real rows one by one are as fast

}  // namespace

std::mutex& planner_mutex() {
    static std::mutex mutex;
    return mutex;
}

PaddedFft::Plans::Plans(int nx_, int ny_, int padded_nx_, int padded_ny_)
    : nx(nx_), ny(ny_), padded_nx(padded_nx_), padded_ny(padded_ny_) {
    blocks = (padded_nx / 2 + block) / block;
    columns = static_cast<std::size_t>(blocks) * block;
    const auto row = make_buffer<double>(static_cast<std::size_t>(padded_nx));
    const auto spectrum = make_buffer<Complex>(columns);
    const auto column = make_buffer<Complex>(static_cast<std::size_t>(padded_ny) * block);
    const auto transformed = make_buffer<Complex>(static_cast<std::size_t>(padded_ny) * block);
    // FFTW_ESTIMATE: these plans are the same in every run, and from one array to another they are hardly slower than
    // measured ones; in place they would be, up to 2.5 times.
    row_forward.reset(fftw_plan_dft_r2c_1d(padded_nx, row.get(), raw(spectrum.get()), FFTW_ESTIMATE));
    row_inverse.reset(fftw_plan_dft_c2r_1d(padded_nx, raw(spectrum.get()), row.get(), FFTW_ESTIMATE));
    const auto plan_block = [&](int direction) {
        return fftw_plan_many_dft(1, &padded_ny, block, raw(column.get()), nullptr, block, 1, raw(transformed.get()),
                                  nullptr, block, 1, direction, FFTW_ESTIMATE);
    };
    block_forward.reset(plan_block(FFTW_FORWARD));
    block_inverse.reset(plan_block(FFTW_BACKWARD));
    if (padded_nx > longest_rows_together) return;
    const auto rows = make_buffer<Complex>(static_cast<std::size_t>(padded_nx) * block);
    const auto transformed_rows = make_buffer<Complex>(static_cast<std::size_t>(padded_nx) * block);
    const auto plan_rows = [&](int direction) {
        return fftw_plan_many_dft(1, &padded_nx, block, raw(rows.get()), nullptr, 1, padded_nx,
                                  raw(transformed_rows.get()), nullptr, 1, padded_nx, direction, FFTW_ESTIMATE);
    };
    rows_forward.reset(plan_rows(FFTW_FORWARD));
    rows_inverse.reset(plan_rows(FFTW_BACKWARD));
}

// Plans are only ever destroyed here, under the lock.
std::shared_ptr<const PaddedFft::Plans> PaddedFft::Plans::of_size(int nx, int ny, int padded_nx, int padded_ny) {
    constexpr std::size_t most_cached = 256;
    static std::map<std::tuple<int, int, int, int>, std::shared_ptr<const Plans>> made;
    const std::scoped_lock lock(planner_mutex());
    const std::tuple size(nx, ny, padded_nx, padded_ny);
    if (const auto cached = made.find(size); cached != made.end()) return cached->second;
    if (made.size() >= most_cached)
        std::erase_if(made, [](const auto& entry) { return entry.second.use_count() == 1; });
    return made.emplace(size, std::make_shared<const Plans>(nx, ny, padded_nx, padded_ny)).first->second;
}

// Symbols are stored block after block of columns, each of shape [padded_ny, block]: the transform of the columns of
// `spectrum`, whose rows are transformed already.
template <class Store>
void PaddedFft::transform_columns(const std::complex<double>* spectrum, const Store& store) const {
    const auto& plans = *plans_;
    const auto column = make_buffer<Complex>(plans.block_size()),
               transformed = make_buffer<Complex>(plans.block_size());
    for (int b = 0; b < plans.blocks; ++b) {
        for (int l = 0; l < plans.padded_ny; ++l)
            std::copy_n(spectrum + plans.row_offset(l) + b * block, block, column.get() + l * block);
        fftw_execute_dft(plans.block_forward.get(), raw(column.get()), raw(transformed.get()));
        for (std::size_t at = 0; at < plans.block_size(); ++at) store(transformed[at]);
    }
}

PaddedFft::Symbol PaddedFft::symbol(const Kernel& kernel) const {
    const auto& plans = *plans_;
    const auto [along_x, along_y] = kernel.parity;
    const auto row = make_buffer<double>(static_cast<std::size_t>(plans.padded_nx));
    const auto spectrum = make_buffer<Complex>(plans.row_offset(plans.padded_ny));
    const int last_k = std::min(kernel.nx - 1, plans.padded_nx / 2),
              last_l = std::min(kernel.ny - 1, plans.padded_ny / 2);
    for (int l = 0; l <= last_l; ++l) {
        const double* values = kernel.values + static_cast<std::ptrdiff_t>(l) * kernel.nx;
        for (int k = 0; k <= last_k; ++k) row[k] = values[k];
        for (int k = 1; k <= last_k; ++k)  // at half the period, an odd kernel is zero
            row[plans.padded_nx - k] = 2 * k == plans.padded_nx && along_x < 0 ? 0 : along_x * values[k];
        fftw_execute_dft_r2c(plans.row_forward.get(), row.get(), raw(spectrum.get() + plans.row_offset(l)));
        if (l == 0) continue;
        const Complex* transformed = spectrum.get() + plans.row_offset(l);
        Complex* mirrored = spectrum.get() + plans.row_offset(plans.padded_ny - l);
        const double sign = 2 * l == plans.padded_ny && along_y < 0 ? 0 : along_y;
        for (std::size_t k = 0; k < plans.columns; ++k) mirrored[k] = sign * transformed[k];
    }
    Symbol symbol;
    symbol.reserve(plans.row_offset(plans.padded_ny));
    if (along_x * along_y > 0)
        transform_columns(spectrum.get(), [&](Complex value) { symbol.push_back(value.real() * norm_factor()); });
    else
        transform_columns(spectrum.get(), [&](Complex value) { symbol.push_back(value.imag() * norm_factor()); });
    return symbol;
}

PaddedFft::ComplexSymbol PaddedFft::symbol(const SignedKernel& kernel) const {
    const auto& plans = *plans_;
    const auto row = make_buffer<double>(static_cast<std::size_t>(plans.padded_nx));
    const auto spectrum = make_buffer<Complex>(plans.row_offset(plans.padded_ny));
    const auto transformed = make_buffer<Complex>(plans.columns);
    const int last_k = std::min(kernel.nx - 1, plans.padded_nx / 2),
              last_l = std::min(kernel.ny - 1, plans.padded_ny / 2);
    const auto place = [](int offset, int period) { return offset < 0 ? offset + period : offset; };
    const auto share = [](int offset, int period) { return 2 * std::abs(offset) == period ? 0.5 : 1; };
    for (int l = -last_l; l <= last_l; ++l) {
        const double* values = kernel.values + static_cast<std::ptrdiff_t>(l + kernel.ny - 1) * (2 * kernel.nx - 1);
        std::fill_n(row.get(), plans.padded_nx, 0.0);
        for (int k = -last_k; k <= last_k; ++k)
            row[place(k, plans.padded_nx)] += share(k, plans.padded_nx) * values[k + kernel.nx - 1];
        fftw_execute_dft_r2c(plans.row_forward.get(), row.get(), raw(transformed.get()));
        Complex* sum = spectrum.get() + plans.row_offset(place(l, plans.padded_ny));
        for (std::size_t k = 0; k < plans.columns; ++k) sum[k] += share(l, plans.padded_ny) * transformed[k];
    }
    ComplexSymbol symbol;
    symbol.real.reserve(plans.row_offset(plans.padded_ny));
    symbol.imag.reserve(plans.row_offset(plans.padded_ny));
    transform_columns(spectrum.get(), [&](Complex value) {
        symbol.real.push_back(value.real() * norm_factor());
        symbol.imag.push_back(value.imag() * norm_factor());
    });
    return symbol;
}

PaddedFft::ComplexSymbol PaddedFft::times_along_x(const Symbol& symbol,
                                                  std::span<const std::complex<double>> factor) const {
    const auto& plans = *plans_;
    ComplexSymbol result{symbol, std::vector<double>(symbol.size())};
    for (std::size_t at = 0; at < symbol.size(); ++at) {
        const std::size_t column = at / plans.block_size() * block + at % block;
        if (column >= factor.size()) continue;  // filled up to whole blocks
        result.real[at] = symbol[at] * factor[column].real();
        result.imag[at] = symbol[at] * factor[column].imag();
    }
    return result;
}

}  // namespace contactd

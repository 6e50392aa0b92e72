// Buffers and FFTW plans.
#pragma once

#include <fftw3.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <new>

#include "padded_fft.hpp"

namespace contactd {

using Complex = std::complex<double>;

/// Columns are transformed in blocks that stay in the first-level cache: transform, product, inverse. So are the rows
/// of a pair of fields, since FFTW fills vector registers with transforms that are alike.
inline constexpr int block = 4;

struct FftwFree {
    void operator()(void* memory) const { fftw_free(memory); }
};
template <class T>
using Buffer = std::unique_ptr<T[], FftwFree>;

template <class T>
Buffer<T> make_buffer(std::size_t size) {
    Buffer<T> buffer(static_cast<T*>(fftw_malloc(size * sizeof(T))));
    if (!buffer) throw std::bad_alloc();
    std::fill_n(buffer.get(), size, T{});
    return buffer;
}

inline fftw_complex* raw(Complex* values) {
    return reinterpret_cast<fftw_complex*>(values);
}

struct PlanDestroy {
    void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
};
using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, PlanDestroy>;

/// FFTW plans and frees plans by one thread at a time; only execution is thread-safe.
std::mutex& planner_mutex();

struct PaddedFft::Plans {
    int nx, ny, padded_nx, padded_ny;
    int blocks;                         // of columns
    std::size_t columns;                // in memory, a multiple of the block
    Plan row_forward, row_inverse;      // of one real row
    Plan rows_forward, rows_inverse;    // of a block of complex rows; null where that would leave the first-level cache
    Plan block_forward, block_inverse;  // of a block of columns

    Plans(int nx_, int ny_, int padded_nx_, int padded_ny_);

    std::size_t row_offset(int iy) const { return static_cast<std::size_t>(iy) * columns; }
    std::size_t block_size() const { return static_cast<std::size_t>(padded_ny) * block; }

    /// Made once per size and shared. Unused ones are kept up to a bound.
    static std::shared_ptr<const Plans> of_size(int nx, int ny, int padded_nx, int padded_ny);
};

}  // namespace contactd

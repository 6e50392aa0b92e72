#include "padded_fft.hpp"

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <complex>
#include <map>
#include <new>
#include <tuple>

namespace contactd {
namespace {

using Complex = std::complex<double>;

// Columns are transformed in blocks that stay in the first-level cache: transform, product, inverse.
constexpr int block = 4;

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

fftw_complex* raw(Complex* values) {
    return reinterpret_cast<fftw_complex*>(values);
}

// FFTW plans and frees plans by one thread at a time; only execution is thread-safe.
std::mutex& planner_mutex() {
    static std::mutex mutex;
    return mutex;
}

struct PlanDestroy {
    void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
};
using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, PlanDestroy>;

}  // namespace

struct PaddedFft::Plans {
    int nx, ny, padded_nx, padded_ny;
    int blocks;           // of columns
    std::size_t columns;  // in memory, a multiple of the block
    Plan row_forward, row_inverse, block_forward, block_inverse;

    Plans(int nx_, int ny_, int padded_nx_, int padded_ny_)
        : nx(nx_), ny(ny_), padded_nx(padded_nx_), padded_ny(padded_ny_) {
        blocks = (padded_nx / 2 + block) / block;
        columns = static_cast<std::size_t>(blocks) * block;
        const auto row = make_buffer<double>(static_cast<std::size_t>(padded_nx));
        const auto spectrum = make_buffer<Complex>(columns);
        const auto column = make_buffer<Complex>(static_cast<std::size_t>(padded_ny) * block);
        // FFTW_ESTIMATE: measured plans are no faster here, and these are the same in every run.
        row_forward.reset(fftw_plan_dft_r2c_1d(padded_nx, row.get(), raw(spectrum.get()), FFTW_ESTIMATE));
        row_inverse.reset(fftw_plan_dft_c2r_1d(padded_nx, raw(spectrum.get()), row.get(), FFTW_ESTIMATE));
        const auto plan_block = [&](int direction) {
            return fftw_plan_many_dft(1, &padded_ny, block, raw(column.get()), nullptr, block, 1, raw(column.get()),
                                      nullptr, block, 1, direction, FFTW_ESTIMATE);
        };
        block_forward.reset(plan_block(FFTW_FORWARD));
        block_inverse.reset(plan_block(FFTW_BACKWARD));
    }

    std::size_t row_offset(int iy) const { return static_cast<std::size_t>(iy) * columns; }
    std::size_t block_size() const { return static_cast<std::size_t>(padded_ny) * block; }

    // Made once per size and shared. Unused ones are kept up to a bound and only ever destroyed here, under the lock.
    static std::shared_ptr<const Plans> of_size(int nx, int ny, int padded_nx, int padded_ny) {
        constexpr std::size_t most_kept = 256;
        static std::map<std::tuple<int, int, int, int>, std::shared_ptr<const Plans>> made;
        const std::scoped_lock lock(planner_mutex());
        const std::tuple size(nx, ny, padded_nx, padded_ny);
        if (const auto kept = made.find(size); kept != made.end()) return kept->second;
        if (made.size() >= most_kept)
            std::erase_if(made, [](const auto& entry) { return entry.second.use_count() == 1; });
        return made.emplace(size, std::make_shared<const Plans>(nx, ny, padded_nx, padded_ny)).first->second;
    }
};

struct PaddedFft::Workspace {
    std::array<Buffer<Complex>, 2> spectrum;  // [ny, columns], one per field
    std::array<Buffer<Complex>, 2> column;    // [padded_ny, block]
    Buffer<double> padded_row, row;

    explicit Workspace(const Plans& plans)
        : padded_row(make_buffer<double>(static_cast<std::size_t>(plans.padded_nx))),
          row(make_buffer<double>(static_cast<std::size_t>(plans.padded_nx))) {
        for (auto& buffer : column) buffer = make_buffer<Complex>(plans.block_size());
        spectrum[0] = make_buffer<Complex>(plans.row_offset(plans.ny));
    }

    void need_pair(const Plans& plans) {
        if (!spectrum[1]) spectrum[1] = make_buffer<Complex>(plans.row_offset(plans.ny));
    }
};

// Takes a workspace for one call, makes one when all are in use, and gives it back.
class PaddedFft::Lease {
   public:
    explicit Lease(const PaddedFft& owner) : owner_(owner) {
        {
            const std::scoped_lock lock(owner.idle_mutex_);
            if (!owner.idle_.empty()) {
                workspace_ = std::move(owner.idle_.back());
                owner.idle_.pop_back();
            }
        }
        if (!workspace_) workspace_ = std::make_unique<Workspace>(*owner.plans_);
    }
    ~Lease() {
        const std::scoped_lock lock(owner_.idle_mutex_);
        owner_.idle_.push_back(std::move(workspace_));
    }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    Workspace& operator*() const { return *workspace_; }

   private:
    const PaddedFft& owner_;
    std::unique_ptr<Workspace> workspace_;
};

PaddedFft::PaddedFft(int nx, int ny, int padded_nx, int padded_ny)
    : plans_(Plans::of_size(nx, ny, padded_nx, padded_ny)) {}

PaddedFft::~PaddedFft() = default;

double PaddedFft::norm_factor() const {
    return 1.0 / plans_->padded_nx / plans_->padded_ny;
}

// Symbols are stored block after block of columns, each of shape [padded_ny, block].
PaddedFft::Symbol PaddedFft::symbol(const Kernel& kernel) const {
    const auto& plans = *plans_;
    const auto row = make_buffer<double>(static_cast<std::size_t>(plans.padded_nx));
    const auto spectrum = make_buffer<Complex>(plans.row_offset(plans.padded_ny));
    const int last_k = std::min(kernel.nx - 1, plans.padded_nx / 2),
              last_l = std::min(kernel.ny - 1, plans.padded_ny / 2);
    for (int l = 0; l <= last_l; ++l) {
        const double* values = kernel.values + static_cast<std::ptrdiff_t>(l) * kernel.nx;
        for (int k = 0; k <= last_k; ++k) row[k] = values[k];
        for (int k = 1; k <= last_k; ++k) {  // at half the period, an odd kernel is zero
            double& mirrored = row[plans.padded_nx - k];
            mirrored = 2 * k == plans.padded_nx && kernel.odd ? 0 : kernel.odd ? -values[k] : values[k];
        }
        fftw_execute_dft_r2c(plans.row_forward.get(), row.get(), raw(spectrum.get() + plans.row_offset(l)));
        if (l == 0) continue;
        const Complex* transformed = spectrum.get() + plans.row_offset(l);
        Complex* mirrored = spectrum.get() + plans.row_offset(plans.padded_ny - l);
        const double sign = kernel.odd ? 2 * l == plans.padded_ny ? 0 : -1 : 1;
        for (std::size_t k = 0; k < plans.columns; ++k) mirrored[k] = sign * transformed[k];
    }
    Symbol symbol;
    symbol.reserve(plans.row_offset(plans.padded_ny));
    const auto column = make_buffer<Complex>(plans.block_size());
    for (int b = 0; b < plans.blocks; ++b) {
        for (int l = 0; l < plans.padded_ny; ++l)
            std::copy_n(spectrum.get() + plans.row_offset(l) + b * block, block, column.get() + l * block);
        fftw_execute_dft(plans.block_forward.get(), raw(column.get()), raw(column.get()));
        for (std::size_t at = 0; at < plans.block_size(); ++at) symbol.push_back(column[at].real() * norm_factor());
    }
    return symbol;
}

void PaddedFft::rows_forward(std::span<const double> in, Workspace& workspace, int field) const {
    const auto& plans = *plans_;
    for (int iy = 0; iy < plans.ny; ++iy) {
        const double* values = in.data() + static_cast<std::ptrdiff_t>(iy) * plans.nx;
        Complex* transformed = workspace.spectrum[field].get() + plans.row_offset(iy);
        if (std::all_of(values, values + plans.nx, [](double v) { return v == 0; })) {
            std::fill_n(transformed, plans.columns, Complex{});
            continue;
        }
        std::copy_n(values, plans.nx, workspace.padded_row.get());
        fftw_execute_dft_r2c(plans.row_forward.get(), workspace.padded_row.get(), raw(transformed));
    }
}

void PaddedFft::rows_inverse(Workspace& workspace, int field, std::span<double> out) const {
    const auto& plans = *plans_;
    for (int iy = 0; iy < plans.ny; ++iy) {
        Complex* transformed = workspace.spectrum[field].get() + plans.row_offset(iy);
        fftw_execute_dft_c2r(plans.row_inverse.get(), raw(transformed), workspace.row.get());
        std::copy_n(workspace.row.get(), plans.nx, out.data() + static_cast<std::ptrdiff_t>(iy) * plans.nx);
    }
}

namespace {

void gather(const Complex* spectrum, std::size_t columns, int ny, int padded_ny, Complex* column) {
    for (int l = 0; l < ny; ++l)
        std::copy_n(spectrum + static_cast<std::size_t>(l) * columns, block, column + l * block);
    std::fill(column + ny * block, column + padded_ny * block, Complex{});
}

void scatter(const Complex* column, std::size_t columns, int ny, Complex* spectrum) {
    for (int l = 0; l < ny; ++l)
        std::copy_n(column + l * block, block, spectrum + static_cast<std::size_t>(l) * columns);
}

}  // namespace

void PaddedFft::apply(const Symbol& symbol, std::span<const double> in, std::span<double> out) const {
    const auto& plans = *plans_;
    const Lease lease(*this);
    Workspace& workspace = *lease;
    rows_forward(in, workspace, 0);
    Complex* column = workspace.column[0].get();
    for (int b = 0; b < plans.blocks; ++b) {
        Complex* spectrum = workspace.spectrum[0].get() + b * block;
        gather(spectrum, plans.columns, plans.ny, plans.padded_ny, column);
        fftw_execute_dft(plans.block_forward.get(), raw(column), raw(column));
        const double* factor = symbol.data() + static_cast<std::size_t>(b) * plans.block_size();
        for (std::size_t at = 0; at < plans.block_size(); ++at) column[at] *= factor[at];
        fftw_execute_dft(plans.block_inverse.get(), raw(column), raw(column));
        scatter(column, plans.columns, plans.ny, spectrum);
    }
    rows_inverse(workspace, 0, out);
}

void PaddedFft::apply(const PairSymbols& symbols, std::span<const double> in_x, std::span<const double> in_y,
                      std::span<double> out_x, std::span<double> out_y) const {
    const auto& plans = *plans_;
    const Lease lease(*this);
    Workspace& workspace = *lease;
    workspace.need_pair(plans);
    rows_forward(in_x, workspace, 0);
    rows_forward(in_y, workspace, 1);
    for (int b = 0; b < plans.blocks; ++b) {
        for (std::size_t field : {0u, 1u}) {
            Complex* column = workspace.column[field].get();
            gather(workspace.spectrum[field].get() + b * block, plans.columns, plans.ny, plans.padded_ny, column);
            fftw_execute_dft(plans.block_forward.get(), raw(column), raw(column));
        }
        Complex *x = workspace.column[0].get(), *y = workspace.column[1].get();
        const std::size_t first = static_cast<std::size_t>(b) * plans.block_size();
        for (std::size_t at = 0; at < plans.block_size(); ++at) {
            const Complex in0 = x[at], in1 = y[at];
            x[at] = symbols.xx[first + at] * in0 + symbols.xy[first + at] * in1;
            y[at] = symbols.yx[first + at] * in0 + symbols.yy[first + at] * in1;
        }
        for (std::size_t field : {0u, 1u}) {
            Complex* column = workspace.column[field].get();
            fftw_execute_dft(plans.block_inverse.get(), raw(column), raw(column));
            scatter(column, plans.columns, plans.ny, workspace.spectrum[field].get() + b * block);
        }
    }
    rows_inverse(workspace, 0, out_x);
    rows_inverse(workspace, 1, out_y);
}

}  // namespace contactd

#include "padded_fft.hpp"

#include <algorithm>
#include <iterator>
#include <thread>

#include "padded_fft_plans.hpp"
#include "spectral_products.hpp"

namespace contactd {
namespace {

double* parts(Complex* values) {
    return reinterpret_cast<double*>(values);
}

}  // namespace

struct PaddedFft::Workspace {
    std::array<Buffer<Complex>, 2> spectrum;  // [ny, columns], one per field
    std::array<Buffer<Complex>, 2> column;    // transformed, [padded_ny, block]
    Buffer<Complex> padded_column;            // on its way there, zero beyond the grid
    Buffer<Complex> result;                   // on its way back
    Buffer<double> padded_row, row;
    std::thread::id user;                                 // who had it last
    Buffer<Complex> padded_rows, transformed_rows, rows;  // of a pair of fields, [block, padded_nx]

    explicit Workspace(const Plans& plans)
        : padded_row(make_buffer<double>(static_cast<std::size_t>(plans.padded_nx))),
          row(make_buffer<double>(static_cast<std::size_t>(plans.padded_nx))) {
        for (auto& buffer : column) buffer = make_buffer<Complex>(plans.block_size());
        padded_column = make_buffer<Complex>(plans.block_size());
        result = make_buffer<Complex>(plans.block_size());
        spectrum[0] = make_buffer<Complex>(plans.row_offset(plans.ny));
    }

    void need_pair(const Plans& plans) {
        if (spectrum[1]) return;
        spectrum[1] = make_buffer<Complex>(plans.row_offset(plans.ny));
        if (!plans.rows_forward) return;
        for (Buffer<Complex>* buffer : {&padded_rows, &transformed_rows, &rows})
            *buffer = make_buffer<Complex>(block * static_cast<std::size_t>(plans.padded_nx));
    }
};

// Takes a workspace for one call, makes one when all are in use, and gives it back. A thread takes the one it had last
// where that is idle: another's lies in the cache of another processor.
class PaddedFft::Lease {
   public:
    explicit Lease(const PaddedFft& owner) : owner_(owner) {
        {
            const std::scoped_lock lock(owner.idle_mutex_);
            auto& idle = owner.idle_;
            const auto own = std::find_if(idle.begin(), idle.end(),
                                          [](const auto& one) { return one->user == std::this_thread::get_id(); });
            const auto taken = own != idle.end() || idle.empty() ? own : std::prev(idle.end());
            if (taken != idle.end()) {
                workspace_ = std::move(*taken);
                idle.erase(taken);
            }
        }
        if (!workspace_) workspace_ = std::make_unique<Workspace>(*owner.plans_);
        workspace_->user = std::this_thread::get_id();
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

void PaddedFft::rows_forward(std::span<const double> in, Workspace& workspace, std::size_t field) const {
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

void PaddedFft::rows_inverse(Workspace& workspace, std::size_t field, std::span<double> out) const {
    const auto& plans = *plans_;
    for (int iy = 0; iy < plans.ny; ++iy) {
        Complex* transformed = workspace.spectrum[field].get() + plans.row_offset(iy);
        fftw_execute_dft_c2r(plans.row_inverse.get(), raw(transformed), workspace.row.get());
        std::copy_n(workspace.row.get(), plans.nx, out.data() + static_cast<std::ptrdiff_t>(iy) * plans.nx);
    }
}

// The two fields as the real and the imaginary part of one, a block of rows at a time. Rows of the block beyond the
// last one of the grid are transformed too, and nobody looks at them.
void PaddedFft::rows_forward(const std::array<std::span<const double>, 2>& in, Workspace& workspace) const {
    const auto& plans = *plans_;
    if (!plans.rows_forward) {
        for (std::size_t field = 0; field < in.size(); ++field) rows_forward(in[field], workspace, field);
        return;
    }
    const auto nx = static_cast<std::size_t>(plans.nx), padded_nx = static_cast<std::size_t>(plans.padded_nx);
    for (int first = 0; first < plans.ny; first += block) {
        const int end = std::min(first + block, plans.ny);
        const std::size_t offset = static_cast<std::size_t>(first) * nx;
        const auto is_zero = [&](std::span<const double> field) {
            const double* values = field.data() + offset;
            return std::all_of(values, values + static_cast<std::size_t>(end - first) * nx,
                               [](double v) { return v == 0; });
        };
        Complex *x = workspace.spectrum[0].get() + plans.row_offset(first),
                *y = workspace.spectrum[1].get() + plans.row_offset(first);
        if (is_zero(in[0]) && is_zero(in[1])) {
            std::fill_n(x, plans.row_offset(end - first), Complex{});
            std::fill_n(y, plans.row_offset(end - first), Complex{});
            continue;
        }
        for (std::size_t row = 0; row < static_cast<std::size_t>(end - first); ++row)
            interleave(nx, in[0].data() + offset + row * nx, in[1].data() + offset + row * nx,
                       parts(workspace.padded_rows.get() + row * padded_nx));
        fftw_execute_dft(plans.rows_forward.get(), raw(workspace.padded_rows.get()),
                         raw(workspace.transformed_rows.get()));
        for (int row = 0; row < end - first; ++row)
            split_transforms(padded_nx,
                             parts(workspace.transformed_rows.get() + static_cast<std::size_t>(row) * padded_nx),
                             parts(x + plans.row_offset(row)), parts(y + plans.row_offset(row)));
    }
}

void PaddedFft::rows_inverse(Workspace& workspace, const std::array<std::span<double>, 2>& out) const {
    const auto& plans = *plans_;
    if (!plans.rows_inverse) {
        for (std::size_t field = 0; field < out.size(); ++field) rows_inverse(workspace, field, out[field]);
        return;
    }
    const auto nx = static_cast<std::size_t>(plans.nx), padded_nx = static_cast<std::size_t>(plans.padded_nx);
    for (int first = 0; first < plans.ny; first += block) {
        const int end = std::min(first + block, plans.ny);
        for (int row = first; row < end; ++row)
            join_transforms(
                padded_nx, parts(workspace.spectrum[0].get() + plans.row_offset(row)),
                parts(workspace.spectrum[1].get() + plans.row_offset(row)),
                parts(workspace.transformed_rows.get() + static_cast<std::size_t>(row - first) * padded_nx));
        fftw_execute_dft(plans.rows_inverse.get(), raw(workspace.transformed_rows.get()), raw(workspace.rows.get()));
        for (int row = first; row < end; ++row)
            deinterleave(nx, parts(workspace.rows.get() + static_cast<std::size_t>(row - first) * padded_nx),
                         out[0].data() + static_cast<std::size_t>(row) * nx,
                         out[1].data() + static_cast<std::size_t>(row) * nx);
    }
}

namespace {

// Plain moves: a call of the library for so few numbers costs more than they do.
void copy_rows(int ny, const double* from, std::size_t from_stride, double* to, std::size_t to_stride) {
    for (int l = 0; l < ny; ++l, from += from_stride, to += to_stride)
        for (int i = 0; i < 2 * block; ++i) to[i] = from[i];
}

void gather_columns(Complex* spectrum, std::size_t columns, int ny, Complex* column) {
    copy_rows(ny, parts(spectrum), 2 * columns, parts(column), 2 * block);
}

void scatter_columns(Complex* column, std::size_t columns, int ny, Complex* spectrum) {
    copy_rows(ny, parts(column), 2 * block, parts(spectrum), 2 * columns);
}

}  // namespace

// `product` replaces a block of columns of the inputs by that of the outputs; `first` is where its symbols begin.
template <std::size_t inputs, std::size_t outputs, class Product>
void PaddedFft::convolve(const std::array<std::span<const double>, inputs>& in,
                         const std::array<std::span<double>, outputs>& out, const Product& product) const {
    const auto& plans = *plans_;
    const Lease lease(*this);
    Workspace& workspace = *lease;
    if constexpr (inputs + outputs > 2) workspace.need_pair(plans);
    if constexpr (inputs == 2)
        rows_forward(in, workspace);
    else
        rows_forward(in[0], workspace, 0);
    Complex *x = workspace.column[0].get(), *y = workspace.column[1].get(), *padded = workspace.padded_column.get(),
            *result = workspace.result.get();
    for (int b = 0; b < plans.blocks; ++b) {
        for (std::size_t field = 0; field < inputs; ++field) {
            gather_columns(workspace.spectrum[field].get() + b * block, plans.columns, plans.ny, padded);
            fftw_execute_dft(plans.block_forward.get(), raw(padded), raw(workspace.column[field].get()));
        }
        product(x, y, static_cast<std::size_t>(b) * plans.block_size(), plans.block_size());
        for (std::size_t field = 0; field < outputs; ++field) {
            fftw_execute_dft(plans.block_inverse.get(), raw(workspace.column[field].get()), raw(result));
            scatter_columns(result, plans.columns, plans.ny, workspace.spectrum[field].get() + b * block);
        }
    }
    if constexpr (outputs == 2)
        rows_inverse(workspace, out);
    else
        rows_inverse(workspace, 0, out[0]);
}

namespace {

using In = std::span<const double>;
using Out = std::span<double>;

// Without the checks for infinities of the operator of std::complex.
Complex times(double real, double imag, const Complex& b) {
    return {real * b.real() - imag * b.imag(), real * b.imag() + imag * b.real()};
}

Complex times_i(const Complex& a) {
    return {-a.imag(), a.real()};
}

}  // namespace

void PaddedFft::apply(const Symbol& symbol, In in, Out out) const {
    convolve<1, 1>({in}, {out}, [&](Complex* x, Complex*, std::size_t first, std::size_t size) {
        const double* factor = symbol.data() + first;
        for (std::size_t at = 0; at < size; ++at) x[at] *= factor[at];
    });
}

void PaddedFft::apply(const ComplexSymbol& symbol, In in, Out out) const {
    convolve<1, 1>({in}, {out}, [&](Complex* x, Complex*, std::size_t first, std::size_t size) {
        multiply(size, parts(x), {&symbol.real[first], &symbol.imag[first]});
    });
}

void PaddedFft::apply(const PairSymbols& symbols, In in_x, In in_y, Out out_x, Out out_y) const {
    const auto& [xx, xy, yx, yy] = symbols;
    if (xy.empty() && yx.empty()) {
        convolve<2, 2>({in_x, in_y}, {out_x, out_y}, [&](Complex* x, Complex* y, std::size_t first, std::size_t size) {
            for (std::size_t at = 0; at < size; ++at) {
                x[at] *= xx[first + at];
                y[at] *= yy[first + at];
            }
        });
        return;
    }
    convolve<2, 2>({in_x, in_y}, {out_x, out_y}, [&](Complex* x, Complex* y, std::size_t first, std::size_t size) {
        multiply_pair(size, parts(x), parts(y), &xx[first], &xy[first], &yx[first], &yy[first]);
    });
}

void PaddedFft::apply(const ComplexPairSymbols& symbols, In in_x, In in_y, Out out_x, Out out_y) const {
    const auto& [xx, xy, yx, yy] = symbols;
    convolve<2, 2>({in_x, in_y}, {out_x, out_y}, [&](Complex* x, Complex* y, std::size_t first, std::size_t size) {
        const auto from = [first](const ComplexSymbol& symbol) {
            return ComplexFactor{&symbol.real[first], &symbol.imag[first]};
        };
        multiply_pair(size, parts(x), parts(y), from(xx), from(xy), from(yx), from(yy));
    });
}

void PaddedFft::gather(const Symbol& of_x, const Symbol& of_y, In in_x, In in_y, Out out) const {
    convolve<2, 1>({in_x, in_y}, {out}, [&](Complex* x, Complex* y, std::size_t first, std::size_t size) {
        for (std::size_t at = 0; at < size; ++at) x[at] = times_i(of_x[first + at] * x[at] + of_y[first + at] * y[at]);
    });
}

void PaddedFft::gather(const ComplexSymbol& of_x, const ComplexSymbol& of_y, In in_x, In in_y, Out out) const {
    convolve<2, 1>({in_x, in_y}, {out}, [&](Complex* x, Complex* y, std::size_t first, std::size_t size) {
        for (std::size_t at = 0; at < size; ++at)
            x[at] = times(of_x.real[first + at], of_x.imag[first + at], x[at]) +
                    times(of_y.real[first + at], of_y.imag[first + at], y[at]);
    });
}

void PaddedFft::spread(const Symbol& of_x, const Symbol& of_y, In in, Out out_x, Out out_y) const {
    convolve<1, 2>({in}, {out_x, out_y}, [&](Complex* x, Complex* y, std::size_t first, std::size_t size) {
        for (std::size_t at = 0; at < size; ++at) {
            const Complex turned = times_i(x[at]);
            x[at] = of_x[first + at] * turned;
            y[at] = of_y[first + at] * turned;
        }
    });
}

void PaddedFft::spread(const ComplexSymbol& of_x, const ComplexSymbol& of_y, In in, Out out_x, Out out_y) const {
    convolve<1, 2>({in}, {out_x, out_y}, [&](Complex* x, Complex* y, std::size_t first, std::size_t size) {
        for (std::size_t at = 0; at < size; ++at) {
            const Complex value = x[at];
            x[at] = times(of_x.real[first + at], of_x.imag[first + at], value);
            y[at] = times(of_y.real[first + at], of_y.imag[first + at], value);
        }
    });
}

}  // namespace contactd

#include "padded_fft.hpp"

#include <algorithm>

#include "padded_fft_plans.hpp"
#include "spectral_products.hpp"

namespace contactd {

struct PaddedFft::Workspace {
    std::array<Buffer<Complex>, 2> spectrum;  // [ny, columns], one per field
    std::array<Buffer<Complex>, 2> column;    // transformed, [padded_ny, block]
    Buffer<Complex> staged;                   // on its way to or from there, [padded_ny, block]
    Buffer<double> padded_row, row;

    explicit Workspace(const Plans& plans)
        : padded_row(make_buffer<double>(static_cast<std::size_t>(plans.padded_nx))),
          row(make_buffer<double>(static_cast<std::size_t>(plans.padded_nx))) {
        for (auto& buffer : column) buffer = make_buffer<Complex>(plans.block_size());
        staged = make_buffer<Complex>(plans.block_size());
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

namespace {

void gather_columns(const Complex* spectrum, std::size_t columns, int ny, int padded_ny, Complex* column) {
    for (int l = 0; l < ny; ++l)
        std::copy_n(spectrum + static_cast<std::size_t>(l) * columns, block, column + l * block);
    std::fill(column + ny * block, column + padded_ny * block, Complex{});
}

void scatter_columns(const Complex* column, std::size_t columns, int ny, Complex* spectrum) {
    for (int l = 0; l < ny; ++l)
        std::copy_n(column + l * block, block, spectrum + static_cast<std::size_t>(l) * columns);
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
    for (std::size_t field = 0; field < inputs; ++field) rows_forward(in[field], workspace, field);
    Complex *x = workspace.column[0].get(), *y = workspace.column[1].get(), *staged = workspace.staged.get();
    for (int b = 0; b < plans.blocks; ++b) {
        for (std::size_t field = 0; field < inputs; ++field) {
            gather_columns(workspace.spectrum[field].get() + b * block, plans.columns, plans.ny, plans.padded_ny,
                           staged);
            fftw_execute_dft(plans.block_forward.get(), raw(staged), raw(workspace.column[field].get()));
        }
        product(x, y, static_cast<std::size_t>(b) * plans.block_size(), plans.block_size());
        for (std::size_t field = 0; field < outputs; ++field) {
            fftw_execute_dft(plans.block_inverse.get(), raw(workspace.column[field].get()), raw(staged));
            scatter_columns(staged, plans.columns, plans.ny, workspace.spectrum[field].get() + b * block);
        }
    }
    for (std::size_t field = 0; field < outputs; ++field) rows_inverse(workspace, field, out[field]);
}

namespace {

using In = std::span<const double>;
using Out = std::span<double>;

// Without the checks for infinities of the operator of std::complex.
Complex times(double real, double imag, const Complex& b) {
    return {real * b.real() - imag * b.imag(), real * b.imag() + imag * b.real()};
}

double* parts(Complex* values) {
    return reinterpret_cast<double*>(values);
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

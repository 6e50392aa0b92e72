#include "padded_fft.hpp"

#include <algorithm>
#include <iterator>
#include <thread>

#include "padded_fft_plans.hpp"

namespace contactd {

struct PaddedFft::Workspace {
    std::array<LaneBuffer, 2> spectrum;  // [groups, rows, 2, lanes], one per field
    std::array<LaneBuffer, 2> column;    // columns of a group, one per field
    LaneBuffer row;                      // holds as many rows as there are lanes
    std::thread::id user;                // last thread that used it

    explicit Workspace(const Plans& plans) : row(plans.fft->work_size()) {
        spectrum[0] = LaneBuffer(plans.group_size(plans.rows()) * plans.groups);
        column[0] = LaneBuffer(plans.fft->work_size());
    }

    void need_pair(const Plans& plans) {
        if (spectrum[1].get() != nullptr) return;
        spectrum[1] = LaneBuffer(plans.group_size(plans.rows()) * plans.groups);
        column[1] = LaneBuffer(plans.fft->work_size());
    }
};

// Takes a workspace for one call, creates one if all are in use, and returns it. A thread takes the one that it used
// last if that is idle, because another's lies in the cache of another processor.
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

PaddedFft::PaddedFft(int nx, int ny, int padded_nx, int padded_ny, std::size_t lanes)
    : plans_(Plans::of_size(nx, ny, padded_nx, padded_ny, lanes)) {}

PaddedFft::PaddedFft(int nx, int ny, int padded_nx, int padded_ny)
    : PaddedFft(nx, ny, padded_nx, padded_ny, default_lanes()) {}

PaddedFft::~PaddedFft() = default;

double PaddedFft::norm_factor() const {
    return 1.0 / plans_->padded_nx / plans_->padded_ny;
}

// `product` replaces the transformed columns x, y of the inputs by those of the outputs, group by group, so that a
// group stays in the first-level cache; `first` is the start of its symbols.
template <std::size_t inputs, std::size_t outputs, class Product>
void PaddedFft::convolve(const std::array<std::span<const double>, inputs>& in,
                         const std::array<std::span<double>, outputs>& out, const Product& product) const {
    const Plans& plans = *plans_;
    const LaneFft& fft = *plans.fft;
    const Lease lease(*this);
    Workspace& workspace = *lease;
    if constexpr (inputs + outputs > 2) workspace.need_pair(plans);
    const auto nx = static_cast<std::size_t>(plans.nx), ny = static_cast<std::size_t>(plans.ny);
    const auto spectrum = [&](std::size_t field) {
        return LaneSpectrum{workspace.spectrum[field].get(), plans.rows()};
    };
    for (std::size_t field = 0; field < inputs; ++field)
        fft.rows_forward(in[field].data(), ny, nx, spectrum(field), workspace.row.get());
    for (std::size_t g = 0; g < plans.groups; ++g) {
        const auto group = [&](std::size_t field) {
            return workspace.spectrum[field].get() + g * plans.group_size(plans.rows());
        };
        std::array<double*, 2> transformed{};
        for (std::size_t field = 0; field < inputs; ++field)
            transformed[field] = fft.columns_forward(group(field), ny, workspace.column[field].get());
        if constexpr (outputs > inputs) transformed[1] = fft.columns_of(workspace.column[1].get());
        product(transformed[0], transformed[1], g * plans.symbol_size());
        for (std::size_t field = 0; field < outputs; ++field)
            fft.columns_inverse(transformed[field], workspace.column[field].get(), ny, group(field));
    }
    for (std::size_t field = 0; field < outputs; ++field)
        fft.rows_inverse(spectrum(field), ny, nx, out[field].data(), workspace.row.get());
}

namespace {

using In = std::span<const double>;
using Out = std::span<double>;

ComplexFactor part(const PaddedFft::ComplexSymbol& symbol, std::size_t first) {
    return {&symbol.real[first], &symbol.imag[first]};
}

}  // namespace

void PaddedFft::apply(const Symbol& symbol, In in, Out out) const {
    convolve<1, 1>({in}, {out}, [&](double* x, double*, std::size_t first) { fft().multiply(x, &symbol[first]); });
}

void PaddedFft::apply(const ComplexSymbol& symbol, In in, Out out) const {
    convolve<1, 1>({in}, {out}, [&](double* x, double*, std::size_t first) { fft().multiply(x, part(symbol, first)); });
}

void PaddedFft::apply(const PairSymbols& symbols, In in_x, In in_y, Out out_x, Out out_y) const {
    const auto& [xx, xy, yx, yy] = symbols;
    if (xy.empty() && yx.empty()) {
        apply(xx, in_x, out_x);
        apply(yy, in_y, out_y);
        return;
    }
    convolve<2, 2>({in_x, in_y}, {out_x, out_y}, [&](double* x, double* y, std::size_t first) {
        fft().multiply(x, y, &xx[first], &xy[first], &yx[first], &yy[first]);
    });
}

void PaddedFft::apply(const ComplexPairSymbols& symbols, In in_x, In in_y, Out out_x, Out out_y) const {
    const auto& [xx, xy, yx, yy] = symbols;
    convolve<2, 2>({in_x, in_y}, {out_x, out_y}, [&](double* x, double* y, std::size_t first) {
        fft().multiply(x, y, part(xx, first), part(xy, first), part(yx, first), part(yy, first));
    });
}

void PaddedFft::gather(const Symbol& of_x, const Symbol& of_y, In in_x, In in_y, Out out) const {
    convolve<2, 1>({in_x, in_y}, {out},
                   [&](double* x, double* y, std::size_t first) { fft().gather(x, y, &of_x[first], &of_y[first]); });
}

void PaddedFft::gather(const ComplexSymbol& of_x, const ComplexSymbol& of_y, In in_x, In in_y, Out out) const {
    convolve<2, 1>({in_x, in_y}, {out}, [&](double* x, double* y, std::size_t first) {
        fft().gather(x, y, part(of_x, first), part(of_y, first));
    });
}

void PaddedFft::spread(const Symbol& of_x, const Symbol& of_y, In in, Out out_x, Out out_y) const {
    convolve<1, 2>({in}, {out_x, out_y},
                   [&](double* x, double* y, std::size_t first) { fft().spread(x, y, &of_x[first], &of_y[first]); });
}

void PaddedFft::spread(const ComplexSymbol& of_x, const ComplexSymbol& of_y, In in, Out out_x, Out out_y) const {
    convolve<1, 2>({in}, {out_x, out_y}, [&](double* x, double* y, std::size_t first) {
        fft().spread(x, y, part(of_x, first), part(of_y, first));
    });
}

const LaneFft& PaddedFft::fft() const {
    return *plans_->fft;
}

}  // namespace contactd

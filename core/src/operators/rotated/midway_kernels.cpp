#include "midway_kernels.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "contactd/given_ics.hpp"
#include "operators/coarsening.hpp"

namespace contactd {
namespace {

MidwayKernels::Values values_of(const IcTable& pair) {
    const auto component = [&](Axis i, Axis j) {
        const double* first = &pair.values[pair.index(i, j, 0, 0)];
        return std::vector<double>(first, first + pair.component_size());
    };
    using enum Axis;
    return {component(x, x), component(x, y), component(y, y), component(z, z), component(y, z), component(x, z)};
}

/// Returns whether a component is even in the offset along x, with natural parity.
bool is_even(MidwayKernels::Component component) {
    return component != MidwayKernels::xs && component != MidwayKernels::xn;
}

}  // namespace

MidwayKernels::MidwayKernels(IcTable pair)
    : pair_(std::move(pair)),
      nx_(pair_->nx),
      ny_(pair_->ny),
      coupled_(coupling(*pair_) > coupling_tolerance),
      parity_(OffsetParity::natural),
      values_(values_of(*pair_)) {}

MidwayKernels::MidwayKernels(int nx, int ny, Values values, bool coupled, OffsetParity parity)
    : nx_(nx), ny_(ny), coupled_(coupled), parity_(parity), values_(std::move(values)) {}

std::size_t MidwayKernels::bytes() const {
    constexpr std::size_t of_table = 15, of_symbols = 12, of_boxes = 12;  // numbers per offset
    return static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_) * (of_table + of_symbols + of_boxes) *
           sizeof(double);
}

std::vector<double> MidwayKernels::transform(Component component, const SymbolExtent& extent,
                                             const StripFft& fft) const {
    const auto rows = static_cast<std::size_t>(extent.strips), period = static_cast<std::size_t>(extent.period),
               offsets = static_cast<std::size_t>(extent.offsets);
    const bool even = is_even(component) == (parity_ == OffsetParity::natural);
    const double factor = 1.0 / extent.period, sign = even ? 1 : -1;
    std::vector<double> values(rows * period);
    for (std::size_t l = 0; l < rows; ++l) {
        const std::span row(&values[l * period], period);
        const double* kernel = &values_[component][l * static_cast<std::size_t>(nx_)];
        for (std::size_t k = 0; k < offsets; ++k) {
            row[k] = factor * kernel[k];
            if (k > 0) row[period - k] = sign * row[k];
        }
        extent.joint.fill(row, even);
    }
    return fft.transform(values, even);
}

std::shared_ptr<const MidwaySymbols> MidwayKernels::symbols(const SymbolExtent& extent, const StripFft& fft) const {
    return symbols_.get({extent.period, 0, extent.offsets, extent.strips}, [&] {
        const auto of = [&](Component component) { return transform(component, extent, fft); };
        const auto half_sum = [](const std::vector<double>& a, double sign, const std::vector<double>& b) {
            std::vector<double> result(a.size());
            for (std::size_t i = 0; i < a.size(); ++i) result[i] = 0.5 * (a[i] + sign * b[i]);
            return result;
        };
        // A component that mixes x with another axis has -i times the transform of the opposite parity.
        const auto rotated = [&](std::vector<double> values) {
            if (!extent.natural())
                for (double& value : values) value = -value;
            return values;
        };
        const std::vector<double> normal = of(nn), across = of(ss);
        MidwaySymbols made{static_cast<std::size_t>(extent.strips),
                           of(xx),
                           rotated(of(xs)),
                           half_sum(normal, 1, across),
                           half_sum(normal, -1, across),
                           {},
                           {}};
        if (coupled_) {
            made.sn = of(sn);
            made.xn = rotated(of(xn));
        }
        return std::make_shared<const MidwaySymbols>(std::move(made));
    });
}

std::shared_ptr<const MidwayKernels> MidwayKernels::coarse(int nx, int ny) const {
    return coarse_.get({0, 0, nx, ny}, [&] {
        const Coarsening coarsening(nx, ny);
        return std::make_shared<const MidwayKernels>(coarsening.coarse(cropped(*pair_, nx, ny), coupled_));
    });
}

}  // namespace contactd

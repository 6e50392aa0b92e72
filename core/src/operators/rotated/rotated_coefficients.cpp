#include "rotated_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contactd/given_ics.hpp"
#include "kept_distances.hpp"
#include "rotated_matrices.hpp"

namespace contactd {
namespace {

/// Returns whether the angles are so large that normal and tangential contact influence each other.
bool are_rotated(const std::vector<double>& angles) {
    const auto [least, greatest] = std::minmax_element(angles.begin(), angles.end());
    return *greatest - *least > coupling_tolerance;
}

const std::vector<double>* or_none(const std::vector<double>& values) {
    return values.empty() ? nullptr : &values;
}

/// Returns the first entries that pairs of rows keep, for SymmetricSymbol: a pair of its rows corresponds to `rows`
/// rows of the grid, each with `entries` entries.
std::vector<std::size_t> first_kept(const KeptDistances& kept, std::size_t groups, std::size_t pairs, std::size_t rows,
                                    std::size_t entries) {
    std::vector<std::size_t> begin;
    for (std::size_t group = 0; group < groups; ++group)
        for (std::size_t pair = 0; pair < pairs; ++pair) {
            const std::size_t row = pair * rows, before = std::min(row, kept.of(group) - 1);
            begin.push_back((row - before) * entries);
        }
    return begin;
}

}  // namespace

RotatedCoefficients::RotatedCoefficients(std::shared_ptr<const MidwayKernels> midway, std::vector<double> angles)
    : midway_(std::move(midway)), angles_(std::move(angles)), coupled_(midway_->coupled() || are_rotated(angles_)) {}

double RotatedCoefficients::self(Axis i, int) const {
    using enum MidwayKernels::Component;
    return midway_->at_origin(i == Axis::x ? xx : i == Axis::y ? ss : nn);
}

std::size_t RotatedCoefficients::bytes() const {
    constexpr std::size_t of_symbols = 7, of_boxes = 4;  // numbers per pair of rows and offset
    return midway_->bytes() + static_cast<std::size_t>(offsets()) * angles_.size() * angles_.size() *
                                  (of_symbols + of_boxes) * sizeof(double);
}

std::span<const double> RotatedCoefficients::angles_of(const SymbolExtent& extent) const {
    return std::span(angles_).subspan(static_cast<std::size_t>(extent.first_strip),
                                      static_cast<std::size_t>(extent.strips));
}

SymmetricSymbol RotatedCoefficients::normal(const SymbolExtent& extent, const StripFft& fft) const {
    const auto symbols = midway_->symbols(extent, fft);
    const KeptDistances kept(*symbols, {{&symbols->sum, &symbols->difference, or_none(symbols->sn)}}, extent.left_out);
    const PairRotations whole(angles_of(extent), 1);
    const std::size_t entries = symbols->rows + symbols->rows % 2;
    SymmetricSymbol symbol(fft.groups(), entries, first_kept(kept, fft.groups(), entries / 2, 2, 1), kept.rounded());
    symbol.fill([&](std::size_t group, const std::size_t* begin, auto* matrix) {
        fill_normal(*symbols, group, whole, begin, matrix);
    });
    return symbol;
}

SymmetricSymbol RotatedCoefficients::tangential(const SymbolExtent& extent, const StripFft& fft) const {
    const auto symbols = midway_->symbols(extent, fft);
    const KeptDistances kept(*symbols,
                             {{&symbols->xx},
                              {&symbols->xs, or_none(symbols->xn)},
                              {&symbols->sum, &symbols->difference, or_none(symbols->sn)}},
                             extent.left_out);
    const PairRotations whole(angles_of(extent), 1), half(angles_of(extent), 0.5);
    const std::size_t rows = symbols->rows;
    SymmetricSymbol symbol(fft.groups(), 2 * rows, first_kept(kept, fft.groups(), rows, 1, 2), kept.rounded());
    symbol.fill([&](std::size_t group, const std::size_t* begin, auto* matrix) {
        fill_tangential(*symbols, group, whole, half, begin, matrix);
    });
    return symbol;
}

RectangularSymbol RotatedCoefficients::coupling(const SymbolExtent& extent, const StripFft& fft) const {
    const auto symbols = midway_->symbols(extent, fft);
    const KeptDistances kept(*symbols, {{&symbols->xs, or_none(symbols->xn)}, {&symbols->sum, or_none(symbols->sn)}},
                             extent.left_out);
    const PairRotations whole(angles_of(extent), 1), half(angles_of(extent), 0.5);
    const std::size_t rows = symbols->rows;
    std::vector<EntryRange> ranges;
    for (std::size_t group = 0; group < fft.groups(); ++group)
        for (std::size_t I = 0; I < rows; ++I)
            ranges.push_back({I + 1 - std::min(I + 1, kept.of(group)), std::min(I + kept.of(group), rows)});
    RectangularSymbol symbol(fft.groups(), 2 * rows, rows + rows % 2, std::move(ranges), kept.rounded());
    symbol.fill([&](std::size_t group, const EntryRange* range, auto* matrix) {
        fill_coupling(*symbols, group, whole, half, range, matrix);
    });
    return symbol;
}

std::shared_ptr<const StripCoefficients> RotatedCoefficients::coarse(const ElementBox& box, int /*along_x*/,
                                                                     int along_y) const {
    const auto several = static_cast<std::size_t>(along_y), rows = static_cast<std::size_t>(box.ny);
    const std::span angles = std::span(angles_).subspan(static_cast<std::size_t>(box.first_y), rows);
    std::vector<double> means;
    for (std::size_t first = 0; first < rows; first += several) {
        const std::size_t end = std::min(first + several, rows);
        double sum = 0;
        for (std::size_t row = first; row < end; ++row) sum += angles[row];
        means.push_back(sum / static_cast<double>(end - first));
    }
    return std::make_shared<const RotatedCoefficients>(midway_->coarse(box.nx, box.ny), std::move(means));
}

}  // namespace contactd

#include "rotated_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contactd/given_ics.hpp"
#include "rotated_matrices.hpp"

namespace contactd {
namespace {

/// Angles below which normal and tangential contact do not influence each other.
bool are_turned(const std::vector<double>& angles) {
    const auto [least, greatest] = std::minmax_element(angles.begin(), angles.end());
    return *greatest - *least > coupling_tolerance;
}

}  // namespace

RotatedCoefficients::RotatedCoefficients(std::shared_ptr<const MidwayKernels> midway, std::vector<double> angles)
    : midway_(std::move(midway)), angles_(std::move(angles)), coupled_(midway_->coupled() || are_turned(angles_)) {}

double RotatedCoefficients::self(Axis i, int) const {
    using enum MidwayKernels::Component;
    return midway_->at_origin(i == Axis::x ? xx : i == Axis::y ? ss : nn);
}

std::size_t RotatedCoefficients::bytes() const {
    constexpr std::size_t of_symbols = 7, of_boxes = 4;  // numbers a pair of rows and an offset
    return midway_->bytes() + static_cast<std::size_t>(offsets()) * angles_.size() * angles_.size() *
                                  (of_symbols + of_boxes) * sizeof(double);
}

std::span<const double> RotatedCoefficients::angles_of(const SymbolExtent& extent) const {
    return std::span(angles_).subspan(static_cast<std::size_t>(extent.first_strip),
                                      static_cast<std::size_t>(extent.strips));
}

SymmetricSymbol RotatedCoefficients::normal(const SymbolExtent& extent, const StripFft& fft) const {
    const auto symbols = midway_->symbols(extent, fft);
    const PairRotations whole(angles_of(extent), 1);
    SymmetricSymbol symbol(fft.groups(), symbols->rows + symbols->rows % 2);
    for (std::size_t group = 0; group < fft.groups(); ++group)
        fill_normal(*symbols, group, whole, symbol.matrix(group));
    if (extent.left_out > 0) symbol.trim(extent.left_out);
    return symbol;
}

SymmetricSymbol RotatedCoefficients::tangential(const SymbolExtent& extent, const StripFft& fft) const {
    const auto symbols = midway_->symbols(extent, fft);
    const PairRotations whole(angles_of(extent), 1), half(angles_of(extent), 0.5);
    SymmetricSymbol symbol(fft.groups(), 2 * symbols->rows);
    for (std::size_t group = 0; group < fft.groups(); ++group)
        fill_tangential(*symbols, group, whole, half, symbol.matrix(group));
    if (extent.left_out > 0) symbol.trim(extent.left_out);
    return symbol;
}

RectangularSymbol RotatedCoefficients::coupling(const SymbolExtent& extent, const StripFft& fft) const {
    const auto symbols = midway_->symbols(extent, fft);
    const PairRotations whole(angles_of(extent), 1), half(angles_of(extent), 0.5);
    RectangularSymbol symbol(fft.groups(), 2 * symbols->rows, symbols->rows + symbols->rows % 2);
    for (std::size_t group = 0; group < fft.groups(); ++group)
        fill_coupling(*symbols, group, whole, half, symbol.matrix(group));
    if (extent.left_out > 0) symbol.trim(extent.left_out);
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

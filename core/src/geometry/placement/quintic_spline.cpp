#include "geometry/placement/quintic_spline.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace contactd::geometry {
namespace {

/// Returns weights of the first and the second derivative at `x` of the polynomial through points (Fornberg, Math.
/// Comp. 51, 1988).
std::pair<std::vector<double>, std::vector<double>> derivative_weights(double x, const std::vector<double>& points) {
    const std::size_t n = points.size();
    std::array<std::vector<double>, 3> weights;
    for (auto& order : weights) order.assign(n, 0.0);
    weights[0][0] = 1;
    double before = 1;
    for (std::size_t i = 1; i < n; ++i) {
        double product = 1;
        for (std::size_t j = 0; j < i; ++j) product *= points[i] - points[j];
        for (std::size_t m = 3; m-- > 0;)
            weights[m][i] = before / product *
                            ((m > 0 ? static_cast<double>(m) * weights[m - 1][i - 1] : 0.0) -
                             (points[i - 1] - x) * weights[m][i - 1]);
        for (std::size_t j = 0; j < i; ++j)
            for (std::size_t m = 3; m-- > 0;)
                weights[m][j] =
                    ((points[i] - x) * weights[m][j] - (m > 0 ? static_cast<double>(m) * weights[m - 1][j] : 0.0)) /
                    (points[i] - points[j]);
        before = product;
    }
    return {std::move(weights[1]), std::move(weights[2])};
}

}  // namespace

QuinticSpline::QuinticSpline(std::vector<double> knots, double period, EqualValues equal)
    : knots_(std::move(knots), period), equal_(equal) {
    for (std::size_t i = 0; i < knots_.size(); ++i) stencils_.push_back(stencil_at(i));
}

DerivativeStencil QuinticSpline::stencil_at(std::size_t knot) const {
    constexpr std::ptrdiff_t reach = 2;
    const auto count = static_cast<std::ptrdiff_t>(knots_.size()), at = static_cast<std::ptrdiff_t>(knot);
    std::ptrdiff_t from = at - reach, to = at + reach;
    if (knots_.period() == 0) {
        from = std::clamp(from, std::ptrdiff_t{0}, std::max(std::ptrdiff_t{0}, count - 1 - 2 * reach));
        to = std::min(from + 2 * reach, count - 1);
    }
    DerivativeStencil stencil;
    std::vector<double> places;
    for (std::ptrdiff_t i = from; i <= to; ++i) {
        stencil.knots.push_back(knots_.wrapped(i));
        places.push_back(knots_.place(i));
    }
    std::tie(stencil.first, stencil.second) = derivative_weights(knots()[knot], places);
    return stencil;
}

std::vector<DerivativeShares> QuinticSpline::shares(std::span<const SlicePoints> slices) const {
    return shares_of_shape(knots_, stencils_, slices, equal_);
}

std::vector<KnotDerivatives> QuinticSpline::derivatives(std::span<const double> values,
                                                        std::span<const DerivativeShares> shares) const {
    std::vector<KnotDerivatives> at(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const DerivativeStencil& stencil = stencils_[i];
        for (std::size_t k = 0; k < stencil.knots.size(); ++k) {
            const double value = values[stencil.knots[k]] - values[i];
            at[i].slope += stencil.first[k] * value;
            at[i].curving += stencil.second[k] * value;
        }
        at[i] = {shares[i].slope * at[i].slope, shares[i].curving * at[i].curving};
    }
    return at;
}

std::vector<KnotDerivatives> QuinticSpline::derivatives(std::span<const double> values) const {
    std::vector<SlicePoints> slices;
    for (const double value : values) slices.push_back({value});
    return derivatives(values, shares(slices));
}

QuinticWeights QuinticWeights::of_value(double t, double h) {
    const double u = 1 - t, cube = t * t * t;
    return {cube * (10 - t * (15 - 6 * t)), h * t * (1 - t * t * (6 - t * (8 - 3 * t))),
            -h * cube * (4 - t * (7 - 3 * t)), h * h / 2 * t * t * u * u * u, h * h / 2 * cube * u * u};
}

QuinticWeights QuinticWeights::of_slope(double t, double h) {
    const double u = 1 - t, square = t * t;
    return {30 * square * u * u / h, 1 - square * (18 - t * (32 - 15 * t)), -square * (12 - t * (28 - 15 * t)),
            h / 2 * t * u * u * (2 - 5 * t), h / 2 * square * u * (3 - 5 * t)};
}

std::array<double, 6> bezier_ordinates(double h, double rise, const KnotDerivatives& from, const KnotDerivatives& to) {
    return {0,
            h * from.slope / 5,
            h * (2 * from.slope / 5 + h * from.curving / 20),
            rise - h * (2 * to.slope / 5 - h * to.curving / 20),
            rise - h * to.slope / 5,
            rise};
}

}  // namespace contactd::geometry

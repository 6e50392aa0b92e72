#include "fastsim_ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "types/simd.hpp"

namespace contactd {
namespace {

// Holds four slices, and the current points of the march through them.
template <class Number>
struct FourSlices {
    FastsimSlice<Number> slice;
    Quad half_chord;
    FastsimPoint<Number> point;
    SliceSums<Number> sum;
};

// Nodes of the default settings are created once.
std::shared_ptr<const FastsimNodes> nodes_of(const FastsimSettings& settings) {
    static const auto usual = std::make_shared<const FastsimNodes>(FastsimSettings{});
    return settings == FastsimSettings{} ? usual : std::make_shared<const FastsimNodes>(settings);
}

// Groups alternate at each position, since each waits for its own square roots.
template <class Number>
CONTACTD_INLINE void follow_each(const FastsimLaw<Number>& law, std::span<const double> positions,
                                 std::span<FourSlices<Number>> groups) {
    for (const double position : positions)
        for (FourSlices<Number>& four : groups)
            four.point = advance(law, four.slice, four.point, Number(position * four.half_chord), four.sum);
}

}  // namespace

CONTACTD_SIMD
static void follow(const FastsimLaw<Quad>& law, std::span<const double> positions, std::span<FourSlices<Quad>> groups) {
    follow_each(law, positions, groups);
}

CONTACTD_SIMD
static void follow(const FastsimLaw<DualOf<Quad>>& law, std::span<const double> positions,
                   std::span<FourSlices<DualOf<Quad>>> groups) {
    follow_each(law, positions, groups);
}

FastsimNodes::FastsimNodes(const FastsimSettings& settings) {
    for (int j = 1; j <= settings.steps; ++j)
        positions.push_back(j == settings.steps ? -1.0 : std::cos(std::numbers::pi * j / settings.steps));

    // In full adhesion or full slip, a slice contributes a multiple of its chord squared (creepage) or cubed (spin,
    // bound). Equal steps of t are exact for the chord and its cube, which are cos^2 t and cos^4 t there, and nearly
    // exact for the square, cos^3 t. A share of cos 6t, which changes neither of the others, compensates the error.
    const double dt = std::numbers::pi / settings.slices;
    const auto angle = [&](int k) { return (k + 0.5) * dt - 0.5 * std::numbers::pi; };
    double square = 0, change = 0;
    for (int k = 0; k < settings.slices; ++k) {
        const double cos3 = std::pow(std::cos(angle(k)), 3) * dt;
        square += cos3;
        change += cos3 * std::cos(6 * angle(k));
    }
    const double share = (4.0 / 3 - square) / change;
    constexpr int lanes = 4;
    for (int first = 0; first < settings.slices; first += lanes) {
        Quad height, width = 0;
        for (int lane = 0; lane < lanes; ++lane) {
            const int k = std::min(first + lane, settings.slices - 1);
            height.value[lane] = std::sin(angle(k));
            if (k == first + lane) width.value[lane] = std::cos(angle(k)) * dt * (1 + share * std::cos(6 * angle(k)));
        }
        heights.push_back(height);
        widths.push_back(width);
    }
}

FastsimEllipse::FastsimEllipse(const RollingFrame& frame, const Material& combined, double bound,
                               const FastsimSettings& settings)
    : axes_(frame.axes), L_(flexibilities(frame.axes, combined)), bound_(bound), nodes_(nodes_of(settings)) {}

template <class Number>
FastsimTotals<Number> FastsimEllipse::totals_of_four(const FastsimCreepages<Number>& creepages) const {
    const FastsimLaw<Number> shared = law(creepages);
    std::vector<FourSlices<Number>> groups(nodes_->heights.size());
    for (std::size_t k = 0; k < groups.size(); ++k) {
        FourSlices<Number>& four = groups[k];
        const Quad y = axes_.b * nodes_->heights[k];
        four.slice = slice(creepages, y);
        four.half_chord = half_chord(y);
        four.point.traction.x = four.half_chord;
    }
    follow(shared, nodes_->positions, groups);

    FastsimTotals<Number> total;
    for (std::size_t k = 0; k < groups.size(); ++k) {
        const Quad y = axes_.b * nodes_->heights[k], dy = axes_.b * nodes_->widths[k];
        const SliceSums<Number>& sum = groups[k].sum;
        total.Fx += dy * sum.px;
        total.Fy += dy * sum.py;
        total.Mz += dy * (sum.x_py - y * sum.px);
        // Slip does the work of the rigid slip. The springs return the work that they store, since the traction is zero
        // at both ends of the slice.
        const Number work =
            L_.L1 * (groups[k].slice.slope_x * sum.px) + L_.L2 * (shared.slope_y * sum.py + shared.slope_yx * sum.x_py);
        total.power += -dy * work;
        total.slip_area += dy * sum.slip;
    }
    return total;
}

FastsimTotals<double> FastsimEllipse::totals(const FastsimCreepages<double>& creepages) const {
    const FastsimTotals<Quad> four = totals_of_four(FastsimCreepages<Quad>{creepages.xi, creepages.eta, creepages.phi});
    return {sum_of(four.Fx), sum_of(four.Fy), sum_of(four.Mz), sum_of(four.power), sum_of(four.slip_area)};
}

FastsimTotals<Dual> FastsimEllipse::totals(const FastsimCreepages<Dual>& creepages) const {
    const FastsimTotals<DualOf<Quad>> four =
        totals_of_four(FastsimCreepages<DualOf<Quad>>{each(creepages.xi), each(creepages.eta), each(creepages.phi)});
    return {sum_of(four.Fx), sum_of(four.Fy), sum_of(four.Mz), sum_of(four.power), sum_of(four.slip_area)};
}

}  // namespace contactd

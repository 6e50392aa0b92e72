#include "fastsim_ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "quad.hpp"
#include "types/wide.hpp"

namespace contactd {
namespace {

// Four slices, and where the march through them stands.
struct FourSlices {
    FastsimSlice<Quad> slice;
    Quad half_chord;
    FastsimPoint<Quad> point;
    SliceSums<Quad> sum;
};

// Of the usual settings they are made once.
std::shared_ptr<const FastsimNodes> nodes_of(const FastsimSettings& settings) {
    static const auto usual = std::make_shared<const FastsimNodes>(FastsimSettings{});
    return settings == FastsimSettings{} ? usual : std::make_shared<const FastsimNodes>(settings);
}

}  // namespace

// Groups take turns at each position, since each waits for its own square roots.
CONTACTD_WIDE
static void follow(const FastsimLaw<double>& law, std::span<const double> positions, std::span<FourSlices> groups) {
    const FastsimLaw<Quad> shared{law.bound, law.curvature, law.slope_y, law.slope_yx, law.stiff_x, law.stiff_y};
    for (const double position : positions)
        for (FourSlices& four : groups)
            four.point = advance(shared, four.slice, four.point, Quad(position * four.half_chord), four.sum);
}

FastsimNodes::FastsimNodes(const FastsimSettings& settings) {
    for (int j = 1; j <= settings.steps; ++j)
        positions.push_back(j == settings.steps ? -1.0 : std::cos(std::numbers::pi * j / settings.steps));

    // Where all adheres or all slips a slice carries a multiple of its chord squared (creepage) or cubed (spin, bound).
    // Equal steps of t are exact for its chord and the cube, which are cos^2 t and cos^4 t there, and nearly so for the
    // square, cos^3 t: a share of cos 6t, which alters neither of the others, makes up for the rest.
    const double dt = std::numbers::pi / settings.slices;
    const auto angle = [&](int k) { return (k + 0.5) * dt - 0.5 * std::numbers::pi; };
    double square = 0, change = 0;
    for (int k = 0; k < settings.slices; ++k) {
        const double cos3 = std::pow(std::cos(angle(k)), 3) * dt;
        square += cos3;
        change += cos3 * std::cos(6 * angle(k));
    }
    const double share = (4.0 / 3 - square) / change;
    for (int k = 0; k < settings.slices; ++k) {
        heights.push_back(std::sin(angle(k)));
        widths.push_back(std::cos(angle(k)) * dt * (1 + share * std::cos(6 * angle(k))));
    }
}

FastsimEllipse::FastsimEllipse(const RollingFrame& frame, const Material& combined, double bound,
                               const FastsimSettings& settings)
    : axes_(frame.axes), L_(flexibilities(frame.axes, combined)), bound_(bound), nodes_(nodes_of(settings)) {}

double FastsimEllipse::half_chord(double rest) const {
    return axes_.a * std::sqrt(rest);
}

FastsimTotals<double> FastsimEllipse::totals(const FastsimCreepages<double>& creepages) const {
    constexpr std::size_t lanes = 4;
    std::vector<FourSlices> groups((nodes_->heights.size() + lanes - 1) / lanes);
    for (std::size_t k = 0; k < lanes * groups.size(); ++k) {  // those beyond the last are like it
        const FastsimSlice<double> here =
            slice(creepages, axes_.b * nodes_->heights[std::min(k, nodes_->heights.size() - 1)]);
        FourSlices& four = groups[k / lanes];
        four.slice.rest.value[k % lanes] = here.rest;
        four.slice.slope_x.value[k % lanes] = here.slope_x;
        four.half_chord.value[k % lanes] = four.point.traction.x.value[k % lanes] = half_chord(here.rest);
    }
    follow(law(creepages), nodes_->positions, groups);
    std::vector<SliceSums<double>> sums(nodes_->heights.size());
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const SliceSums<Quad>& four = groups[k / lanes].sum;
        const auto of = [&](const Quad& values) { return values.value[k % lanes]; };
        sums[k] = {of(four.px), of(four.py), of(four.x_py), of(four.slip)};
    }
    return totals(creepages, sums);
}

FastsimTotals<Dual> FastsimEllipse::totals(const FastsimCreepages<Dual>& creepages) const {
    const FastsimLaw<Dual> shared = law(creepages);
    std::vector<SliceSums<Dual>> sums;
    sums.reserve(nodes_->heights.size());
    for (const double height : nodes_->heights) {
        const FastsimSlice<Dual> here = slice(creepages, axes_.b * height);
        const double half = half_chord(here.rest.value);
        FastsimPoint<Dual> point{{half, 0, 0}};
        SliceSums<Dual>& sum = sums.emplace_back();
        for (const double position : nodes_->positions)
            point = advance(shared, here, point, Dual(half * position), sum);
    }
    return totals(creepages, sums);
}

template <class Number>
FastsimTotals<Number> FastsimEllipse::totals(const FastsimCreepages<Number>& creepages,
                                             const std::vector<SliceSums<Number>>& slices) const {
    const FastsimLaw<Number> shared = law(creepages);
    FastsimTotals<Number> total;
    for (std::size_t k = 0; k < nodes_->heights.size(); ++k) {
        const double y = axes_.b * nodes_->heights[k], dy = axes_.b * nodes_->widths[k];
        const SliceSums<Number>& sum = slices[k];
        total.Fx += dy * sum.px;
        total.Fy += dy * sum.py;
        total.Mz += dy * (sum.x_py - y * sum.px);
        // Slip does the work of the rigid slip: what the springs take up they give back, since the traction is zero at
        // both ends of the slice.
        total.power -= dy * (L_.L1 * slice(creepages, y).slope_x * sum.px +
                             L_.L2 * (shared.slope_y * sum.py + shared.slope_yx * sum.x_py));
        total.slip_area += dy * sum.slip;
    }
    return total;
}

}  // namespace contactd

#include "geometry/placement/spline_along.hpp"

#include <utility>

#include "geometry/profile/natural_spline.hpp"

namespace contactd::geometry {

SplineAlong::SplineAlong(std::vector<double> knots, SliceSpline kind, double period, EqualValues equal)
    : preserving_(std::move(knots), period, equal), kind_(kind), period_(period) {
    for (std::size_t i = 0; i < preserving_.knots().size(); ++i)
        has_gaps_ = has_gaps_ || is_gap(static_cast<std::ptrdiff_t>(i));
}

std::vector<DerivativeShares> SplineAlong::shares(std::span<const SlicePoints> slices) const {
    if (kind_ == SliceSpline::shape_preserving) return preserving_.shares(slices);
    return std::vector<DerivativeShares>(slices.size());
}

LineAlong SplineAlong::line(std::vector<double> values, std::span<const DerivativeShares> shares) const {
    if (kind_ != SliceSpline::shape_preserving) return line(std::move(values));
    std::vector<KnotDerivatives> derivatives = preserving_.derivatives(values, shares);
    return {std::move(values), std::move(derivatives)};
}

LineAlong SplineAlong::line(std::vector<double> values) const {
    if (kind_ == SliceSpline::shape_preserving) {
        std::vector<KnotDerivatives> derivatives = preserving_.derivatives(values);
        return {std::move(values), std::move(derivatives)};
    }
    if (has_gaps_) return between_gaps(std::move(values));
    return kind_ == SliceSpline::cubic ? cubic(values) : approximating(values);
}

LineAlong SplineAlong::between_gaps(std::vector<double> values) const {
    const KnotsAlong& along = preserving_.along();
    const auto n = static_cast<std::ptrdiff_t>(values.size());
    LineAlong line{std::move(values), std::vector<KnotDerivatives>(along.size())};
    for (std::ptrdiff_t gap = 0; gap < n; ++gap) {
        if (!is_gap(gap)) continue;
        std::vector<double> at{along.place(gap + 1)}, of_part{line.values[along.wrapped(gap + 1)]};
        for (std::ptrdiff_t piece = gap + 1; !is_gap(piece); ++piece) {
            at.push_back(along.place(piece + 1));
            of_part.push_back(line.values[along.wrapped(piece + 1)]);
        }
        if (at.size() < 3) continue;
        const LineAlong part = SplineAlong(std::move(at), kind_).line(std::move(of_part));
        for (std::size_t k = 1; k + 1 < part.values.size(); ++k) {
            const std::size_t knot = along.wrapped(gap + 1 + static_cast<std::ptrdiff_t>(k));
            line.values[knot] = part.values[k];
            line.derivatives[knot] = part.derivatives[k];
        }
    }
    return line;
}

// Beyond the ends, knots and values are extrapolated or periodic.
double SplineAlong::knot(std::ptrdiff_t index) const {
    const std::vector<double>& at = knots();
    const auto n = static_cast<std::ptrdiff_t>(at.size());
    if (period_ > 0) {
        const std::ptrdiff_t turn = index >= 0 ? index / n : (index - n + 1) / n;
        return at[static_cast<std::size_t>(index - turn * n)] + static_cast<double>(turn) * period_;
    }
    if (index < 0) return at[0] + static_cast<double>(index) * (at[1] - at[0]);
    if (index >= n) return at.back() + static_cast<double>(index - n + 1) * (at.back() - at[at.size() - 2]);
    return at[static_cast<std::size_t>(index)];
}

double SplineAlong::value(std::span<const double> values, std::ptrdiff_t index) const {
    const auto n = static_cast<std::ptrdiff_t>(values.size());
    if (period_ > 0) return values[static_cast<std::size_t>((index % n + n) % n)];
    if (index < 0) return values[0] + static_cast<double>(index) * (values[1] - values[0]);
    if (index >= n)
        return values.back() + static_cast<double>(index - n + 1) * (values.back() - values[values.size() - 2]);
    return values[static_cast<std::size_t>(index)];
}

LineAlong SplineAlong::cubic(std::span<const double> values) const {
    // The effect of a natural end decays by 0.27 per knot, so at this distance a periodic spline is the same.
    const auto beyond = static_cast<std::ptrdiff_t>(period_ > 0 ? 40 : 0),
               n = static_cast<std::ptrdiff_t>(values.size());
    std::vector<double> t, v;
    for (std::ptrdiff_t i = -beyond; i < n + beyond; ++i) {
        t.push_back(knot(i));
        v.push_back(value(values, i));
    }
    const std::vector<double> curving = natural_curving(t, v);
    LineAlong line{{values.begin(), values.end()}, {}};
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i + beyond);
        const bool last = k + 1 == t.size();
        const std::size_t a = last ? k - 1 : k, b = a + 1;
        const double h = t[b] - t[a], chord = (v[b] - v[a]) / h;
        const double slope =
            last ? chord + h / 6 * (curving[a] + 2 * curving[b]) : chord - h / 6 * (2 * curving[a] + curving[b]);
        line.derivatives.push_back({slope, curving[k]});
    }
    return line;
}

// Three control points determine the spline at a knot, with weights from the five knots around it (de Boor, A Practical
// Guide to Splines, chapter X).
LineAlong SplineAlong::approximating(std::span<const double> values) const {
    LineAlong line;
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(values.size()); ++i) {
        const double t = knot(i), before = knot(i - 1), behind = knot(i + 1), around = behind - before;
        const double rise_before = 3 * (value(values, i) - value(values, i - 1)) / (behind - knot(i - 2));
        const double rise_behind = 3 * (value(values, i + 1) - value(values, i)) / (knot(i + 2) - before);
        const double left = (behind - t) / around, right = (t - before) / around;
        line.values.push_back(value(values, i) - (behind - t) * left * rise_before / 3 +
                              (t - before) * right * rise_behind / 3);
        line.derivatives.push_back(
            {left * rise_before + right * rise_behind, 2 * (rise_behind - rise_before) / around});
    }
    return line;
}

}  // namespace contactd::geometry

#include "geometry/placement/quintic_spline.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace contactd::geometry {
namespace {

constexpr double same = 1e-9;       // mm: of values that are equal
constexpr double steepest = 3;      // slopes, over the lesser chord
constexpr double around_top = 1.5;  // slopes, over that of parabolas, beside an extremum
constexpr double most_bent = 2;     // second derivatives, over the largest second difference around

double minmod(double a, double b) {
    return a * b > 0 ? std::copysign(std::min(std::abs(a), std::abs(b)), a) : 0;
}

/// Limits the size of a value, keeping its sign.
double limited(double value, double limit) {
    return limit >= 0 ? std::clamp(value, 0.0, limit) : std::clamp(value, limit, 0.0);
}

/// Weights of the first and the second derivative at `x` of the polynomial through points (Fornberg, Math. Comp. 51,
/// 1988).
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

/// The values of one curve, their chords and second differences, and what these allow.
class QuinticSpline::Limiter {
   public:
    Limiter(const QuinticSpline& spline, std::span<const double> values) : spline_(spline), values_(values) {}

    KnotDerivatives of_shape(std::size_t knot, const KnotDerivatives& smooth) const {
        const auto i = static_cast<std::ptrdiff_t>(knot);
        const bool first = !exists(i - 1), last = !exists(i);
        const double before = first ? chord(i) : chord(i - 1), behind = last ? chord(i - 1) : chord(i);
        if ((before == 0 && !is_top(i - 1)) || (behind == 0 && !is_top(i))) return {};
        const double lesser = minmod(before, behind);
        const double left = first ? behind : before + minmod(bend(i - 1), bend(i)) * width(i - 1);
        const double right = last ? before : behind - minmod(bend(i), bend(i + 1)) * width(i);
        const double top = minmod(left, right);
        const double limit = std::copysign(std::max(steepest * std::abs(lesser), around_top * std::abs(top)),
                                           lesser != 0 ? lesser : top);
        // Beside an extremum both parabolas may lead to slopes of either sign, the true one is between.
        const double weight = lesser == 0 ? smoothness(i) : 0;
        const double low = std::min({0.0, limit, weight * around_top * std::min(left, right)});
        const double high = std::max({0.0, limit, weight * around_top * std::max(left, right)});
        const double largest = std::max({std::abs(bend(i - 1)), std::abs(bend(i)), std::abs(bend(i + 1))});
        const double bent = first ? bend(i + 1) : last ? bend(i - 1) : bend(i);
        return {std::clamp(smooth.slope, low, high),
                bent == 0 ? 0 : limited(smooth.curving, std::copysign(2 * most_bent * largest, bent))};
    }

    /// Second derivatives as far as the pieces beside the knot may bend and still ascend, or descend.
    void bend_less(std::size_t knot, std::vector<KnotDerivatives>& at) const {
        const auto i = static_cast<std::ptrdiff_t>(knot);
        auto& [slope, curving] = at[knot];
        if (exists(i) && is_monotone(i, at)) {
            const double least = -4 * slope / width(i);
            curving = chord(i) > 0 ? std::max(curving, least) : std::min(curving, least);
        }
        if (exists(i - 1) && is_monotone(i - 1, at)) {
            const double most = 4 * slope / width(i - 1);
            curving = chord(i - 1) > 0 ? std::min(curving, most) : std::max(curving, most);
        }
    }

    /// Returns the share of the derivatives at both ends of a piece with which its polygon does not turn back in the
    /// middle.
    double share(std::size_t piece, const std::vector<KnotDerivatives>& at) const {
        const auto i = static_cast<std::ptrdiff_t>(piece);
        if (!is_monotone(i, at)) return 1;
        const double h = width(i), rise = chord(i) * h;
        const auto polygon = bezier_ordinates(h, rise, at[piece], at[next(piece)]);
        const double used = (polygon[2] + (rise - polygon[3])) / rise;
        return used > 1 ? 1 / used : 1;
    }

    bool exists(std::ptrdiff_t piece) const {
        return spline_.period_ > 0 || (piece >= 0 && piece + 1 < static_cast<std::ptrdiff_t>(values_.size()));
    }
    std::size_t next(std::size_t knot) const { return (knot + 1) % values_.size(); }

   private:
    double width(std::ptrdiff_t piece) const { return spline_.place(piece + 1) - spline_.place(piece); }
    double value(std::ptrdiff_t knot) const { return values_[static_cast<std::size_t>(spline_.wrapped(knot))]; }
    double chord(std::ptrdiff_t piece) const {
        const double rise = value(piece + 1) - value(piece);
        return std::abs(rise) <= same ? 0 : rise / width(piece);
    }
    /// Second divided difference around a knot; zero where one side is missing.
    double bend(std::ptrdiff_t knot) const {
        if (!exists(knot - 1) || !exists(knot)) return 0;
        return (chord(knot) - chord(knot - 1)) / (spline_.place(knot + 1) - spline_.place(knot - 1));
    }
    /// Whether second differences around a knot are those of a smooth curve: 0 where the least is a quarter of the
    /// largest or less, 1 where it is a half or more.
    double smoothness(std::ptrdiff_t knot) const {
        const double before = bend(knot - 1), here = bend(knot), behind = bend(knot + 1);
        const double least = std::abs(minmod(minmod(before, here), behind));
        const double largest = std::max({std::abs(before), std::abs(here), std::abs(behind)});
        return largest > 0 ? std::clamp(4 * least / largest - 1, 0.0, 1.0) : 0;
    }
    /// Whether values turn between two that are equal, and so smoothly that four second differences tell.
    bool is_top(std::ptrdiff_t piece) const {
        if (spline_.equal_ != EqualValues::may_flank_extremum) return false;
        const double sign = bend(piece);
        return bend(piece - 1) * sign > 0 && bend(piece + 1) * sign > 0 && bend(piece + 2) * sign > 0;
    }
    /// Whether a piece ascends or descends throughout. It does not where an extremum is known to lie in it.
    bool is_monotone(std::ptrdiff_t piece, const std::vector<KnotDerivatives>& at) const {
        const double rise = chord(piece);
        const auto fits = [&](std::ptrdiff_t knot) {
            const double slope = at[static_cast<std::size_t>(spline_.wrapped(knot))].slope;
            return slope * rise >= 0 && std::abs(slope) <= steepest * std::abs(rise) * (1 + 1e-12);
        };
        return rise != 0 && fits(piece) && fits(piece + 1);
    }

    const QuinticSpline& spline_;
    std::span<const double> values_;
};

QuinticSpline::QuinticSpline(std::vector<double> knots, double period, EqualValues equal)
    : knots_(std::move(knots)), period_(period), equal_(equal) {
    for (std::size_t i = 0; i < knots_.size(); ++i) stencils_.push_back(stencil_at(i));
}

double QuinticSpline::width(std::size_t knot) const {
    const auto i = static_cast<std::ptrdiff_t>(knot);
    return place(i + 1) - place(i);
}

std::ptrdiff_t QuinticSpline::wrapped(std::ptrdiff_t knot) const {
    const auto count = static_cast<std::ptrdiff_t>(knots_.size());
    return ((knot % count) + count) % count;
}

double QuinticSpline::place(std::ptrdiff_t knot) const {
    const std::ptrdiff_t within = wrapped(knot);
    const auto periods = static_cast<double>((knot - within) / static_cast<std::ptrdiff_t>(knots_.size()));
    return knots_[static_cast<std::size_t>(within)] + periods * period_;
}

QuinticSpline::Stencil QuinticSpline::stencil_at(std::size_t knot) const {
    constexpr std::ptrdiff_t reach = 2;
    const auto count = static_cast<std::ptrdiff_t>(knots_.size()), at = static_cast<std::ptrdiff_t>(knot);
    std::ptrdiff_t from = at - reach, to = at + reach;
    if (period_ == 0) {
        from = std::clamp(from, std::ptrdiff_t{0}, std::max(std::ptrdiff_t{0}, count - 1 - 2 * reach));
        to = std::min(from + 2 * reach, count - 1);
    }
    Stencil stencil;
    std::vector<double> places;
    for (std::ptrdiff_t i = from; i <= to; ++i) {
        stencil.knots.push_back(static_cast<std::size_t>(wrapped(i)));
        places.push_back(place(i));
    }
    std::tie(stencil.first, stencil.second) = derivative_weights(knots_[knot], places);
    return stencil;
}

std::vector<KnotDerivatives> QuinticSpline::derivatives(std::span<const double> values) const {
    const Limiter limiter(*this, values);
    std::vector<KnotDerivatives> at;
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        KnotDerivatives smooth;
        const Stencil& stencil = stencils_[i];
        for (std::size_t k = 0; k < stencil.knots.size(); ++k) {
            const double value = values[stencil.knots[k]] - values[i];
            smooth.slope += stencil.first[k] * value;
            smooth.curving += stencil.second[k] * value;
        }
        at.push_back(limiter.of_shape(i, smooth));
    }
    for (std::size_t i = 0; i < knots_.size(); ++i) limiter.bend_less(i, at);
    std::vector<double> shares(knots_.size(), 1.0);
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        if (!limiter.exists(static_cast<std::ptrdiff_t>(i))) continue;
        const double share = limiter.share(i, at);
        for (double* end : {&shares[i], &shares[limiter.next(i)]}) *end = std::min(*end, share);
    }
    for (std::size_t i = 0; i < knots_.size(); ++i) at[i] = {shares[i] * at[i].slope, shares[i] * at[i].curving};
    return at;
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

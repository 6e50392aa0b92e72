#include "geometry/placement/slice_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/placement/quintic_spline.hpp"
#include "geometry/placement/shape_bounds.hpp"

namespace contactd::geometry {
namespace {

double dot(const SlicePoints& a, const SlicePoints& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double length(const SlicePoints& a) {
    return std::sqrt(dot(a, a));
}

/// Treats slices as points of a space with a dimension for each of their coordinates. The limits of a curve there are
/// determined along the direction of each derivative, and of each chord.
class SliceShape {
   public:
    SliceShape(const KnotsAlong& knots, std::span<const DerivativeStencil> stencils,
               std::span<const SlicePoints> slices, EqualValues equal)
        : knots_(knots), slices_(slices), along_(slices.size()), shares_(slices.size()) {
        for (std::size_t i = 0; i < slices.size(); ++i) {
            slopes_.push_back(weighted(stencils[i], stencils[i].first, i));
            curvings_.push_back(weighted(stencils[i], stencils[i].second, i));
        }
        for (std::size_t i = 0; i < slices.size(); ++i) flat_.push_back(is_flat(i, equal));
    }

    std::vector<DerivativeShares> shares() {
        for (std::size_t i = 0; i < slices_.size(); ++i) shares_[i] = of_values(i);
        for (std::size_t i = 0; i < slices_.size(); ++i) bend_less(i);
        std::vector<double> less(slices_.size(), 1.0);
        for (std::size_t i = 0; i < slices_.size(); ++i) {
            const double share = of_polygon(i);
            for (double* end : {&less[i], &less[knots_.next(i)]}) *end = std::min(*end, share);
        }
        for (std::size_t i = 0; i < slices_.size(); ++i)
            shares_[i] = {less[i] * shares_[i].slope, less[i] * shares_[i].curving};
        return shares_;
    }

   private:
    struct Piece {
        double rise, width;
        KnotDerivatives from, to;  // along the chord

        /// Returns whether the piece must ascend throughout; a piece that contains an extremum need not.
        bool ascends() const {
            return rise > 0 && from.slope >= 0 && to.slope >= 0 && admits(from.slope) && admits(to.slope);
        }
        bool admits(double slope) const { return slope <= steepest_slope * rise / width * (1 + 1e-12); }
    };

    SlicePoints weighted(const DerivativeStencil& stencil, const std::vector<double>& weights, std::size_t knot) const {
        SlicePoints sum(slices_[knot].size());
        for (std::size_t k = 0; k < stencil.knots.size(); ++k)
            for (std::size_t j = 0; j < sum.size(); ++j)
                sum[j] += weights[k] * (slices_[stencil.knots[k]][j] - slices_[knot][j]);
        return sum;
    }

    /// Returns the bounds of the slices around a knot, projected on a direction.
    ShapeBounds seen_along(const SlicePoints& direction, std::size_t knot) {
        constexpr std::ptrdiff_t reach = 3;
        const auto i = static_cast<std::ptrdiff_t>(knot), last = static_cast<std::ptrdiff_t>(slices_.size()) - 1;
        const double size = length(direction);
        for (std::ptrdiff_t beside = i - reach; beside <= i + reach; ++beside) {
            if (knots_.period() == 0 && (beside < 0 || beside > last)) continue;
            const std::size_t at = knots_.wrapped(beside);
            double sum = 0;
            for (std::size_t j = 0; j < direction.size(); ++j)
                sum += direction[j] * (slices_[at][j] - slices_[knot][j]);
            along_[at] = size > 0 ? sum / size : 0;
        }
        return {knots_, along_};
    }

    SlicePoints rise(std::size_t piece) const {
        SlicePoints rise = slices_[knots_.next(piece)];
        for (std::size_t j = 0; j < rise.size(); ++j) rise[j] -= slices_[piece][j];
        return rise;
    }

    bool is_flat(std::size_t piece, EqualValues equal) {
        if (!exists(piece)) return false;
        if (std::ranges::any_of(rise(piece), [](double by) { return std::abs(by) > same_value; })) return false;
        if (equal == EqualValues::stay) return true;
        SlicePoints bend = curvings_[piece];
        const SlicePoints& other = curvings_[knots_.next(piece)];
        for (std::size_t j = 0; j < bend.size(); ++j) bend[j] += other[j];
        return !seen_along(bend, piece).is_top(static_cast<std::ptrdiff_t>(piece));
    }

    DerivativeShares of_values(std::size_t knot) {
        const std::size_t before = knots_.wrapped(static_cast<std::ptrdiff_t>(knot) - 1);
        if (flat_[knot] || flat_[before]) return {0, 0};
        const auto share = [](double bound, double size) { return size > bound ? bound / size : 1; };
        return {share(seen_along(slopes_[knot], knot).largest_slope(knot), length(slopes_[knot])),
                share(seen_along(curvings_[knot], knot).largest_curving(knot), length(curvings_[knot]))};
    }

    Piece piece(std::size_t i) const {
        const SlicePoints chord = rise(i);
        const double size = length(chord), scale = size > 0 ? 1 / size : 0;
        const auto at = [&](std::size_t knot) {
            return KnotDerivatives{shares_[knot].slope * dot(slopes_[knot], chord) * scale,
                                   shares_[knot].curving * dot(curvings_[knot], chord) * scale};
        };
        return {size > same_value ? size : 0, knots_.width(static_cast<std::ptrdiff_t>(i)), at(i), at(knots_.next(i))};
    }

    /// Limits second derivatives so that the adjacent pieces still ascend.
    void bend_less(std::size_t knot) {
        double& share = shares_[knot].curving;
        if (exists(knot)) {
            const Piece behind = piece(knot);
            const double least = -4 * behind.from.slope / behind.width;
            if (behind.ascends() && behind.from.curving < least) share *= least / behind.from.curving;
            bend_as_chord(knot, knot, behind);
        }
        const std::size_t last = knots_.wrapped(static_cast<std::ptrdiff_t>(knot) - 1);
        if (exists(last)) {
            const Piece before = piece(last);
            const double most = 4 * before.to.slope / before.width;
            if (before.ascends() && before.to.curving > most) share *= most / before.to.curving;
            bend_as_chord(knot, last, before);
        }
    }

    /// A chord of slices that are almost equal has an arbitrary direction. If both slopes are those of its piece, the
    /// piece does not bend by more than the ordinates of an ascending polygon allow, in any direction.
    void bend_as_chord(std::size_t knot, std::size_t index, const Piece& at) {
        const auto slope = [this](std::size_t end) { return shares_[end].slope * length(slopes_[end]); };
        if (!at.admits(slope(index)) || !at.admits(slope(knots_.next(index)))) return;
        const double most = 20 * at.rise / (at.width * at.width);
        const double size = shares_[knot].curving * length(curvings_[knot]);
        if (size > most) shares_[knot].curving *= most / size;
    }

    /// Returns the factor on the derivatives at both ends of a piece with which its polygon does not reverse in the
    /// middle.
    double of_polygon(std::size_t i) const {
        if (!exists(i)) return 1;
        const Piece at = piece(i);
        if (!at.ascends()) return 1;
        const auto polygon = bezier_ordinates(at.width, at.rise, at.from, at.to);
        const double used = (polygon[2] + (at.rise - polygon[3])) / at.rise;
        return used > 1 ? 1 / used : 1;
    }

    bool exists(std::size_t piece) const { return knots_.exists(static_cast<std::ptrdiff_t>(piece)); }

    const KnotsAlong& knots_;
    std::span<const SlicePoints> slices_;
    std::vector<SlicePoints> slopes_, curvings_;
    std::vector<char> flat_;
    std::vector<double> along_;  // positions of slices around the present knot
    std::vector<DerivativeShares> shares_;
};

}  // namespace

std::vector<DerivativeShares> shares_of_shape(const KnotsAlong& knots, std::span<const DerivativeStencil> stencils,
                                              std::span<const SlicePoints> slices, EqualValues equal) {
    return SliceShape(knots, stencils, slices, equal).shares();
}

}  // namespace contactd::geometry

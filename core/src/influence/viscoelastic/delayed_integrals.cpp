#include "influence/viscoelastic/delayed_integrals.hpp"

#include <algorithm>
#include <cmath>

#include "influence/layered/gauss_legendre.hpp"

namespace contactd {
namespace {

constexpr double smallest_decay = 45;  // over l: exp(-45) is below rounding errors
// Singularities of the kernel are at the edges of the load. If these are at least one and a half panel lengths away,
// the error of polynomials through a panel's points is 7.9^-points.
constexpr double smooth_distance = 1.5;
constexpr int finest_level = 24;            // limit for halving an element; next to an edge the kernel is bounded
constexpr double growth_beyond = 0.6;       // length of a panel beyond the elements over its distance from the load
constexpr double longest_piece_over_l = 6;  // largest one for which the rule below is exact
constexpr int points_of_piece = 32;

const std::vector<GaussPoint>& panel_rule() {
    static const std::vector<GaussPoint> rule = gauss_legendre(static_cast<int>(DelayWeights::points));
    return rule;
}

const std::vector<GaussPoint>& piece_rule() {
    static const std::vector<GaussPoint> rule = gauss_legendre(points_of_piece);
    return rule;
}

/// Returns Legendre's polynomials of degrees below DelayWeights::points at t in 0 to 1.
std::array<double, DelayWeights::points> legendre(double t) {
    const double x = 2 * t - 1;
    std::array<double, DelayWeights::points> p{1, x};
    for (std::size_t n = 2; n < p.size(); ++n) {
        const double m = static_cast<double>(n);
        p[n] = ((2 * m - 1) * x * p[n - 1] - (m - 1) * p[n - 2]) / m;
    }
    return p;
}

void add(KernelIntegrals& sum, double factor, const KernelIntegrals& k) {
    sum.xx += factor * k.xx;
    sum.yy += factor * k.yy;
    sum.xy += factor * k.xy;
    sum.x += factor * k.x;
    sum.y += factor * k.y;
}

}  // namespace

double DelayWeights::node(std::size_t i) {
    return panel_rule()[i].node;
}

// Computes the moments of Legendre's polynomials, integrated in pieces that are short enough for exp(-s/l).
DelayWeights::DelayWeights(double length_over_l) {
    const double end = std::min(length_over_l, smallest_decay);
    const int pieces = std::max(static_cast<int>(std::ceil(end / longest_piece_over_l)), 1);
    std::array<double, points> moments{};
    for (int piece = 0; piece < pieces; ++piece)
        for (const GaussPoint& point : piece_rule()) {
            const double s = end * (piece + point.node) / pieces;
            const double weight = end / pieces * point.weight * std::exp(-s);
            const auto p = legendre(s / length_over_l);
            for (std::size_t m = 0; m < points; ++m) moments[m] += weight * p[m];
        }
    for (std::size_t i = 0; i < points; ++i) {
        const auto p = legendre(node(i));
        for (std::size_t m = 0; m < points; ++m)
            weights_[i] += panel_rule()[i].weight * static_cast<double>(2 * m + 1) * p[m] * moments[m];
    }
}

DelayedIntegrals::DelayedIntegrals(const HalfSpaceModel& model, double dx, double dy, int first_k, int last_k,
                                   double shift, double l)
    : model_(model),
      dx_(dx),
      dy_(dy),
      l_(l),
      first_k_(first_k),
      last_k_(last_k),
      end_k_(std::max(last_k, static_cast<int>(std::ceil(4 - shift)))),
      shift_(shift),
      reach_(model.load_shape == LoadShape::bilinear ? dx : 0.5 * dx) {
    edges_ = {-reach_, reach_};
    if (model.load_shape == LoadShape::bilinear) edges_.push_back(0);
    double x = (end_k_ + shift) * dx;
    const double first = x;
    while (x - first < smallest_decay * l) {
        const double length = growth_beyond * (x - reach_);
        beyond_.push_back({x, length, std::exp(-(x - first) / l), DelayWeights(length / l)});
        x += length;
    }
}

const DelayWeights& DelayedIntegrals::weights_of(int level) {
    const auto found = of_level_.find(level);
    if (found != of_level_.end()) return found->second;
    return of_level_.emplace(level, DelayWeights(std::ldexp(dx_, -level) / l_)).first->second;
}

bool DelayedIntegrals::is_smooth(double x, double y, double length) const {
    const double half = model_.load_shape == LoadShape::bilinear ? dy_ : 0.5 * dy_;
    const double beside = model_.line_contact ? 0 : std::max(std::abs(y) - half, 0.0);
    return std::all_of(edges_.begin(), edges_.end(), [&](double edge) {
        return std::hypot(std::max({x - edge, edge - (x + length), 0.0}), beside) >= smooth_distance * length;
    });
}

KernelIntegrals DelayedIntegrals::sum(double x, double y, double length, const DelayWeights& weights) const {
    KernelIntegrals result;
    for (std::size_t i = 0; i < DelayWeights::points; ++i)
        add(result, weights[i], model_.integrals(x + length * DelayWeights::node(i), y, dx_, dy_));
    return result;
}

// Halves panels that are too near to an edge of the load.
KernelIntegrals DelayedIntegrals::panel(double x, double y, int level) {
    const double length = std::ldexp(dx_, -level);
    if (level == finest_level || is_smooth(x, y, length)) return sum(x, y, length, weights_of(level));
    KernelIntegrals result = panel(x, y, level + 1);
    if (length < 2 * smallest_decay * l_)
        add(result, std::exp(-0.5 * length / l_), panel(x + 0.5 * length, y, level + 1));
    return result;
}

std::vector<KernelIntegrals> DelayedIntegrals::row(double y) {
    KernelIntegrals now;
    for (const Panel& panel : beyond_) add(now, panel.decay, sum(panel.x, y, panel.length, panel.weights));
    std::vector<KernelIntegrals> result(static_cast<std::size_t>(last_k_ - first_k_ + 1));
    const double decay = std::exp(-dx_ / l_);
    for (int k = end_k_;; --k) {
        if (k <= last_k_) result[static_cast<std::size_t>(k - first_k_)] = now;
        if (k == first_k_) return result;
        KernelIntegrals ahead = panel((k - 1 + shift_) * dx_, y, 0);
        add(ahead, decay, now);
        now = ahead;
    }
}

}  // namespace contactd

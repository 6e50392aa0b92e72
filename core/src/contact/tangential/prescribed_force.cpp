#include "prescribed_force.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "contact/support/solver_support.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using Pair = std::array<double, 2>;  // x, y

constexpr double loosest = 1e-3;        // tolerance of the solver's first calls
constexpr double expected_gain = 0.01;  // tolerance of a call over the last residual: that falls tenfold at least
constexpr double full_slip = 0.999;     // force over the largest one
constexpr double longest_step = 4;      // in units of the rigid slip or its scale
constexpr double expansion = 4;         // of a step that was far too short
constexpr double good_enough = 0.3;     // slope that a line search leaves, over the one it found
constexpr int patience = 3;             // calls of Broyden's method that do not halve the residual
constexpr double rounding = 1e-12;

double dot_product(const Pair& a, const Pair& b) {
    return a[0] * b[0] + a[1] * b[1];
}
double length(const Pair& a) {
    return std::hypot(a[0], a[1]);
}
Pair difference(const Pair& a, const Pair& b) {
    return {a[0] - b[0], a[1] - b[1]};
}

// A 2 x 2 matrix, times a vector from either side.
using Matrix = std::array<Pair, 2>;
Pair operator*(const Matrix& m, const Pair& a) {
    return {dot_product(m[0], a), dot_product(m[1], a)};
}
Pair operator*(const Pair& a, const Matrix& m) {
    return {a[0] * m[0][0] + a[1] * m[1][0], a[0] * m[0][1] + a[1] * m[1][1]};
}

struct Sample {
    Pair w{}, slip{};  // rigid slip, and the one of the model for the force
    Pair off{};        // force - prescribed, over the largest; zero where none is prescribed
    double residual = std::numeric_limits<double>::infinity();
};

class Search {
   public:
    Search(const PrescribedForces& prescribed, const SolverSettings& settings, const SolveForForces& solve,
           Observer& observer)
        : prescribed_(prescribed), settings_(settings), solve_(solve), observer_(observer) {
        is_free_ = {prescribed.Fx.has_value(), prescribed.Fy.has_value()};
        wanted_ = {prescribed.Fx.value_or(0), prescribed.Fy.value_or(0)};
        check();
        target_ = model_slip(wanted_);
        scale_ = prescribed.scale > 0 ? prescribed.scale : 1;
    }

    RigidSlipForForces find() {
        Sample last = call({prescribed_.wx, prescribed_.wy});
        if (goes_on()) last = leave_full_slip(last);
        if (goes_on()) last = solve_by_model(last);
        if (goes_on()) last = descend(best_);
        if (!evidence_.converged && best_.residual < last.residual) last = call_once(best_.w, settings_.tolerance);
        return {last.w[0], last.w[1], evidence_};
    }

   private:
    void check() const {
        const double force = length(wanted_);
        if (!std::isfinite(force)) throw InvalidArgument(prescribed_.field, "is not a finite number");
        const double most = largest_force_with_a_slip(prescribed_.largest, settings_);
        if (force > 0 && force >= most)
            throw InvalidArgument(prescribed_.field,
                                  "is " + number_text(force) + " N; friction carries less than " +
                                      number_text(prescribed_.largest) + " N, the sum of its bounds, and from " +
                                      number_text(most) +
                                      " N on all slips, so that no force tells one slip from a longer one");
    }

    // Force turned into the rigid slip, over its scale, that a sphere would have under it.
    Pair model_slip(Pair force) const {
        for (std::size_t i : {0u, 1u})
            if (!is_free_[i]) force[i] = 0;
        const double size = length(force);
        if (!(size > 0)) return {};
        const double part = std::min(size / prescribed_.largest, 1.0);
        const double slip = 1 - std::pow(1 - part, 1 / prescribed_.exponent);
        return {slip * force[0] / size, slip * force[1] / size};
    }

    bool goes_on() const { return !evidence_.converged && calls_ < settings_.max_iterations; }

    // Again with the final tolerance where a looser one met the force already.
    Sample call(const Pair& w) {
        const bool was_final = tolerance_ <= settings_.tolerance;
        Sample sample = call_once(w, tolerance_);
        if (sample.residual <= settings_.tolerance && !was_final && goes_on())
            sample = call_once(w, settings_.tolerance);
        if (sample.residual < best_.residual) best_ = sample;
        // A solution as exact as the forces have to be may still be too rough to find them with.
        const double least = was_final ? 0.1 * settings_.tolerance : settings_.tolerance;
        tolerance_ = std::clamp(expected_gain * best_.residual, least, loosest);
        return sample;
    }

    Sample call_once(const Pair& w, double tolerance) {
        observer_.throw_if_cancelled();
        const ForcesAtSlip forces = solve_(w[0], w[1], tolerance);
        ++calls_;
        Sample sample{w, model_slip({forces.Fx, forces.Fy}), {}, 0};
        const Pair off = difference({forces.Fx, forces.Fy}, wanted_);
        for (std::size_t i : {0u, 1u})
            if (is_free_[i] && off[i] != 0) sample.off[i] = off[i] / prescribed_.largest;
        sample.residual = length(sample.off);
        const bool is_met = sample.residual <= settings_.tolerance;
        evidence_ = {calls_, sample.residual, is_met && tolerance <= settings_.tolerance && forces.converged, 0};
        if (calls_ == 1) first_residual_ = sample.residual;
        observer_.on_progress(
            {"force", log_fraction(first_residual_, sample.residual, settings_.tolerance), calls_, sample.residual});
        return sample;
    }

    // An estimate far in full slip is no better than none.
    Sample leave_full_slip(const Sample& first) {
        const double full = 1 - std::pow(1 - full_slip, 1 / prescribed_.exponent);
        if (length(first.slip) < full || length(target_) >= full) return first;
        Pair w = first.w;
        for (std::size_t i : {0u, 1u})
            if (is_free_[i]) w[i] = -scale_ * target_[i];
        return call(w);
    }

    // Broyden's method on the model's slip, a nearly linear function of the rigid slip. Ends when it gets on slowly.
    Sample solve_by_model(Sample last) {
        Matrix inverse{{{-scale_, 0}, {0, -scale_}}};  // of d(model slip)/dw
        double halved = best_.residual;
        for (int without_gain = 0; goes_on() && without_gain < patience;) {
            const Pair from = last.w, missing = difference(last.slip, target_);
            Pair step = inverse * missing;
            const double most = longest_step * std::max(length(from), scale_);
            const double factor = std::min(1.0, most / std::max(length(step), rounding * most));
            for (double& component : step) component *= -factor;
            const Sample next = call({from[0] + step[0], from[1] + step[1]});
            const Pair change = difference(next.slip, last.slip), expected = inverse * change;
            const double denominator = dot_product(step, expected);
            if (denominator > 0) {
                const Pair row = step * inverse;
                for (std::size_t i : {0u, 1u})
                    for (std::size_t j : {0u, 1u}) inverse[i][j] += (step[i] - expected[i]) * row[j] / denominator;
            }
            ++without_gain;
            if (best_.residual <= 0.5 * halved) {
                halved = best_.residual;
                without_gain = 0;
            }
            last = next;
        }
        return last;
    }

    // The forces are the gradient of a concave potential of the rigid slip, at least of a shift: BFGS with line
    // searches finds its highest point from anywhere, also where the potential is nearly flat.
    Sample descend(Sample at) {
        Matrix inverse{{{scale_, 0}, {0, scale_}}};
        while (goes_on()) {
            Pair direction = inverse * at.off;
            if (!(dot_product(direction, at.off) > 0)) {
                inverse = {{{scale_, 0}, {0, scale_}}};
                direction = inverse * at.off;
            }
            const Sample next = search_line(at, direction);
            const Pair step = difference(next.w, at.w), fall = difference(at.off, next.off);
            const double curvature = dot_product(step, fall);
            if (!(length(step) > 0)) break;
            if (curvature > 0) {
                const Pair expected = inverse * fall;
                const double factor = 1 + dot_product(fall, expected) / curvature;
                for (std::size_t i : {0u, 1u})
                    for (std::size_t j : {0u, 1u})
                        inverse[i][j] +=
                            (factor * step[i] * step[j] - step[i] * expected[j] - expected[i] * step[j]) / curvature;
            }
            at = next;
        }
        return at;
    }

    // The slope (off, direction) falls along the line: brackets its zero and closes in by false position.
    Sample search_line(const Sample& start, const Pair& direction) {
        const double first_slope = dot_product(start.off, direction);
        const double infinite = std::numeric_limits<double>::infinity();
        double low = 0, high = infinite, low_slope = first_slope, high_slope = 0, length_ = 1;
        Sample last = start;
        while (goes_on()) {
            last = call({start.w[0] + length_ * direction[0], start.w[1] + length_ * direction[1]});
            const double slope = dot_product(last.off, direction);
            if (std::abs(slope) <= good_enough * first_slope) return last;
            (slope > 0 ? low : high) = length_;
            (slope > 0 ? low_slope : high_slope) = slope;
            if (high == infinite) {
                length_ *= expansion;
                continue;
            }
            if (high - low <= rounding * high) break;
            const double part = std::clamp(low_slope / (low_slope - high_slope), 0.1, 0.9);
            length_ = low + part * (high - low);
        }
        return last;
    }

    const PrescribedForces& prescribed_;
    const SolverSettings& settings_;
    const SolveForForces& solve_;
    Observer& observer_;
    std::array<bool, 2> is_free_;
    Pair wanted_, target_{};  // force, and slip of the model for it
    double scale_;
    Sample best_;
    SolverEvidence evidence_;
    double tolerance_ = loosest;
    double first_residual_ = 0;
    int calls_ = 0;
};

}  // namespace

double largest_force_with_a_slip(double largest, const SolverSettings& settings) {
    return largest * (1 - std::min(settings.tolerance, loosest));
}

RigidSlipForForces find_rigid_slip(const PrescribedForces& prescribed, const SolverSettings& settings,
                                   const SolveForForces& solve, Observer& observer) {
    const Stopwatch stopwatch;
    RigidSlipForForces result = Search(prescribed, settings, solve, observer).find();
    result.evidence.seconds = stopwatch.seconds();
    return result;
}

double slip_scale(const InfluenceOperator& influence, std::span<const double> bound) {
    require_size(bound, influence.size(), "bound");
    const std::vector<double> zero(bound.size());
    std::vector<double> ux(bound.size()), uy(bound.size());
    influence.tangential(bound, zero, ux, uy);
    double scale = 0;
    for (std::size_t i = 0; i < bound.size(); ++i)
        if (bound[i] > 0) scale = std::max(scale, std::abs(ux[i]));
    return scale;
}

}  // namespace contactd

#include "prescribed_force.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "contact/support/solver_support.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using Matrix = Eigen::Matrix2d;

constexpr double loosest = 1e-3;        // tolerance of the solver's first calls
constexpr double expected_gain = 0.01;  // tolerance of a call over the last residual, which decreases at least tenfold
constexpr double full_slip = 0.999;     // force over the largest one
constexpr double longest_step = 4;      // in units of the rigid slip or its scale
constexpr double expansion = 4;         // factor on a step that was far too short
constexpr double good_enough = 0.3;     // slope after a line search, over the initial one
constexpr int most_failures = 3;        // calls of Broyden's method that do not halve the residual
constexpr double rounding = 1e-12;

struct Sample {
    Pair w = Pair::Zero(), slip = Pair::Zero();  // rigid slip, and the one of the model for the force
    Pair off = Pair::Zero();                     // force - prescribed, over the largest; zero if none is prescribed
    double residual = std::numeric_limits<double>::infinity();
};

Pair free_components(const PrescribedForces& prescribed) {
    return {prescribed.Fx ? 1 : 0, prescribed.Fy ? 1 : 0};
}

Pair requested_force(const PrescribedForces& prescribed) {
    return {prescribed.Fx.value_or(0), prescribed.Fy.value_or(0)};
}

// Converts a force to the rigid slip, over its scale, of a sphere under it.
Pair model_slip(const PrescribedForces& prescribed, const Pair& force) {
    const Pair acting = force.cwiseProduct(free_components(prescribed));
    const double size = acting.norm();
    if (!(size > 0)) return Pair::Zero();
    const double part = std::min(size / prescribed.largest, 1.0);
    return (1 - std::pow(1 - part, 1 / prescribed.exponent)) / size * acting;
}

class Search {
   public:
    Search(const PrescribedForces& prescribed, const SolverSettings& settings, const SolveForForces& solve,
           Observer& observer)
        : prescribed_(prescribed),
          settings_(settings),
          solve_(solve),
          observer_(observer),
          free_(free_components(prescribed)),
          requested_(requested_force(prescribed)),
          target_(model_slip(prescribed, requested_)),
          scale_(prescribed.scale > 0 ? prescribed.scale : 1) {}

    RigidSlipForForces find() {
        Sample last = call({prescribed_.wx, prescribed_.wy});
        if (goes_on()) last = leave_full_slip(last);
        if (goes_on()) last = solve_by_model(last);
        if (goes_on()) last = descend(best_);
        if (!evidence_.converged && best_.residual < last.residual) last = call_once(best_.w, settings_.tolerance);
        return {last.w.x(), last.w.y(), evidence_};
    }

   private:
    bool goes_on() const { return !evidence_.converged && calls_ < settings_.max_iterations; }

    // Calls the solver, and again with the final tolerance if a looser one already met the force.
    Sample call(const Pair& w) {
        const bool was_final = tolerance_ <= settings_.tolerance;
        Sample sample = call_once(w, tolerance_);
        if (sample.residual <= settings_.tolerance && !was_final && goes_on())
            sample = call_once(w, settings_.tolerance);
        if (sample.residual < best_.residual) best_ = sample;
        // A solution to the tolerance of the forces may be too rough to search with.
        const double least = was_final ? 0.1 * settings_.tolerance : settings_.tolerance;
        tolerance_ = std::clamp(expected_gain * best_.residual, least, loosest);
        return sample;
    }

    Sample call_once(const Pair& w, double tolerance) {
        observer_.throw_if_cancelled();
        const ForcesAtSlip found = solve_(w.x(), w.y(), tolerance);
        const Pair force(found.Fx, found.Fy), off = (force - requested_).cwiseProduct(free_);
        ++calls_;
        Sample sample{w, model_slip(prescribed_, force)};
        if (off != Pair::Zero()) sample.off = off / prescribed_.largest;
        sample.residual = sample.off.norm();
        const bool is_met = sample.residual <= settings_.tolerance;
        evidence_ = {calls_, sample.residual, is_met && tolerance <= settings_.tolerance && found.converged, 0};
        if (calls_ == 1) first_residual_ = sample.residual;
        observer_.on_progress(
            {"force", log_fraction(first_residual_, sample.residual, settings_.tolerance), calls_, sample.residual});
        return sample;
    }

    // Discards an estimate far in full slip, which is as bad as none.
    Sample leave_full_slip(const Sample& first) {
        const double full = 1 - std::pow(1 - full_slip, 1 / prescribed_.exponent);
        if (first.slip.norm() < full || target_.norm() >= full) return first;
        return call(first.w - free_.cwiseProduct(first.w) - scale_ * target_);
    }

    // Applies Broyden's method to the model's slip, a nearly linear function of the rigid slip. Ends if it converges
    // slowly.
    Sample solve_by_model(Sample last) {
        Matrix inverse = -scale_ * Matrix::Identity();  // of d(model slip)/dw
        double halved = best_.residual;
        for (int without_gain = 0; goes_on() && without_gain < most_failures;) {
            Pair step = -inverse * (last.slip - target_);
            const double most = longest_step * std::max(last.w.norm(), scale_);
            step *= std::min(1.0, most / std::max(step.norm(), rounding * most));
            const Sample next = call(last.w + step);
            const Pair expected = inverse * (next.slip - last.slip);
            const double denominator = step.dot(expected);
            if (denominator > 0) inverse += ((step - expected) * (step.transpose() * inverse) / denominator).eval();
            ++without_gain;
            if (best_.residual <= 0.5 * halved) {
                halved = best_.residual;
                without_gain = 0;
            }
            last = next;
        }
        return last;
    }

    // Searches by BFGS with line searches. The forces, at least of a shift, are the gradient of a concave potential of
    // the rigid slip. The search finds its maximum from any start, even if the potential is nearly flat.
    Sample descend(Sample at) {
        Matrix inverse = scale_ * Matrix::Identity();
        while (goes_on()) {
            Pair direction = inverse * at.off;
            if (!(direction.dot(at.off) > 0)) {
                inverse = scale_ * Matrix::Identity();
                direction = inverse * at.off;
            }
            const Sample next = search_line(at, direction);
            const Pair step = next.w - at.w, fall = at.off - next.off;
            const double curvature = step.dot(fall);
            if (!(step.norm() > 0)) break;
            if (curvature > 0) {
                const Pair expected = inverse * fall;
                const Matrix crossed = step * expected.transpose();
                inverse +=
                    ((1 + fall.dot(expected) / curvature) * step * step.transpose() - crossed - crossed.transpose()) /
                    curvature;
            }
            at = next;
        }
        return at;
    }

    // Brackets the zero of the slope (off, direction), which decreases along the line, and refines it by false
    // position.
    Sample search_line(const Sample& start, const Pair& direction) {
        const double first_slope = start.off.dot(direction);
        const double infinite = std::numeric_limits<double>::infinity();
        double low = 0, high = infinite, low_slope = first_slope, high_slope = 0, length = 1;
        Sample last = start;
        while (goes_on()) {
            last = call(start.w + length * direction);
            const double slope = last.off.dot(direction);
            if (std::abs(slope) <= good_enough * first_slope) return last;
            (slope > 0 ? low : high) = length;
            (slope > 0 ? low_slope : high_slope) = slope;
            if (high == infinite) {
                length *= expansion;
                continue;
            }
            if (high - low <= rounding * high) break;
            const double part = std::clamp(low_slope / (low_slope - high_slope), 0.1, 0.9);
            length = low + part * (high - low);
        }
        return last;
    }

    const PrescribedForces& prescribed_;
    const SolverSettings& settings_;
    const SolveForForces& solve_;
    Observer& observer_;
    const Pair free_, requested_, target_;  // 1 for components with a force; force; slip of the model for it
    const double scale_;
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

void require_reachable(const PrescribedForces& prescribed, const SolverSettings& settings) {
    const double force = requested_force(prescribed).norm();
    if (!std::isfinite(force)) throw InvalidArgument(prescribed.field, "is not a finite number");
    const double most = largest_force_with_a_slip(prescribed.largest, settings);
    if (force > 0 && force >= most)
        throw InvalidArgument(
            prescribed.field,
            "is " + number_text(force) + " N; it must be less than " + number_text(most) + " N. At " +
                number_text(prescribed.largest) +
                " N, the sum of the friction bounds, all elements slip, and the force no longer determines the slip");
}

Pair expected_rigid_slip(const PrescribedForces& prescribed) {
    return -prescribed.scale * model_slip(prescribed, requested_force(prescribed));
}

RigidSlipForForces find_rigid_slip(const PrescribedForces& prescribed, const SolverSettings& settings,
                                   const SolveForForces& solve, Observer& observer) {
    require_reachable(prescribed, settings);
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

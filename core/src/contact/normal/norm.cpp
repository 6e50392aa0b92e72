#include "norm.hpp"

#include <algorithm>
#include <cmath>

#include "contact/support/solver_support.hpp"

namespace contactd {
namespace {

// This part of the set may change before the weights of the sum are recomputed. Any weights keep the sum; good ones
// save iterations.
constexpr double outdated = 0.2;

double largest(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

}  // namespace

Norm::Norm(const InfluenceOperator& influence, const NormProblem& problem, const SolverSettings& settings,
           Observer& observer)
    : influence_(influence),
      problem_(problem),
      h_(problem.distance),
      settings_(settings),
      observer_(&observer),
      n_(problem.distance.size()),
      self_(largest(influence.diagonal(Axis::z))) {
    for (Values* values : {&p_, &u_, &r_, &z_, &v_, &q_, &best_p_, &best_u_}) values->resize(n_);
    in_contact_.resize(n_);
    if (problem.pressure_sum) weight_.resize(n_);
}

double Norm::start(std::span<const double> estimate, bool set_is_good) {
    const auto positive = [](double p) { return p > 0; };
    const bool nothing = std::none_of(estimate.begin(), estimate.end(), positive);
    set_is_good_ = set_is_good && !nothing;
    if (problem_.pressure_sum) {
        for (std::size_t i = 0; i < n_; ++i) p_[i] = nothing ? 1 : std::max(estimate[i], 0.0);
        scale_to_sum(p_, u_);
        influence_.normal(p_, u_);
    } else if (!nothing) {
        take_multiple_of(estimate);
    }
    for (std::size_t i = 0; i < n_; ++i) in_contact_[i] = p_[i] > 0;
    watch();
    find_approach();
    check_ = advance(0);
    return check_.reference > 0 ? check_.error() : std::numeric_limits<double>::infinity();
}

void Norm::go_on(const NormProblem& problem, const SolverSettings& settings, Observer& observer) {
    const bool same_sum = problem.pressure_sum == problem_.pressure_sum;
    problem_ = problem;
    h_ = problem.distance;
    settings_ = settings;
    observer_ = &observer;
    set_is_good_ = false;
    failures_ = 0;
    steps_ = 0;
    if (!same_sum) {
        scale_to_sum(p_, u_);
        last_p_.clear();
    }
    find_approach();
    advance(0);
    if (last_p_.empty()) {
        last_p_ = p_;
        last_u_ = u_;
    } else {
        go_along_last_change();
    }
    best_f_ = std::numeric_limits<double>::infinity();
    watch();
    check_ = advance(0);
}

// Outer iterations change the distance by decreasing multiples of nearly the same field.
void Norm::go_along_last_change() {
    for (std::size_t i = 0; i < n_; ++i) {
        v_[i] = p_[i] - last_p_[i];
        q_[i] = u_[i] - last_u_[i];
    }
    last_p_ = p_;
    last_u_ = u_;
    double outside = 0;
    for (std::size_t i = 0; i < n_; ++i) outside += (1 - in_contact_[i]) * std::abs(v_[i]);
    const double curvature = dot(v_, q_);
    if (outside > 0 || !(curvature > 0)) return;
    const double alpha = dot(r_, v_) / curvature;
    // This is not such a series; a change that consists of rounding errors would lead to huge multiples.
    if (!(std::abs(alpha) < 1)) return;
    for (std::size_t i = 0; i < n_; ++i) {
        p_[i] += alpha * v_[i];
        u_[i] += alpha * q_[i];
    }
    find_approach();
}

SolverEvidence Norm::solve() {
    SolverEvidence evidence;
    bool exhausted = false;  // true if no decrease is possible on this set
    for (int iteration = 0;; ++iteration) {
        observer_->throw_if_cancelled();
        const Check check = check_;
        report(iteration, check.residual());
        evidence.iterations = iteration;
        evidence.residual = check.residual();
        evidence.converged = good_enough(check, iteration);
        if (evidence.converged || iteration == settings_.max_iterations) break;
        const bool change_all = exhausted || check.residual() <= settings_.tolerance;
        const bool changed = !(iteration == 0 && set_is_good_) && change_set(check, change_all);
        if (exhausted && !changed) break;
        const double alpha = choose_step();
        exhausted = alpha == 0;
        check_ = advance(alpha);
    }
    if (!evidence.converged) {
        clip();
        evidence.residual = advance(0).residual();
    }
    return evidence;
}

bool Norm::good_enough(const Check& check, int iteration) const {
    if (problem_.estimate_only && iteration > 0 && check.error() <= settings_.tolerance) return true;
    return check.residual() <= settings_.tolerance && check.right_set();
}

// Takes the multiple of the estimate with the lowest f, or zero if f increases along it.
void Norm::take_multiple_of(std::span<const double> estimate) {
    const double unit = *std::max_element(estimate.begin(), estimate.end());
    for (std::size_t i = 0; i < n_; ++i) p_[i] = std::max(estimate[i] / unit, 0.0);
    influence_.normal(p_, u_);
    const double energy = dot(p_, u_), work = -dot(p_, h_);
    const double factor = energy > 0 && work > 0 ? work / energy : 0;
    for (std::size_t i = 0; i < n_; ++i) {
        p_[i] *= factor;
        u_[i] *= factor;
    }
}

void Norm::scale_to_sum(Values& p, Values& u) const {
    double sum = 0;
    for (const double value : p) sum += value;
    const double factor = *problem_.pressure_sum / sum;
    for (double& value : p) value *= factor;
    for (double& value : u) value *= factor;
}

// The mean over the set minimises the defect.
void Norm::find_approach() {
    if (!problem_.pressure_sum) return;
    approach_ = mean_distance(state());
}

// Moves by `alpha` along the direction and evaluates the contact conditions there, in one pass; zero only evaluates.
Norm::Check Norm::advance(double alpha) {
    const NormViolations found = contactd::advance(state(), alpha, v_.data(), q_.data(), approach_, rounding);
    return {found.defect, found.reference, found.suction * self_ * self_, found.overlap};
}

void Norm::report(int iteration, double residual) {
    if (iteration == 0) first_residual_ = residual;
    if (iteration % 4 != 0) return;
    observer_->on_progress(
        {"normal", log_fraction(first_residual_, residual, settings_.tolerance), iteration, residual});
}

// If the sum is prescribed, the directions must not change it. With E the projection that subtracts a multiple of the
// weights, E A^-1 E' replaces A^-1.
void Norm::weigh_sum() {
    if (changed_elements_ <= outdated * dot(in_contact_, in_contact_)) return;
    influence_.precondition(Axis::z, in_contact_, weight_);
    for (double& weight : weight_) weight = std::max(weight, 0.0);
    changed_elements_ = 0;
}

void Norm::keep_sum_of_residual() {
    const double weights = dot(in_contact_, weight_);
    const double mean = weights > 0 ? dot(weight_, r_) / weights : 0;
    for (std::size_t i = 0; i < n_; ++i) r_[i] -= mean * in_contact_[i];
}

void Norm::keep_sum_of_direction() {
    const double weights = dot(in_contact_, weight_);
    const double mean = weights > 0 ? dot(in_contact_, z_) / weights : 0;
    for (std::size_t i = 0; i < n_; ++i) z_[i] -= mean * weight_[i];
}

// Chooses the direction of conjugate gradients on the set and returns the step along it. The step is zero if rounding
// errors or an indefinite table prevent a decrease. The approach follows.
double Norm::choose_step() {
    if (problem_.pressure_sum) {
        weigh_sum();
        keep_sum_of_residual();
    }
    influence_.precondition(Axis::z, r_, z_);
    if (problem_.pressure_sum) keep_sum_of_direction();
    const double* in = in_contact_.data();
    const double beta = steps_ > 0 ? -triple_product(n_, in, z_.data(), q_.data()) / curvature_ : 0;
    update_direction(n_, in, z_.data(), beta, v_.data());
    influence_.normal(v_, q_);
    const auto [curvature, slope, rise, count] = slope_along(state(), v_.data(), q_.data());
    curvature_ = curvature;
    steps_ = curvature > 0 && slope > 0 ? steps_ + 1 : 0;
    if (steps_ == 0) return 0;
    if (problem_.pressure_sum) approach_ += slope / curvature * (rise / count);
    return slope / curvature;
}

}  // namespace contactd

#include "friction_newton.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/support/traction_loops.hpp"

namespace contactd {
namespace {

constexpr std::size_t most_steps = 50;            // in the history
constexpr std::size_t history_values = 16 << 20;  // that its arrays may hold
constexpr double on_bound = 1e-9;                 // relative distance from the bound that counts as being on it
constexpr double far_moved = 1e-2;                // relative change by moves to the bounds that asks for the slip anew
constexpr double start_self = 8;                  // times the self-influence: turns slip into traction for the division
constexpr double far_off = 0.5;        // squared, relative: part of a step against the bounds at which it tells nothing
constexpr double much_turned = 0.05;   // relative change of the tractions that makes linearised steps stale
constexpr double negligible = 1e-12;   // traction over bound that counts as none
constexpr double accepted_push = 0.1;  // times the tolerance: slip along the traction that is no reason to adhere
constexpr double nearly_met = 0.3;     // violation of the law from which on forces have a say
constexpr int patience = 30;           // iterations without a better residual

std::size_t capacity(std::size_t m) {
    return std::clamp<std::size_t>(history_values / (6 * std::max<std::size_t>(m, 1)), 6, most_steps);
}

}  // namespace

FrictionNewton::FrictionNewton(Compliance& compliance, const Contact& contact, const std::optional<ForcesGiven>& forces)
    : compliance_(compliance),
      contact_(contact),
      g_(contact.bound),
      w_(contact.rigid),
      m_(contact.size()),
      history_(m_, capacity(m_)),
      law_(m_),
      before_(m_),
      inverse_g_(m_) {
    for (Field* field : {&p_, &s_, &slip_of_, &r_, &rest_, &step_, &z_}) *field = Field(m_);
    if (!forces) return;
    border_.emplace(*forces, m_);
    hold_rigid_slips(*forces);
}

// A rigid slip is a step like others: no traction, and one unit of slip everywhere.
void FrictionNewton::hold_rigid_slips(const ForcesGiven& forces) {
    for (const std::size_t k : {0u, 1u}) {
        if (!forces.given[k]) continue;
        const FieldView step = history_.new_step(), response = history_.new_response();
        for (const FieldView& field : {step, response}) {
            std::fill_n(field.x, m_, 0.0);
            std::fill_n(field.y, m_, 0.0);
        }
        std::fill_n(k == 0 ? response.x : response.y, m_, 1.0);
        history_.accept(k == 0 ? Pair::UnitX() : Pair::UnitY());
    }
    history_.hold();
}

double FrictionNewton::size(std::size_t e) const {
    return std::sqrt(p_.x[e] * p_.x[e] + p_.y[e] * p_.y[e]);
}

void FrictionNewton::take_bounds() {
    squared_bound_ = dot(g_, g_);
    largest_ = std::accumulate(g_.begin(), g_.end(), 0.0);
    for (std::size_t e = 0; e < m_; ++e) inverse_g_[e] = 1 / g_[e];
}

void FrictionNewton::start(const Field& estimate, const Pair& rigid) {
    take_bounds();
    contact_.gather(estimate.x, p_.x);
    contact_.gather(estimate.y, p_.y);
    rigid_ = rigid;
    take_rigid_slip();
    if (rms_w_ == 0) p_ = Field(m_);  // nothing drives them
    for (std::size_t e = 0; e < m_; ++e)
        if (size(e) > g_[e]) let_slip(e);
    history_.clear();
    is_stale_ = true;
    joined_ = false;
    begin();
}

void FrictionNewton::go_on(const std::optional<ForcesGiven>& forces) {
    take_bounds();
    if (border_) border_->ask_for(*forces);
    take_rigid_slip();
    for (std::size_t e = 0; e < m_; ++e)
        if (law_.slips[e] || size(e) > g_[e]) let_slip(e);
    evidence_ = {};
    first_ = 0;
    begin();
}

void FrictionNewton::begin() {
    before_ = law_.slips;
    std::fill(law_.slips.begin(), law_.slips.end(), false);
    slip_of_ = p_;
    changed_ = find_division();
    if (changed_ > 0 && compliance_.is_far_reaching() && moved() > far_moved) {
        update_slip();
        slip_of_ = p_;
    }
    best_ = std::numeric_limits<double>::infinity();
    without_progress_ = 0;
    is_stale_ = is_stale_ || before_ != law_.slips;
    if (border_) missing_ = border_->missing(p_);
    linearise();
}

// Of the tractions since the slip was found, relative.
double FrictionNewton::moved() const {
    double change = 0;
    for (std::size_t e = 0; e < m_; ++e)
        change += std::pow(p_.x[e] - slip_of_.x[e], 2) + std::pow(p_.y[e] - slip_of_.y[e], 2);
    return std::sqrt(change / inner(p_, p_));
}

// As in TangCg: finds slip also when the bound has grown a little since the estimate. The slip remains that of the
// estimate, which the first step makes good.
std::size_t FrictionNewton::find_division() {
    update_slip();
    if (!any(p_)) return 0;
    std::size_t moved = 0;
    for (std::size_t e = 0; e < m_; ++e) {
        const double stiffness = start_self * compliance_.self()[e];
        const double x = p_.x[e] - s_.x[e] / stiffness, y = p_.y[e] - s_.y[e] / stiffness;
        if (!(std::sqrt(x * x + y * y) > g_[e] * (1 - on_bound))) continue;
        if (x * p_.x[e] + y * p_.y[e] <= 0) {
            oppose_slip(e);
            ++moved;
            continue;
        }
        moved += size(e) < g_[e] * (1 - on_bound);
        let_slip(e);
    }
    return moved;
}

// An element that has just come into contact has no traction, and that of others may point along the slip.
void FrictionNewton::oppose_slip(std::size_t e) {
    p_.x[e] = -s_.x[e];
    p_.y[e] = -s_.y[e];
    let_slip(e);
}

void FrictionNewton::let_slip(std::size_t e) {
    const double length = size(e);
    law_.slips[e] = length > 0;
    if (!law_.slips[e]) return;
    p_.x[e] *= g_[e] / length;
    p_.y[e] *= g_[e] / length;
}

void FrictionNewton::update_slip() {
    if (inner(p_, p_) > 0) {
        compliance_.apply(p_, s_);
    } else {
        s_ = Field(m_);
    }
    for (std::size_t e = 0; e < m_; ++e) {
        s_.x[e] += w_.x[e] + rigid_.x();
        s_.y[e] += w_.y[e] + rigid_.y();
    }
}

bool FrictionNewton::iterate(int iterations, const SolverSettings& settings, Observer& observer) {
    double last_violation = 0, last_update = 0;
    for (int iteration = 0;; ++iteration) {
        observer.throw_if_cancelled();
        if (border_ && !joined_ && violation() <= nearly_met) join_forces();
        const double law = violation(), now = std::hypot(law, joined_ ? force_residual() : 0);
        // The next step estimates the error of the tractions, but costs a preconditioner product; the last step tells
        // as much, since errors fall as violations do.
        if (iteration == 0 && !has_step_) find_step();
        const double error = iteration == 0 ? relative_step() : last_update * now / last_violation;
        report(std::max(law, error), settings, observer);
        if (evidence_.converged || iteration == iterations || !made_progress()) return evidence_.converged;
        if (iteration > 0) find_step();
        last_violation = now;
        last_update = relative_step();
        take_step(settings.tolerance);
        linearise();
        turned_ += last_update;
        ++evidence_.iterations;
    }
}

void FrictionNewton::join_forces() {
    joined_ = true;
    is_stale_ = true;
    has_step_ = false;
    force_weight_ = rms_w_ * std::sqrt(static_cast<double>(m_)) / largest_;
}

double FrictionNewton::relative_step() const {
    const double change = inner(step_, step_), zero = negligible * negligible * squared_bound_;
    return change > 0 ? std::sqrt(change / std::max({inner(p_, p_), change, zero})) : 0;
}

double FrictionNewton::force_residual() const {
    return largest_ > 0 ? missing_.norm() / largest_ : 0;
}

void FrictionNewton::take_rigid_slip() {
    const double sum = squares_with(m_, w_, rigid_.x(), rigid_.y());
    rms_w_ = sum > 0 ? std::sqrt(sum / static_cast<double>(m_)) : 0;
}

void FrictionNewton::report(double law_residual, const SolverSettings& settings, Observer& observer) {
    const double force = force_residual();
    evidence_.residual = law_residual;
    evidence_.converged = division_stands(settings.tolerance) && law_residual <= settings.tolerance &&
                          (!border_ || (joined_ && force <= border_->tolerance()));
    const double residual = std::max(law_residual, force);
    if (first_ == 0) first_ = residual;
    if (evidence_.iterations % 4 == 0)
        observer.on_progress({border_ ? "force" : compliance_.stage(),
                              log_fraction(first_, residual, settings.tolerance), evidence_.iterations, residual});
}

bool FrictionNewton::division_stands(double tolerance) const {
    return static_cast<double>(changed_) <= tolerance * static_cast<double>(m_);
}

double FrictionNewton::violation() const {
    const double sum = inner(r_, r_) + pushes(m_, law_.normal, s_);
    return sum > 0 ? std::sqrt(sum / static_cast<double>(m_)) / rms_w_ : 0;
}

void FrictionNewton::linearise() {
    linearise_law(m_, law_.slips.data(), p_, s_, inverse_g_.data(), law_.normal, law_.turning.data(), r_);
    compliance_.linearise(law_);
    has_step_ = false;
}

void FrictionNewton::linearise_history() {
    const auto image = [this](const FieldView& step, const FieldView& response, const Pair& rigid,
                              const FieldView& result) -> Pair {
        jacobian_times(m_, law_.normal, law_.turning.data(), step, response, result);
        const auto [inside, against] = step_parts(m_, law_.normal, step);
        const bool rigid_stays = !joined_ && rigid != Pair::Zero();
        if (against <= far_off * (inside + against) && !rigid_stays)
            return joined_ ? Pair(force_weight_ * border_->sum_of_free(law_, step)) : Pair::Zero();
        std::fill_n(result.x, m_, 0.0);
        std::fill_n(result.y, m_, 0.0);
        return Pair::Zero();
    };
    if (is_stale_ || changed_ > 0 || turned_ > much_turned) {
        history_.map_all(image);
        is_stale_ = false;
        turned_ = 0;
    } else {
        history_.map_newest(image);
    }
}

void FrictionNewton::find_step() {
    linearise_history();
    rest_ = r_;
    Pair missing = joined_ ? Pair(force_weight_ * missing_) : Pair::Zero();
    rigid_step_ = history_.minimise(rest_, missing, step_);
    law_.project(step_);
    using Residual = Compliance::Residual;
    compliance_.precondition(rest_, z_, history_.size() == 0 ? Residual::first : Residual::later, evidence_.iterations);
    if (joined_) {
        border_->prepare(compliance_, law_, evidence_.iterations);
        rigid_step_ += border_->correct(z_, missing_ - border_->sum(step_));
    }
    for (std::size_t e = 0; e < m_; ++e) {
        step_.x[e] += z_.x[e];
        step_.y[e] += z_.y[e];
    }
    if (joined_) law_.project(step_);
    has_step_ = true;
}

void FrictionNewton::take_step(double tolerance) {
    const FieldView change = history_.new_step(), response = history_.new_response();
    std::copy(slip_of_.x.begin(), slip_of_.x.end(), change.x);
    std::copy(slip_of_.y.begin(), slip_of_.y.end(), change.y);
    std::copy(s_.x.begin(), s_.x.end(), response.x);
    std::copy(s_.y.begin(), s_.y.end(), response.y);
    std::copy(law_.slips.begin(), law_.slips.end(), before_.begin());
    move_tractions(m_, step_, g_.data(), on_bound, p_, law_.slips.data());
    if (joined_) {
        rigid_ += rigid_step_;
        take_rigid_slip();
    }
    update_slip();
    slip_of_ = p_;
    const double push = accepted_push * tolerance * rms_w_;
    take_differences(m_, p_, s_, push, g_.data(), law_.slips.data(), change, response);
    history_.accept(rigid_step_);
    changed_ = 0;
    for (std::size_t e = 0; e < m_; ++e) changed_ += before_[e] != law_.slips[e];
    if (!border_) return;
    border_->division_changed(before_, law_.slips);
    missing_ = border_->missing(p_);
}

bool FrictionNewton::made_progress() {
    const double residual = std::max(evidence_.residual, force_residual());
    if (residual < best_) {
        best_ = residual;
        without_progress_ = 0;
    } else if (++without_progress_ > patience) {
        return false;
    }
    return true;
}

}  // namespace contactd

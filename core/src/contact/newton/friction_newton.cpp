#include "friction_newton.hpp"

#include <algorithm>
#include <cmath>

#include "contact/support/traction_loops.hpp"

namespace contactd {
namespace {

constexpr std::size_t most_steps = 50;            // in the history
constexpr std::size_t history_values = 16 << 20;  // limit of its arrays
// A step is not reliable if its squared relative part against the bounds exceeds this.
constexpr double far_off = 0.5;
constexpr double much_changed = 0.05;  // relative change of the tractions that makes linearised steps stale
constexpr double negligible = 1e-12;   // traction over bound that counts as zero
constexpr double accepted_push = 0.1;  // times the tolerance: slip along the traction at which elements still slip
// The computed slip need not include moves to the bounds up to this number times the tolerance.
constexpr double accepted_move = 0.3;
constexpr double straight = 1e-3;   // tolerance at which steps are so short that bounds do not bend them
constexpr double promising = 4;     // times the tolerance: residual that combined steps may reduce to it
constexpr double nearly_met = 0.3;  // violation of the law below which forces are included
constexpr int most_failures = 30;   // iterations without a better residual

std::size_t capacity(std::size_t m) {
    return std::clamp<std::size_t>(history_values / (6 * std::max<std::size_t>(m, 1)), 6, most_steps);
}

}  // namespace

FrictionNewton::FrictionNewton(Compliance& compliance, const Contact& contact, const std::optional<ForcesGiven>& forces,
                               const FlowLaw* flow)
    : compliance_(compliance),
      contact_(contact),
      g_(contact.bound),
      w_(contact.rigid),
      m_(contact.size()),
      history_(m_, capacity(m_)),
      law_(m_),
      before_(m_),
      inverse_g_(m_) {
    for (Field* field : {&p_, &s_, &slip_of_, &r_, &rest_, &step_, &z_, &last_s_}) *field = Field(m_);
    if (flow != nullptr) {
        flow_.emplace(*flow, contact, compliance.self());
        law_.flow.emplace(m_);
    }
    if (!forces) return;
    border_.emplace(*forces, m_);
    hold_rigid_slips(*forces);
}

// A rigid slip is a step like others, with no traction and a unit of slip everywhere.
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

void FrictionNewton::update_slip() {
    const auto is_traction = [](double p) { return p != 0; };
    if (std::any_of(p_.x.begin(), p_.x.end(), is_traction) || std::any_of(p_.y.begin(), p_.y.end(), is_traction)) {
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
    double last_residual = 0, last_update = 0;
    for (int iteration = 0;; ++iteration) {
        observer.throw_if_cancelled();
        if (border_ && !joined_ && violation_ <= nearly_met) join_forces();
        // The next step estimates the error of the tractions, but costs a preconditioner product. The last step is an
        // equivalent estimate, since errors decrease like violations.
        if (iteration == 0 && !has_step_) find_step();
        const double error_per_residual = iteration == 0 ? 0 : last_update / last_residual;
        report(std::max(violation_, iteration == 0 ? relative_step() : error_per_residual * residual()), settings,
               observer);
        if (evidence_.converged || iteration == iterations || !made_progress()) return evidence_.converged;
        if (iteration > 0) {
            combine_steps();
            if (combination_is_enough(settings.tolerance)) {
                take_combination(settings.tolerance);
                if (const double off = moved(); off <= accepted_move * settings.tolerance)
                    report(std::hypot(std::max(violation_, error_per_residual * residual()), off), settings, observer);
                if (evidence_.converged) return true;
                combine_steps();
            }
            complete_step();
        }
        last_residual = residual();
        last_update = relative_step();
        take_step(settings.tolerance);
        relative_change_ += last_update;
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

void FrictionNewton::linearise() {
    linearise_law(m_, law_.slips.data(), p_, s_, inverse_g_.data(), law_.normal, law_.tangent_stiffness.data(), r_);
    const double back = flow_ ? flow_->linearise(p_, s_, law_, r_) : 0;
    const double sum = inner(r_, r_) + pushes(m_, law_.normal, s_) + back;
    violation_ = sum > 0 ? std::sqrt(sum / static_cast<double>(m_)) / rms_w_ : 0;
    has_step_ = false;
}

double FrictionNewton::residual() const {
    return std::hypot(violation_, joined_ ? force_residual() : 0);
}

void FrictionNewton::linearise_history() {
    const auto image = [this](const FieldView& step, const FieldView& response, const Pair& rigid,
                              const FieldView& result) -> Pair {
        jacobian_times(m_, law_.normal, law_.tangent_stiffness.data(), step, response, result);
        if (flow_) flow_->correct_image(law_, step, response, result);
        const auto [inside, against] = step_parts(m_, law_.normal, step);
        const bool rigid_stays = !joined_ && rigid != Pair::Zero();
        if (against <= far_off * (inside + against) && !rigid_stays)
            return joined_ ? Pair(force_weight_ * border_->sum_of_free(law_, step)) : Pair::Zero();
        std::fill_n(result.x, m_, 0.0);
        std::fill_n(result.y, m_, 0.0);
        return Pair::Zero();
    };
    if (is_stale_ || changed_ > 0 || relative_change_ > much_changed) {
        history_.map_all(image);
        is_stale_ = false;
        relative_change_ = 0;
    } else {
        history_.map_newest(image);
    }
}

void FrictionNewton::find_step() {
    combine_steps();
    complete_step();
}

void FrictionNewton::combine_steps() {
    linearise_history();
    rest_ = r_;
    rest_missing_ = joined_ ? Pair(force_weight_ * missing_) : Pair::Zero();
    rigid_step_ = history_.minimise(rest_, rest_missing_, step_);
}

void FrictionNewton::complete_step() {
    law_.project(step_);
    compliance_.linearise(law_);
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
    move();
    std::swap(s_, last_s_);
    update_slip();
    const FieldView change = history_.new_step(), response = history_.new_response();
    const double push = accepted_push * tolerance * rms_w_;
    take_differences(m_, p_, s_, slip_of_, last_s_, push, g_.data(), law_.slips.data(), change, response);
    history_.accept(rigid_step_);
    slip_of_ = p_;
    if (flow_) flow_->divide_by_slip(p_, s_, push, law_.slips);
    count_changes();
    linearise();
}

bool FrictionNewton::combination_is_enough(double tolerance) const {
    if (tolerance > straight || !division_stands(tolerance)) return false;
    const double residual = std::max(evidence_.residual, force_residual());
    if (residual > promising * tolerance) return false;
    const double before = inner(r_, r_) + (joined_ ? (force_weight_ * missing_).squaredNorm() : 0);
    const double after = inner(rest_, rest_) + rest_missing_.squaredNorm();
    return residual * std::sqrt(after) <= tolerance * std::sqrt(before);
}

void FrictionNewton::take_combination(double tolerance) {
    history_.add_responses(s_);
    add(slip_of_, step_);
    law_.project(step_);
    move();
    const double push = accepted_push * tolerance * rms_w_;
    end_slip(m_, p_, s_, push, g_.data(), law_.slips.data());
    if (flow_) flow_->divide_by_slip(p_, s_, push, law_.slips);
    count_changes();
    linearise();
}

void FrictionNewton::move() {
    std::copy(law_.slips.begin(), law_.slips.end(), before_.begin());
    if (flow_) {
        flowed_ = flow_->flows();
        add(p_, step_);
        flow_->divide_by_size(p_, law_.slips);
    } else {
        move_tractions(m_, step_, g_.data(), on_bound, p_, law_.slips.data());
    }
    if (!joined_) return;
    rigid_ += rigid_step_;
    take_rigid_slip();
}

void FrictionNewton::count_changes() {
    changed_ = 0;
    for (std::size_t e = 0; e < m_; ++e)
        changed_ += before_[e] != law_.slips[e] || (flow_ && flowed_[e] != flow_->flows()[e]);
    if (!border_) return;
    border_->division_changed(before_, law_.slips);
    missing_ = border_->missing(p_);
}

bool FrictionNewton::made_progress() {
    const double residual = std::max(evidence_.residual, force_residual());
    if (residual < best_) {
        best_ = residual;
        without_progress_ = 0;
    } else if (++without_progress_ > most_failures) {
        return false;
    }
    return true;
}

}  // namespace contactd

#include "friction_newton.hpp"

#include <algorithm>
#include <cmath>

#include "contact/support/traction_loops.hpp"

namespace contactd {
namespace {

constexpr std::size_t most_steps = 50;            // in the history
constexpr std::size_t history_values = 16 << 20;  // that its arrays may hold
constexpr double on_bound = 1e-9;                 // relative distance from the bound that counts as being on it
constexpr double start_self = 8;                  // times the self-influence: turns slip into traction for the division
constexpr double far_off = 0.5;        // squared, relative: part of a step against the bounds at which it tells nothing
constexpr double much_turned = 0.05;   // relative change of the tractions that makes linearised steps stale
constexpr double negligible = 1e-12;   // traction over bound that counts as none
constexpr double accepted_push = 0.1;  // times the tolerance: slip along the traction that is no reason to adhere
constexpr int patience = 30;           // iterations without a better residual

std::size_t capacity(std::size_t m) {
    return std::clamp<std::size_t>(history_values / (6 * std::max<std::size_t>(m, 1)), 6, most_steps);
}

double root_mean_square(const Field& a) {
    return a.x.empty() ? 0 : std::sqrt(inner(a, a) / static_cast<double>(a.x.size()));
}

}  // namespace

FrictionNewton::FrictionNewton(Compliance& compliance, const Contact& contact, const SolverSettings& settings,
                               Observer& observer)
    : compliance_(compliance),
      contact_(contact),
      g_(contact.bound),
      w_(contact.rigid),
      settings_(settings),
      observer_(observer),
      m_(contact.size()),
      rms_w_(root_mean_square(w_)),
      history_(m_, capacity(m_)),
      law_(m_),
      before_(m_),
      squared_bound_(dot(g_, g_)) {
    for (Field* field : {&p_, &s_, &r_, &rest_, &step_, &z_}) *field = Field(m_);
    for (const double g : g_) inverse_g_.push_back(1 / g);
}

double FrictionNewton::size(std::size_t e) const {
    return std::sqrt(p_.x[e] * p_.x[e] + p_.y[e] * p_.y[e]);
}

void FrictionNewton::start(const Field& estimate) {
    contact_.gather(estimate.x, p_.x);
    contact_.gather(estimate.y, p_.y);
    if (rms_w_ == 0) p_ = Field(m_);  // nothing drives them
    for (std::size_t e = 0; e < m_; ++e)
        if (size(e) > g_[e]) let_slip(e);
    std::fill(law_.slips.begin(), law_.slips.end(), false);
    s_ = w_;
    if (inner(p_, p_) > 0) find_division();
    history_.clear();
    best_ = std::numeric_limits<double>::infinity();
    without_progress_ = 0;
    division_changed_ = false;
    linearise();
}

// As in TangCg: finds slip also when the bound has grown a little since the estimate.
void FrictionNewton::find_division() {
    update_slip();
    bool moved = false;
    for (std::size_t e = 0; e < m_; ++e) {
        const double stiffness = start_self * compliance_.self()[e];
        const double x = p_.x[e] - s_.x[e] / stiffness, y = p_.y[e] - s_.y[e] / stiffness;
        if (!(std::sqrt(x * x + y * y) > g_[e] * (1 - on_bound))) continue;
        moved = moved || size(e) < g_[e] * (1 - on_bound);
        let_slip(e);
    }
    if (moved) update_slip();
}

void FrictionNewton::let_slip(std::size_t e) {
    const double length = size(e);
    law_.slips[e] = length > 0;
    if (!law_.slips[e]) return;
    p_.x[e] *= g_[e] / length;
    p_.y[e] *= g_[e] / length;
}

void FrictionNewton::update_slip() {
    compliance_.apply(p_, s_);
    for (std::size_t e = 0; e < m_; ++e) {
        s_.x[e] += w_.x[e];
        s_.y[e] += w_.y[e];
    }
}

bool FrictionNewton::iterate(int iterations) {
    double last_violation = 0, last_update = 0;
    for (int iteration = 0;; ++iteration) {
        observer_.throw_if_cancelled();
        const double now = violation();
        // The next step estimates the error of the tractions, but costs a preconditioner product; the last step tells
        // as much, since errors fall as violations do.
        if (iteration == 0) find_step();
        const double error = iteration == 0 ? relative_step() : last_update * now / last_violation;
        report(std::max(now, error));
        if (evidence_.converged || iteration == iterations || !made_progress()) return evidence_.converged;
        if (iteration > 0) find_step();
        last_violation = now;
        last_update = relative_step();
        take_step();
        linearise();
        turned_ += last_update;
        ++evidence_.iterations;
    }
}

double FrictionNewton::relative_step() const {
    const double change = inner(step_, step_), zero = negligible * negligible * squared_bound_;
    return change > 0 ? std::sqrt(change / std::max({inner(p_, p_), change, zero})) : 0;
}

void FrictionNewton::report(double residual) {
    evidence_.residual = residual;
    evidence_.converged = !division_changed_ && residual <= settings_.tolerance;
    if (first_ == 0) first_ = residual;
    if (evidence_.iterations % 4 == 0)
        observer_.on_progress(
            {compliance_.stage(), log_fraction(first_, residual, settings_.tolerance), evidence_.iterations, residual});
}

double FrictionNewton::violation() const {
    const double sum = inner(r_, r_) + pushes(m_, law_.normal, s_);
    return sum > 0 ? std::sqrt(sum / static_cast<double>(m_)) / rms_w_ : 0;
}

void FrictionNewton::linearise() {
    linearise_law(m_, law_.slips.data(), p_, s_, inverse_g_.data(), law_.normal, law_.turning.data(), r_);
    compliance_.linearise(law_);
}

void FrictionNewton::linearise_history() {
    const auto image = [this](const FieldView& step, const FieldView& response, const FieldView& result) {
        jacobian_times(m_, law_.normal, law_.turning.data(), step, response, result);
        const auto [inside, against] = step_parts(m_, law_.normal, step);
        if (against <= far_off * (inside + against)) return;
        std::fill_n(result.x, m_, 0.0);
        std::fill_n(result.y, m_, 0.0);
    };
    if (division_changed_ || turned_ > much_turned) {
        history_.map_all(image);
        turned_ = 0;
    } else {
        history_.map_newest(image);
    }
}

void FrictionNewton::find_step() {
    linearise_history();
    rest_ = r_;
    history_.minimise(rest_, step_);
    law_.project(step_);
    using Residual = Compliance::Residual;
    compliance_.precondition(rest_, z_, history_.size() == 0 ? Residual::first : Residual::later,
                             evidence_.iterations);
    for (std::size_t e = 0; e < m_; ++e) {
        step_.x[e] += z_.x[e];
        step_.y[e] += z_.y[e];
    }
}

void FrictionNewton::take_step() {
    const FieldView change = history_.new_step(), response = history_.new_response();
    std::copy(p_.x.begin(), p_.x.end(), change.x);
    std::copy(p_.y.begin(), p_.y.end(), change.y);
    std::copy(s_.x.begin(), s_.x.end(), response.x);
    std::copy(s_.y.begin(), s_.y.end(), response.y);
    std::copy(law_.slips.begin(), law_.slips.end(), before_.begin());
    move_tractions(m_, step_, g_.data(), on_bound, p_, law_.slips.data());
    update_slip();
    const double push = accepted_push * settings_.tolerance * rms_w_;
    take_differences(m_, p_, s_, push, g_.data(), law_.slips.data(), change, response);
    history_.accept();
    division_changed_ = before_ != law_.slips;
}

bool FrictionNewton::made_progress() {
    if (evidence_.residual < best_) {
        best_ = evidence_.residual;
        without_progress_ = 0;
    } else if (++without_progress_ > patience) {
        return false;
    }
    return true;
}

}  // namespace contactd

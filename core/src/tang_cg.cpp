#include "tang_cg.hpp"

#include <algorithm>
#include <cmath>

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr int patience = 3;         // checks that do not lower f
constexpr double on_bound = 1e-9;   // relative distance from the bound that counts as being on it
constexpr double rounding = 1e-12;  // of the slip distance
constexpr double largest_slack = 1e-3;
constexpr double negligible = 1e-12;  // traction over bound that counts as none

// Where turning costs more than this many times the influence of an element on itself, it rules the Jacobian.
constexpr double stiff = 5;
constexpr double stiff_self = 2;  // what neighbours add there, in the same unit
constexpr double soft_self = 4;   // and elsewhere
constexpr double start_self = 8;  // stiffness that turns slip into traction for the first division

}  // namespace

TangCg::TangCg(const InfluenceOperator& influence, const Contact& contact, const SolverSettings& settings,
               Observer& observer)
    : influence_(influence),
      contact_(contact),
      g_(contact.bound),
      w_(contact.rigid),
      settings_(settings),
      observer_(observer),
      m_(contact.size()),
      self_(0.5 * (influence.diagonal(Axis::x) + influence.diagonal(Axis::y))) {
    for (Field* field : {&p_, &s_, &r_, &z_, &v_, &q_, &jv_, &tangent_}) *field = Field(m_);
    for (Values* values : {&turning_, &scale_, &diagonal_}) values->resize(m_);
    slips_.resize(m_);
    full_in_ = Field(influence.size());
    full_out_ = Field(influence.size());
}

double TangCg::start(const Field& estimate) {
    set_tractions(estimate);
    linearise();
    precondition();
    return relative_to_traction(inner(z_, z_));
}

TangentialSolution TangCg::solve() {
    TangentialSolution result;
    bool fresh = true, stands = true;  // slip distance and division
    double update = 0;
    for (int iteration = 0;; ++iteration) {
        observer_.throw_if_cancelled();
        // The preconditioned residual estimates the error: a small update alone may only mean slow progress.
        const double error = relative_to_traction(inner(z_, z_));
        if (iteration == 0) update = error;
        const double figure = std::max(error, update);
        report(iteration, figure);
        result.evidence = {iteration, update, fresh && stands && figure <= settings_.tolerance, 0};
        if (result.evidence.converged || iteration == settings_.max_iterations) break;
        update = step();
        fresh = steps_ % steps_per_check_ == 0 || update <= settings_.tolerance;
        if (fresh) stands = check_division();
        linearise();
        precondition();
    }
    if (!fresh) check_division();
    finish(result);
    return result;
}

void TangCg::set_tractions(const Field& estimate) {
    contact_.gather(estimate.x, p_.x);
    contact_.gather(estimate.y, p_.y);
    for (std::size_t e = 0; e < m_; ++e) bring_to_bound(e);
    slips_.assign(m_, false);
    if (inner(p_, p_) == 0) {
        s_ = w_;
        keep_best();
        return;
    }
    update_slip_distance();
    // Slip is where the traction minus the slip distance, turned into a traction, lies beyond the bound: finds
    // slip also when the bound has grown a little since the estimate.
    for (std::size_t e = 0; e < m_; ++e) {
        const double x = p_.x[e] - s_.x[e] / (start_self * self_), y = p_.y[e] - s_.y[e] / (start_self * self_);
        if (std::sqrt(x * x + y * y) > g_[e] * (1 - on_bound)) let_slip(e);
    }
    update_slip_distance();
    keep_best();
    hold_pushed_back();
}

void TangCg::let_slip(std::size_t e) {
    double length = size(e);
    if (!(length > 0)) {
        p_.x[e] = -w_.x[e];
        p_.y[e] = -w_.y[e];
        length = size(e);
    }
    slips_[e] = length > 0;
    if (!slips_[e]) return;
    p_.x[e] *= g_[e] / length;
    p_.y[e] *= g_[e] / length;
}

void TangCg::apply(const Field& in, Field& out) {
    contact_.scatter(in.x, full_in_.x);
    contact_.scatter(in.y, full_in_.y);
    influence_.tangential(full_in_.x, full_in_.y, full_out_.x, full_out_.y);
    contact_.gather(full_out_.x, out.x);
    contact_.gather(full_out_.y, out.y);
}

void TangCg::update_slip_distance() {
    apply(p_, s_);
    for (std::size_t e = 0; e < m_; ++e) {
        s_.x[e] += w_.x[e];
        s_.y[e] += w_.y[e];
    }
}

double TangCg::relative_to_traction(double change_squared) const {
    const double zero = negligible * negligible * dot(g_, g_);
    return change_squared > 0 ? std::sqrt(change_squared / std::max(inner(p_, p_), zero)) : 0;
}

void TangCg::project(Field& a, std::size_t e) const {
    const double along = a.x[e] * tangent_.x[e] + a.y[e] * tangent_.y[e];
    a.x[e] = along * tangent_.x[e];
    a.y[e] = along * tangent_.y[e];
}

void TangCg::linearise() {
    for (std::size_t e = 0; e < m_; ++e) {
        r_.x[e] = -s_.x[e];
        r_.y[e] = -s_.y[e];
        scale_[e] = 1;
        diagonal_[e] = 0;
        if (!slips_[e]) continue;
        tangent_.x[e] = -p_.y[e] / g_[e];
        tangent_.y[e] = p_.x[e] / g_[e];
        project(r_, e);
        turning_[e] = std::max(-work(e) / (g_[e] * g_[e]), 0.0);
        const bool is_stiff = turning_[e] > stiff * self_;
        scale_[e] = is_stiff ? 0 : std::sqrt(soft_self * self_ / (soft_self * self_ + turning_[e]));
        diagonal_[e] = is_stiff ? 1 / (turning_[e] + stiff_self * self_) : 0;
    }
}

void TangCg::precondition() {
    const auto one_direction = [&](Axis axis, const Values& r, Values& full_in, Values& full_out, Values& z) {
        for (std::size_t e = 0; e < m_; ++e) full_in[contact_.elements[e]] = scale_[e] * r[e];
        influence_.precondition(axis, full_in, full_out);
        for (std::size_t e = 0; e < m_; ++e) z[e] = scale_[e] * full_out[contact_.elements[e]] + diagonal_[e] * r[e];
    };
    one_direction(Axis::x, r_.x, full_in_.x, full_out_.x, z_.x);
    one_direction(Axis::y, r_.y, full_in_.y, full_out_.y, z_.y);
    for (std::size_t e = 0; e < m_; ++e)
        if (slips_[e]) project(z_, e);
}

double TangCg::step() {
    choose_direction();
    apply(v_, q_);
    jv_ = q_;
    for (std::size_t e = 0; e < m_; ++e) {
        if (!slips_[e]) continue;
        project(jv_, e);
        jv_.x[e] += turning_[e] * v_.x[e];
        jv_.y[e] += turning_[e] * v_.y[e];
    }
    curvature_ = inner(v_, jv_);
    const double slope = inner(r_, v_);
    if (!(slope > 0 && curvature_ > 0)) {  // nothing left to do, or a table that is not positive
        steps_ = 0;
        return 0;
    }
    ++steps_;
    return move(slope / curvature_);
}

void TangCg::choose_direction() {
    const double beta = steps_ > 0 ? -inner(z_, jv_) / curvature_ : 0;
    for (std::size_t e = 0; e < m_; ++e) {
        v_.x[e] = z_.x[e] + beta * v_.x[e];
        v_.y[e] = z_.y[e] + beta * v_.y[e];
        if (slips_[e]) project(v_, e);
    }
    if (!(inner(r_, v_) > 0)) v_ = z_;
}

double TangCg::move(double alpha) {
    double change = 0;
    for (std::size_t e = 0; e < m_; ++e) {
        double x = p_.x[e] + alpha * v_.x[e], y = p_.y[e] + alpha * v_.y[e];
        if (slips_[e]) {
            const double factor = g_[e] / std::sqrt(x * x + y * y);
            x *= factor;
            y *= factor;
        }
        change += (x - p_.x[e]) * (x - p_.x[e]) + (y - p_.y[e]) * (y - p_.y[e]);
        p_.x[e] = x;
        p_.y[e] = y;
        s_.x[e] += alpha * q_.x[e];
        s_.y[e] += alpha * q_.y[e];
    }
    return relative_to_traction(change);
}

bool TangCg::check_division() {
    bool stands = true;
    for (std::size_t e = 0; e < m_; ++e) {
        if (slips_[e] || size(e) <= g_[e] * (1 + on_bound)) continue;
        let_slip(e);
        stands = false;
    }
    update_slip_distance();
    if (!watch()) stands = false;
    if (hold_pushed_back()) stands = false;
    if (!stands) steps_ = 0;
    return stands;
}

bool TangCg::hold_pushed_back() {
    bool any = false;
    for (std::size_t e = 0; e < m_; ++e) {
        const double noise = rounding * g_[e] * (std::abs(w_.x[e]) + std::abs(w_.y[e]));
        if (!slips_[e] || work(e) <= noise) continue;
        slips_[e] = false;
        any = true;
    }
    return any;
}

bool TangCg::watch() {
    const double value = f();
    if (value <= best_f_ + slack_ * std::abs(best_f_)) {
        failures_ = 0;
    } else if (++failures_ > patience) {
        failures_ = 0;
        slack_ = std::min(10 * slack_, largest_slack);
        steps_per_check_ = std::max(steps_per_check_ / 2, 1);
        projected_gradient_step();
        keep_best();
        return false;
    }
    if (value < best_f_) keep_best();
    return true;
}

void TangCg::keep_best() {
    best_p_ = p_;
    best_s_ = s_;
    best_f_ = f();
}

void TangCg::projected_gradient_step() {
    v_ = Field(m_);
    std::fill(v_.x.begin(), v_.x.end(), 1.0);
    apply(v_, q_);
    double norm = *std::max_element(q_.x.begin(), q_.x.end());
    std::swap(v_.x, v_.y);
    apply(v_, q_);
    norm = 1.5 * std::max(norm, *std::max_element(q_.y.begin(), q_.y.end()));
    for (std::size_t e = 0; e < m_; ++e) {
        p_.x[e] = best_p_.x[e] - best_s_.x[e] / norm;
        p_.y[e] = best_p_.y[e] - best_s_.y[e] / norm;
        slips_[e] = false;
        if (size(e) > g_[e]) let_slip(e);
    }
    update_slip_distance();
}

void TangCg::report(int iteration, double figure) {
    if (iteration == 0) first_figure_ = figure;
    if (iteration % 4 != 0) return;
    observer_.on_progress({"tangential", log_fraction(first_figure_, figure, settings_.tolerance), iteration, figure});
}

void TangCg::bring_to_bound(std::size_t e) {
    const double length = std::hypot(p_.x[e], p_.y[e]);
    if (length <= g_[e]) return;
    p_.x[e] *= g_[e] / length;
    p_.y[e] *= g_[e] / length;
}

void TangCg::finish(TangentialSolution& result) {
    for (std::size_t e = 0; e < m_; ++e) bring_to_bound(e);
    result.traction_x.resize(influence_.size());
    result.traction_y.resize(influence_.size());
    contact_.scatter(p_.x, result.traction_x);
    contact_.scatter(p_.y, result.traction_y);
    result.element_division.assign(influence_.size(), ElementState::exterior);
    for (std::size_t e = 0; e < m_; ++e)
        result.element_division[contact_.elements[e]] = slips_[e] ? ElementState::slip : ElementState::adhesion;
}

}  // namespace contactd

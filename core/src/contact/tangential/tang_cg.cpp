#include "tang_cg.hpp"

#include <algorithm>
#include <cmath>

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr int most_failures = 3;     // refreshes that do not reduce f
constexpr int steps_to_settle = 2;   // steps before slip elements may adhere
constexpr double on_bound = 1e-9;    // relative distance from the bound within which elements count as on it
constexpr double near_bound = 1e-3;  // the same for an estimate
constexpr double rounding = 1e-12;   // of the slip distance
constexpr double largest_slack = 1e-3;
constexpr double negligible = 1e-12;  // traction over bound that counts as zero
constexpr double stale = 0.2;         // drift over update above which the slip distance is recomputed
constexpr double stale_at_end = 0.1;  // drift over tolerance
constexpr double stale_at_start = 1e-2;

// The preconditioner's mean was tuned on the spectra of Cattaneo shifts and spin, with condition numbers of 3 to 4 for
// any part of slip. These are the tangent stiffness at which A and D have equal weight, and the effect of neighbours on
// the diagonal where D dominates, in units of the influence of an element on itself.
constexpr double few = 3e-3;  // part of the contact whose change of division leaves directions sufficiently conjugate
constexpr double soft = 3;
constexpr double start_self = 8;  // converts slip to traction for the first division

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
      self_(tangential_diagonal(influence, contact)) {
    for (Field* field : {&p_, &s_, &r_, &z_, &v_, &q_, &jv_, &normal_}) *field = Field(m_);
    for (Values* values : {&tangent_stiffness_, &scale_, &diagonal_, &inverse_g_, &to_self_}) values->resize(m_);
    slips_.resize(m_);
    squared_bound_ = dot(g_, g_);
    full_in_ = Field(influence.size());
    full_out_ = Field(influence.size());
    for (std::size_t e = 0; e < m_; ++e) {
        inverse_g_[e] = 1 / g_[e];
        to_self_[e] = 1 / self_[e];
        noise_ = std::max({noise_, rounding * std::abs(w_.x[e]), rounding * std::abs(w_.y[e])});
    }
}

void TangCg::start(const Field& estimate) {
    set_tractions(estimate);
    stands_ = true;
    released_ = !any_pushed_back();
    linearise();
}

TangentialSolution TangCg::solve() {
    TangentialSolution result;
    double update = error_;
    for (int iteration = 0;; ++iteration) {
        observer_.throw_if_cancelled();
        // A small update alone may only mean slow progress.
        const double figure = std::max(error_, update);
        report(iteration, figure);
        const bool is_final = stands_ && released_ && drift_ <= stale_at_end * settings_.tolerance;
        result.evidence = {iteration, figure, is_final && figure <= settings_.tolerance, 0};
        if (result.evidence.converged || iteration == settings_.max_iterations) break;
        update = step();
        update_division(update);
        linearise();
    }
    finish(result);
    return result;
}

void TangCg::set_tractions(const Field& estimate) {
    contact_.gather(estimate.x, p_.x);
    contact_.gather(estimate.y, p_.y);
    slips_.assign(m_, false);
    for (std::size_t e = 0; e < m_; ++e) {
        bring_to_bound(e);
        if (size(e) >= g_[e] * (1 - near_bound)) let_slip(e);
    }
    drift_ = 0;
    if (inner(p_, p_) == 0) {
        s_ = w_;
        keep_best();
        return;
    }
    update_slip_distance();
    // Elements also slip if the traction minus the slip distance, converted to a traction, exceeds the bound. This
    // detects slip if the bound has increased slightly since the estimate.
    double change = 0;
    for (std::size_t e = 0; e < m_; ++e) {
        const double x = p_.x[e] - s_.x[e] / (start_self * self_[e]), y = p_.y[e] - s_.y[e] / (start_self * self_[e]);
        if (!slips_[e] && std::sqrt(x * x + y * y) > g_[e] * (1 - on_bound)) change += let_slip(e);
    }
    drift_ = relative_to_traction(change);
    if (drift_ > stale_at_start) update_slip_distance();
    best_f_ = std::numeric_limits<double>::infinity();
    if (drift_ == 0) keep_best();
}

double TangCg::let_slip(std::size_t e) {
    double length = size(e);
    const bool is_zero = !(length > 0);
    if (is_zero) {
        p_.x[e] = -w_.x[e];
        p_.y[e] = -w_.y[e];
        length = size(e);
    }
    slips_[e] = length > 0;
    if (!slips_[e]) return 0;
    p_.x[e] *= g_[e] / length;
    p_.y[e] *= g_[e] / length;
    const double change = is_zero ? g_[e] : length - g_[e];
    return change * change;
}

void TangCg::apply(const Field& in, Field& out) {
    contact_.product(influence_, in, full_in_, full_out_, out);
}

void TangCg::update_slip_distance() {
    apply(p_, s_);
    for (std::size_t e = 0; e < m_; ++e) {
        s_.x[e] += w_.x[e];
        s_.y[e] += w_.y[e];
    }
    drift_ = 0;
    steps_since_refresh_ = 0;
}

double TangCg::relative_to_traction(double change_squared) const {
    const double zero = negligible * negligible * squared_bound_;
    return change_squared > 0 ? std::sqrt(change_squared / std::max(inner(p_, p_), zero)) : 0;
}

void TangCg::linearise() {
    linearise_law(m_, slips_.data(), p_, s_, inverse_g_.data(), normal_, tangent_stiffness_.data(), r_);
    for (std::size_t e = 0; e < m_; ++e) {
        const double part = 1 / (soft + tangent_stiffness_[e] * to_self_[e]);
        scale_[e] = soft * part;
        diagonal_[e] = (1 - scale_[e] * scale_[e]) * part * to_self_[e];
    }
    for (const Contact::Run& run : contact_.runs) {
        multiply(run.size, &scale_[run.first], &r_.x[run.first], &full_in_.x[run.grid_first]);
        multiply(run.size, &scale_[run.first], &r_.y[run.first], &full_in_.y[run.grid_first]);
    }
    influence_.precondition_tangential(full_in_.x, full_in_.y, full_out_.x, full_out_.y);
    contact_.gather(full_out_.x, z_.x);
    contact_.gather(full_out_.y, z_.y);
    error_ = relative_to_traction(combine(m_, scale_.data(), diagonal_.data(), r_, normal_, z_));
}

double TangCg::step() {
    const double slope = choose_direction();
    apply(v_, q_);
    jacobian_times(m_, normal_, tangent_stiffness_.data(), v_, q_, jv_);
    curvature_ = inner(v_, jv_);
    if (!(slope > 0 && curvature_ > 0)) {  // Nothing is left to do, or the table is not positive.
        steps_ = 0;
        return 0;
    }
    ++steps_;
    return move(slope / curvature_);
}

double TangCg::choose_direction() {
    double beta = steps_ > 0 ? -inner(z_, jv_) / curvature_ : 0;
    double slope = next_direction(m_, z_, beta, normal_, r_, v_);
    if (!(slope > 0) && beta != 0) slope = next_direction(m_, z_, 0, normal_, r_, v_);
    return slope;
}

double TangCg::move(double alpha) {
    const MoveParts parts = move_along(m_, alpha, v_, q_, slips_.data(), g_.data(), p_, s_);
    drift_ += relative_to_traction(parts.scaling);
    return relative_to_traction(parts.change);
}

void TangCg::update_division(double update) {
    double change = 0;
    std::size_t changed = 0;
    stands_ = true;
    for (std::size_t e = 0; e < m_; ++e) {
        if (slips_[e] || p_.x[e] * p_.x[e] + p_.y[e] * p_.y[e] <= g_[e] * g_[e] * (1 + 2 * on_bound)) continue;
        change += let_slip(e);
        stands_ = false;
        ++changed;
    }
    drift_ += relative_to_traction(change);
    if (!stands_) steps_since_change_ = 0;
    refresh_if_stale(update);
    released_ = ++steps_since_change_ >= steps_to_settle || update <= settings_.tolerance;
    if (released_) {
        steps_since_change_ = 0;
        const std::size_t released = hold_pushed_back();
        if (released > 0) stands_ = false;
        changed += released;
    }
    if (static_cast<double>(changed) > few * static_cast<double>(m_)) steps_ = 0;
}

void TangCg::refresh_if_stale(double update) {
    const double allowed = std::max(stale * update, stale_at_end * settings_.tolerance);
    if (++steps_since_refresh_ < steps_per_refresh_ && drift_ <= allowed) return;
    update_slip_distance();
    watch();
}

bool TangCg::any_pushed_back() const {
    for (std::size_t e = 0; e < m_; ++e)
        if (is_pushed_back(e)) return true;
    return false;
}

std::size_t TangCg::hold_pushed_back() {
    std::size_t count = 0;
    for (std::size_t e = 0; e < m_; ++e) {
        if (!is_pushed_back(e)) continue;
        slips_[e] = false;
        ++count;
    }
    return count;
}

void TangCg::watch() {
    const double value = f();
    if (value <= best_f_ + slack_ * std::abs(best_f_)) {
        failures_ = 0;
    } else if (++failures_ > most_failures) {
        failures_ = 0;
        slack_ = std::min(10 * slack_, largest_slack);
        steps_per_refresh_ = std::max(steps_per_refresh_ / 2, 1);
        projected_gradient_step();
        keep_best();
        stands_ = false;
        return;
    }
    if (value < best_f_) keep_best();
}

void TangCg::keep_best() {
    best_p_ = p_;
    best_s_ = s_;
    best_f_ = f();
}

void TangCg::projected_gradient_step() {
    std::fill(v_.x.begin(), v_.x.end(), 1.0);
    std::fill(v_.y.begin(), v_.y.end(), 0.0);
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

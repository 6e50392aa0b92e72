#include "frozen_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "contact/rolling/transposed_compliance.hpp"
#include "contact/support/entering_particles.hpp"
#include "contact/support/traction_loops.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr double least_friction = 1e-100;  // as in boundary elements

bool is_steady_rolling(const ContactProblem& problem) {
    const auto* rolling = problem.friction ? std::get_if<Rolling>(&problem.motion) : nullptr;
    return rolling != nullptr && rolling->steady();
}

ElementBox box_of_pressures(const InfluenceOperator& influence, const Values& pressure) {
    return bounding_box(extent_of(influence), [&](std::size_t i) { return pressure[i] > 0; });
}

Contact elements_with(const Values& bound) {
    const Values none(bound.size());
    return {bound, none, none};
}

Values coefficients(const ContactProblem& problem) {
    Values mu(problem.grid.size());
    if (!problem.friction) return mu;
    for (std::size_t i = 0; i < mu.size(); ++i) {
        const double value = problem.friction->mu_of(i);
        mu[i] = value >= least_friction ? value : 0;
    }
    return mu;
}

/// Returns EnteringParticles::part for transient rolling, and nothing otherwise.
Values entering(const ContactProblem& problem, const Grid& grid, const Values& pressure) {
    const auto* rolling = problem.friction ? std::get_if<Rolling>(&problem.motion) : nullptr;
    if (rolling == nullptr || rolling->steady()) return {};
    return entering_particles(grid, pressure, step_of(problem)).part;
}

Values product(Values a, const Values& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] *= b[i];
    return a;
}

/// Sections change from row to row.
Reflection::Axes axes_of(const ContactProblem& problem) {
    return problem.bodies.any_uniform() || problem.columns ? Reflection::Axes::along_x : Reflection::Axes::both;
}

double mean(const Values& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

FrozenContact::FrozenContact(const ContactProblem& problem, const ContactInfluence& influence,
                             const ContactSolution& solution, Equations equations)
    : restriction_(*influence.current, box_of_pressures(*influence.current, solution.pressure), false),
      part_increment_(is_steady_rolling(problem) && !restriction_.is_whole()
                          ? influence.increment->on(restriction_.box())
                          : nullptr),
      is_whole_(restriction_.is_whole() || (is_steady_rolling(problem) && !part_increment_)),
      influence_(is_whole_ ? *influence.current : restriction_.influence()),
      increment_(is_whole_ && is_steady_rolling(problem) ? influence.increment.get() : part_increment_.get()),
      grid_(is_whole_ ? problem.grid : restriction_.crop(problem.grid)),
      coupled_(problem.friction && influence.current->coupled()),
      is_transposed_(equations == Equations::transposed),
      transposed_(is_transposed_ && increment_ != nullptr
                      ? std::make_unique<TransposedStep>(*increment_, grid_, axes_of(problem))
                      : nullptr),
      pressure_(crop(solution.pressure)),
      mu_(crop(coefficients(problem))),
      entering_(entering(problem, grid_, pressure_)),
      radial_(grid_.size()),
      pressed_(elements_with(pressure_)),
      rubbed_(elements_with(product(mu_, pressure_))),
      law_(rubbed_.size()),
      along_(rubbed_.size()),
      p_(grid_.size()),
      u_(grid_.size()),
      q_(grid_.size()),
      s_(grid_.size()),
      coupling_(grid_.size()),
      in_(rubbed_.size()),
      out_(rubbed_.size()) {
    if (!problem.friction) return;
    take_law(solution);
    if (rubbed_.size() == 0) return;
    const auto [x, y] = step_of(problem);
    // Several right-hand sides share steps, so that levels would save a sixth of them and make each half as expensive
    // again.
    if (transposed_)
        compliance_ = std::make_unique<TransposedCompliance>(RollingBodies{influence_, *increment_, grid_, x, y},
                                                             rubbed_, axes_of(problem));
    else
        compliance_ = compliance_of({influence_, increment_, grid_, x, y, PreconditionerLevels::never}, rubbed_);
    compliance_->linearise(law_);
    take_weights();
}

Values FrozenContact::crop(std::span<const double> whole) const {
    return is_whole_ ? Values(whole.begin(), whole.end()) : restriction_.crop(whole);
}

void FrozenContact::take_law(const ContactSolution& solution) {
    Field slip, traction;
    slip.x = crop(solution.slip_x);
    slip.y = crop(solution.slip_y);
    traction.x = crop(solution.traction_x);
    traction.y = crop(solution.traction_y);
    Values states(solution.element_division.size());
    for (std::size_t i = 0; i < states.size(); ++i) states[i] = solution.element_division[i] == ElementState::slip;
    states = crop(states);

    const std::size_t m = rubbed_.size();
    Field p(m), s(m), residual(m);
    Values inverse_bound(m);
    rubbed_.gather(traction.x, p.x);
    rubbed_.gather(traction.y, p.y);
    rubbed_.gather(slip.x, s.x);
    rubbed_.gather(slip.y, s.y);
    for (std::size_t e = 0; e < m; ++e) {
        law_.slips[e] = states[rubbed_.elements[e]] > 0;
        inverse_bound[e] = 1 / rubbed_.bound[e];
    }
    linearise_law(m, law_.slips.data(), p, s, inverse_bound.data(), law_.normal, law_.tangent_stiffness.data(),
                  residual);

    // Friction that begins opposes the slip without friction.
    for (const std::size_t i : pressed_.elements) {
        const double size = std::hypot(slip.x[i], slip.y[i]);
        if (mu_[i] > 0 || size == 0) continue;
        radial_.x[i] = -slip.x[i] / size;
        radial_.y[i] = -slip.y[i] / size;
    }
    rubbed_.scatter(law_.normal.x, radial_.x);
    rubbed_.scatter(law_.normal.y, radial_.y);

    for (std::size_t e = 0; e < m; ++e) {
        along_.x[e] = law_.slips[e] ? -law_.normal.y[e] : 1;
        along_.y[e] = law_.normal.x[e];
        if (!law_.slips[e]) adhering_.push_back(e);
    }
}

// Large residuals matter little where the tangent is stiff. Therefore all are measured by their approximate tractions,
// converted to displacements, together with the residuals of the pressures.
void FrozenContact::take_weights() {
    const double stiffness = mean(influence_.diagonal(Axis::z));
    const Values& self = compliance_->self();
    weights_.resize(static_cast<Eigen::Index>(rubbed_.size() + adhering_.size()));
    Eigen::Index k = 0;
    for (std::size_t e = 0; e < rubbed_.size(); ++e) weights_[k++] = stiffness / (self[e] + law_.tangent_stiffness[e]);
    for (const std::size_t e : adhering_) weights_[k++] = stiffness / self[e];
}

void FrozenContact::take_pressures(const Vector& dp) {
    for (std::size_t e = 0; e < pressed_.size(); ++e) p_[pressed_.elements[e]] = dp[static_cast<Eigen::Index>(e)];
}

void FrozenContact::take_bounds(const Vector& dg) {
    for (std::size_t e = 0; e < pressed_.size(); ++e) {
        const std::size_t i = pressed_.elements[e];
        q_.x[i] = radial_.x[i] * dg[static_cast<Eigen::Index>(e)];
        q_.y[i] = radial_.y[i] * dg[static_cast<Eigen::Index>(e)];
    }
}

void FrozenContact::take_free(const Eigen::Ref<const Vector>& dq) {
    Eigen::Index k = 0;
    for (std::size_t e = 0; e < rubbed_.size(); ++e, ++k) {
        in_.x[e] = along_.x[e] * dq[k];
        in_.y[e] = along_.y[e] * dq[k];
    }
    for (const std::size_t e : adhering_) in_.y[e] = dq[k++];
}

FrozenContact::Vector FrozenContact::free_of(const Field& field) const {
    Vector result(tractions());
    Eigen::Index k = 0;
    for (std::size_t e = 0; e < rubbed_.size(); ++e) result[k++] = along_.x[e] * field.x[e] + along_.y[e] * field.y[e];
    for (const std::size_t e : adhering_) result[k++] = field.y[e];
    return result;
}

void FrozenContact::add_free() {
    for (std::size_t e = 0; e < rubbed_.size(); ++e) {
        q_.x[rubbed_.elements[e]] += in_.x[e];
        q_.y[rubbed_.elements[e]] += in_.y[e];
    }
}

// Computes s_ = K q_, or K^T q_.
void FrozenContact::find_slip() {
    if (transposed_)
        transposed_->tangential(q_, s_);
    else if (increment_ != nullptr)
        increment_->tangential(q_.x, q_.y, s_.x, s_.y);
    else
        influence_.tangential(q_.x, q_.y, s_.x, s_.y);
}

void FrozenContact::give_normal(double* result) const {
    for (const Contact::Run& run : pressed_.runs) std::copy_n(&u_[run.grid_first], run.size, result + run.first);
}

// Returns P u + D dq for the response u in out_. In adhesion, nothing rotates.
FrozenContact::Vector FrozenContact::tangential_residual() {
    add_product(rubbed_.size(), law_.tangent_stiffness.data(), in_.x.data(), out_.x.data());
    add_product(rubbed_.size(), law_.tangent_stiffness.data(), in_.y.data(), out_.y.data());
    return free_of(out_);
}

FrozenContact::Values FrozenContact::on_grid(const Vector& dp, std::size_t size) {
    take_pressures(dp);
    return paste(p_, size);
}

void FrozenContact::normal(const Vector& dp, Vector& result) {
    take_pressures(dp);
    influence_.normal(p_, u_);
    give_normal(result.data());
}

void FrozenContact::precondition_normal(const Vector& r, Vector& z) {
    take_pressures(r);
    influence_.precondition(Axis::z, p_, u_);
    give_normal(z.data());
}

void FrozenContact::tangential(const Vector& dq, Vector& result) {
    take_free(dq);
    compliance_->apply(in_, out_);
    result = tangential_residual();
}

void FrozenContact::precondition_tangential(const Vector& r, Vector& z, int step) {
    take_free(r);
    const auto kind = step == 0 ? Compliance::Residual::first : Compliance::Residual::later;
    compliance_->precondition(in_, out_, kind, step);
    z = free_of(out_);
}

void FrozenContact::all(const Vector& both, Vector& result) {
    if (is_transposed_) return all_transposed(both, result);
    const Vector dp = both.head(pressures());
    take_bounds(bound_of_pressure(dp));
    take_free(both.tail(tractions()));
    add_free();
    find_slip();
    take_pressures(dp);
    if (increment_ != nullptr)
        increment_->tangential_of_normal(p_, coupling_.x, coupling_.y);
    else
        influence_.tangential_of_normal(p_, coupling_.x, coupling_.y);
    add(s_, coupling_);
    rubbed_.gather(s_.x, out_.x);
    rubbed_.gather(s_.y, out_.y);
    result.tail(tractions()) = tangential_residual();
    influence_.normal(p_, u_);
    influence_.normal_of_tangential(q_.x, q_.y, p_);
    for (std::size_t i = 0; i < u_.size(); ++i) u_[i] += std::exchange(p_[i], 0);
    give_normal(result.data());
}

void FrozenContact::precondition_all(const Vector& r, Vector& z, int step) {
    Vector dp(pressures()), dq(tractions());
    precondition_normal(r.head(pressures()), dp);
    if (tractions() > 0) precondition_tangential(r.tail(tractions()), dq, step);
    z << dp, dq;
}

}  // namespace contactd

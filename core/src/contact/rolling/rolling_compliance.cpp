#include "rolling_compliance.hpp"

#include <algorithm>
#include <numeric>

#include "contact/support/traction_loops.hpp"

namespace contactd {
namespace {

constexpr double sweep_self = 1.5;   // times the self-influence: of an element with its close neighbours
constexpr double stiff_self = 2;     // times the self-influence: turning stiffness that rules the Jacobian
constexpr double mostly_slip = 0.5;  // of the contact, from which one half of the preconditioner is enough
// Levels save iterations, each of which costs more, where there are many elements and nearly all of them slip.
constexpr std::size_t smallest_with_levels = 4000;
constexpr double part_with_levels = 0.6;

std::vector<double> times(double factor, std::vector<double> values) {
    for (double& value : values) value *= factor;
    return values;
}

}  // namespace

RollingCompliance::RollingCompliance(const RollingBodies& bodies, const Contact& contact, PreconditionerLevels levels)
    : influence_(bodies.influence),
      change_(bodies.change),
      contact_(contact),
      m_(contact.size()),
      influence_self_(tangential_diagonal(influence_, contact)),
      sweep_(bodies.grid, bodies.step_x, bodies.step_y, contact, times(sweep_self, influence_self_)),
      with_levels_(levels),
      swept_(m_),
      full_in_(influence_.size()),
      full_out_(influence_.size()),
      weight_(m_),
      diagonal_(m_),
      self_(times(sweep_.diagonal(), influence_self_)) {
    for (std::size_t e = 0; e < m_; ++e) {
        stiff_.push_back(stiff_self * influence_self_[e] * sweep_.diagonal());
        to_diagonal_.push_back(1 / (sweep_self * influence_self_[e]));
    }
}

void RollingCompliance::apply(const Field& p, Field& u) {
    contact_.product(change_, p, full_in_, full_out_, u);
}

void RollingCompliance::linearise(const Linearisation& law) {
    law_ = &law;
    shifted_reciprocal(m_, law.turning.data(), stiff_.data(), stiff_.data(), weight_.data());
    for (std::size_t e = 0; e < m_; ++e) diagonal_[e] = (1 - weight_[e] * weight_[e]) * to_diagonal_[e];
    slipping_ = static_cast<std::size_t>(std::count(law.slips.begin(), law.slips.end(), 1));
    sweep_.linearise(law);
    linearise_levels();
}

void RollingCompliance::linearise_levels() {
    uses_levels_ = false;
    if (with_levels_ == PreconditionerLevels::never || m_ < smallest_with_levels || slip_part() < part_with_levels)
        return;
    if (!levels_) {
        const double self = std::accumulate(self_.begin(), self_.end(), 0.0) / static_cast<double>(m_);
        levels_ = TurningLevels::make(change_, contact_, self);
        if (!levels_) return;
    }
    levels_->linearise(*law_);
    uses_levels_ = true;
}

double RollingCompliance::slip_part() const {
    return static_cast<double>(slipping_) / static_cast<double>(m_);
}

void RollingCompliance::precondition(const Field& r, Field& z, Residual kind, int iteration) {
    if (!uses_levels_ || slipping_ < m_) precondition_by_halves(r, z, kind, iteration);
    if (uses_levels_) levels_->solve_slip(*law_, r, z);
}

void RollingCompliance::precondition_by_halves(const Field& r, Field& z, Residual kind, int iteration) {
    const bool both = uses_levels_ || slip_part() <= mostly_slip || kind == Residual::first;
    const bool sweep_first = iteration % 2 == 1;
    if (both || !sweep_first) {
        divide_by_influence(r, z);
        if (uses_levels_)
            sweep_.solve_adhesion(z, z);
        else
            sweep_.solve(z, z);
        if (!both) return;
    }
    Field& swept = both ? swept_ : z;
    sweep_.solve(r, swept);
    divide_by_influence(swept, swept);
    law_->project(swept);
    if (!both) return;
    for (std::size_t e = 0; e < m_; ++e) {
        z.x[e] = 0.5 * (z.x[e] + swept_.x[e]);
        z.y[e] = 0.5 * (z.y[e] + swept_.y[e]);
    }
}

void RollingCompliance::divide_by_influence(const Field& r, Field& q) {
    const auto scatter = [&](const std::vector<double>& from, std::vector<double>& to) {
        for (const Contact::Run& run : contact_.runs)
            multiply(run.size, &weight_[run.first], &from[run.first], &to[run.grid_first]);
    };
    const auto gather = [&](const std::vector<double>& from, const std::vector<double>& rest, std::vector<double>& to) {
        for (const Contact::Run& run : contact_.runs)
            multiply_two(run.size, &weight_[run.first], &from[run.grid_first], &diagonal_[run.first], &rest[run.first],
                         &to[run.first]);
    };
    scatter(r.x, full_in_.x);
    scatter(r.y, full_in_.y);
    influence_.precondition_tangential(full_in_.x, full_in_.y, full_out_.x, full_out_.y);
    gather(full_out_.x, r.x, q.x);
    gather(full_out_.y, r.y, q.y);
}

}  // namespace contactd

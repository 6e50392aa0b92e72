#include "rolling_compliance.hpp"

#include <algorithm>
#include <numeric>

#include "contact/support/traction_loops.hpp"

namespace contactd {
namespace {

constexpr double sweep_self = 1.5;   // times the self-influence: that of an element with its close neighbours
constexpr double mostly_slip = 0.5;  // part of the contact above which one half of the preconditioner is sufficient
// Levels save iterations, each of which costs more, if there are many elements and nearly all of them slip.
constexpr std::size_t smallest_with_levels = 4000;
constexpr double part_with_levels = 0.6;

std::vector<double> times(double factor, std::vector<double> values) {
    for (double& value : values) value *= factor;
    return values;
}

}  // namespace

RollingCompliance::RollingCompliance(const RollingBodies& bodies, const Contact& contact, PreconditionerLevels levels)
    : increment_(bodies.increment),
      contact_(contact),
      m_(contact.size()),
      influence_self_(tangential_diagonal(bodies.influence, contact)),
      sweep_(bodies.grid, bodies.step_x, bodies.step_y, contact, times(sweep_self, influence_self_)),
      division_(bodies.influence, contact, influence_self_, sweep_.diagonal()),
      with_levels_(levels),
      swept_(m_),
      full_in_(bodies.influence.size()),
      full_out_(bodies.influence.size()),
      self_(times(sweep_.diagonal(), influence_self_)) {}

void RollingCompliance::apply(const Field& p, Field& u) {
    contact_.product(increment_, p, full_in_, full_out_, u);
}

void RollingCompliance::linearise(const Linearisation& law) {
    law_ = &law;
    division_.linearise(law);
    slipping_ = static_cast<std::size_t>(std::count(law.slips.begin(), law.slips.end(), 1));
    sweep_.linearise(law);
    linearise_levels();
}

void RollingCompliance::linearise_levels() {
    uses_levels_ = false;
    if (law_->flow || with_levels_ == PreconditionerLevels::never || m_ < smallest_with_levels ||
        slip_part() < part_with_levels)
        return;
    if (!levels_) {
        const double self = std::accumulate(self_.begin(), self_.end(), 0.0) / static_cast<double>(m_);
        levels_ = TangentStiffnessLevels::make(increment_, contact_, self);
        if (!levels_) return;
    }
    levels_->linearise(*law_);
    uses_levels_ = true;
}

double RollingCompliance::slip_part() const {
    return static_cast<double>(slipping_) / static_cast<double>(m_);
}

void RollingCompliance::precondition(const Field& r, Field& z, Residual kind, int iteration) {
    if (!uses_levels_) return precondition_by_halves(r, z, kind, iteration);
    if (slipping_ < m_) precondition_adhesion(r, z);
    levels_->solve_slip(*law_, r, z);
}

void RollingCompliance::precondition_by_halves(const Field& r, Field& z, Residual kind, int iteration) {
    if (division_.take_all()) sweep_count_ = 0;
    const bool both = slip_part() <= mostly_slip || kind == Residual::first;
    const bool sweep_first = iteration % 2 == 1;
    if (both || !sweep_first) {
        division_.divide(r, z);
        sweep_.solve(z, z);
        if (!both) return;
    }
    Field& swept = both ? swept_ : z;
    sweep_.solve(r, swept);
    division_.divide(swept, swept);
    law_->project(swept);
    if (!both) return;
    for (std::size_t e = 0; e < m_; ++e) {
        z.x[e] = 0.5 * (z.x[e] + swept_.x[e]);
        z.y[e] = 0.5 * (z.y[e] + swept_.y[e]);
    }
}

void RollingCompliance::precondition_adhesion(const Field& r, Field& z) {
    if (division_.take_adhesion(law_->slips) || sweep_count_ == 0)
        sweep_count_ = sweep_.up_to_last([this](std::size_t e) { return division_.counts(e); });
    division_.divide(r, z);
    sweep_.solve_adhesion(z, z);
    sweep_.solve(r, swept_, sweep_count_);
    division_.divide(swept_, swept_);
    for (std::size_t e = 0; e < m_; ++e) {
        z.x[e] = 0.5 * (z.x[e] + swept_.x[e]);
        z.y[e] = 0.5 * (z.y[e] + swept_.y[e]);
    }
}

}  // namespace contactd

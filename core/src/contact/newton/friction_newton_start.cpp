// Starts FrictionNewton from an estimate, or from its own solution of a nearby problem.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "friction_newton.hpp"

namespace contactd {
namespace {

constexpr double far_moved = 1e-2;  // relative change by moves to the bounds above which the slip is recomputed
constexpr double start_self = 8;    // times the self-influence: converts slip to traction for the division

}  // namespace

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
    if (rms_w_ == 0) p_ = Field(m_);  // Nothing drives them.
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
    if (flow_) {
        flowed_ = flow_->flows();
        flow_->forget();
    }
    std::fill(law_.slips.begin(), law_.slips.end(), false);
    slip_of_ = p_;
    changed_ = find_division();
    if (changed_ > 0 && compliance_.is_far_reaching() && moved() > far_moved) {
        update_slip();
        slip_of_ = p_;
    }
    best_ = std::numeric_limits<double>::infinity();
    without_progress_ = 0;
    is_stale_ = is_stale_ || before_ != law_.slips || (flow_ && flowed_ != flow_->flows());
    if (border_) missing_ = border_->missing(p_);
    linearise();
}

// Returns the relative change of the tractions since the slip was computed.
double FrictionNewton::moved() const {
    double change = 0;
    for (std::size_t e = 0; e < m_; ++e)
        change += std::pow(p_.x[e] - slip_of_.x[e], 2) + std::pow(p_.y[e] - slip_of_.y[e], 2);
    return std::sqrt(change / inner(p_, p_));
}

// As in TangCg, this detects slip also if the bound has increased slightly since the estimate. The slip remains that of
// the estimate; the first step corrects it.
std::size_t FrictionNewton::find_division() {
    update_slip();
    if (!any(p_)) return 0;
    if (flow_) {
        std::vector<double> flexibility = compliance_.self();
        for (double& value : flexibility) value *= start_self;
        return flow_->divide_at_start(p_, s_, flexibility, law_.slips);
    }
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

// An element that has just come into contact has no traction, and the traction of others may point along the slip.
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

}  // namespace contactd

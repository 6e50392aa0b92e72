#include "asymmetric_norm.hpp"

#include <algorithm>
#include <cmath>

namespace contactd {
namespace {

constexpr int changes_of_a_kind = 6;  // changes of the set before it changes less often
constexpr double less_eagerly = 2;    // factor on the violation that changes it
constexpr double solved = 1e3;        // Such a violation waits until the equations within the set are solved.
constexpr int most_in_vain = 8;       // changes that do not reduce the number of violations

}  // namespace

bool AsymmetricNorm::is_violated(std::size_t i) const {
    return in_contact_[i] > 0 ? p_[i] < 0 : overlaps(i);
}

std::size_t AsymmetricNorm::violations() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < n_; ++i) count += is_violated(i);
    return count;
}

bool AsymmetricNorm::change_set(Check check, bool change_all) {
    if (check.right_set()) return false;
    if (weighty_ >= solved) {
        if (!change_all) return false;
        const std::size_t now = violations();
        if (now < fewest_) {
            fewest_ = now;
            in_vain_ = 0;
            one_by_one_ = false;
        } else if (++in_vain_ > most_in_vain) {
            one_by_one_ = true;
        }
        if (one_by_one_) return change_last();
    }
    if (!Norm::change_set(check, change_all)) return false;
    if (++changes_ % changes_of_a_kind == 0) weighty_ *= less_eagerly;
    return true;
}

bool AsymmetricNorm::change_last() {
    for (std::size_t i = n_; i-- > 0;) {
        if (!is_violated(i)) continue;
        in_contact_[i] = in_contact_[i] > 0 ? 0 : 1;
        ++changed_elements_;
        if (in_contact_[i] == 0) p_[i] = 0;
        if (problem_.pressure_sum) scale_to_sum(p_, u_);
        influence_.normal(p_, u_);
        find_approach();
        advance(0);
        steps_ = 0;
        return true;
    }
    return false;
}

// Returns the step to the least residual in the space of all directions since the last change of the set, or zero if
// rounding errors prevent a decrease.
double AsymmetricNorm::choose_step() {
    if (steps_ == 0) {
        directions_.clear();
        oldest_ = 0;
    }
    if (problem_.pressure_sum) {
        weigh_sum();
        keep_sum_of_residual();
    }
    influence_.precondition(Axis::z, r_, z_);
    if (problem_.pressure_sum) keep_sum_of_direction();
    const double* in = in_contact_.data();
    update_direction(n_, in, z_.data(), 0, v_.data());
    influence_.normal(v_, q_);
    Direction direction;
    if (problem_.pressure_sum) {
        const NormSlope slope = slope_along(state(), v_.data(), q_.data());
        direction.mean = slope.rise / slope.count;
        for (double& value : q_) value -= direction.mean;
    }
    const double size = triple_product(n_, in, q_.data(), q_.data());
    for (const Direction& before : directions_) {
        const double part = triple_product(n_, in, q_.data(), before.q.data()) / before.square;
        add_multiple(n_, -part, before.v.data(), v_.data());
        add_multiple(n_, -part, before.q.data(), q_.data());
        direction.mean -= part * before.mean;
    }
    direction.square = triple_product(n_, in, q_.data(), q_.data());
    const double slope = triple_product(n_, in, q_.data(), r_.data());
    const bool is_new = direction.square > rounding * rounding * size && std::isfinite(slope);
    steps_ = is_new ? steps_ + 1 : 0;
    if (!is_new) return 0;
    direction.v = v_;
    direction.q = q_;
    const double alpha = slope / direction.square;
    approach_ += alpha * direction.mean;
    for (double& value : q_) value += direction.mean;
    if (directions_.size() < most_directions) {
        directions_.push_back(std::move(direction));
    } else {
        directions_[oldest_] = std::move(direction);
        oldest_ = (oldest_ + 1) % most_directions;
    }
    return alpha;
}

std::unique_ptr<Norm> make_norm(const InfluenceOperator& influence, const NormProblem& problem,
                                const SolverSettings& settings, Observer& observer) {
    if (influence.is_symmetric()) return std::make_unique<Norm>(influence, problem, settings, observer);
    return std::make_unique<AsymmetricNorm>(influence, problem, settings, observer);
}

}  // namespace contactd

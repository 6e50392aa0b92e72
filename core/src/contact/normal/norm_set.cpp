// Changes NORM's contact set, and prevents endless changes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/support/solver_support.hpp"
#include "norm.hpp"

namespace contactd {
namespace {

constexpr int most_failures = 8;  // changes of the set that do not reduce f
// Moves p to the nearest point of p >= 0, sum(p) = sum (Michelot 1986).
void project_on_simplex(std::vector<double>& p, double sum) {
    double shift = -std::numeric_limits<double>::infinity();
    for (std::size_t before = 0, count = p.size(); count != before;) {
        before = count;
        double total = 0;
        count = 0;
        for (const double value : p) {
            if (!(value > shift)) continue;
            total += value;
            ++count;
        }
        shift = (total - sum) / static_cast<double>(count);
    }
    for (double& value : p) value = std::max(value - shift, 0.0);
}

}  // namespace

bool Norm::overlaps(std::size_t i) const {
    return gap(i) < -rounding * (std::abs(u_[i]) + std::abs(h_[i]) + std::abs(approach_));
}

// Keeps the pressures of the lowest f. Removing pressures may increase f temporarily. If this occurs too often in a
// row, restarts from the best by a step that cannot increase f, and returns false.
bool Norm::watch() {
    double value = potential(state());
    bool keeps = true;
    if (value < best_f_) {
        failures_ = 0;
    } else if (++failures_ > most_failures) {
        failures_ = 0;
        projected_gradient_step();
        value = potential(state());
        keeps = false;
    } else {
        return true;
    }
    best_p_ = p_;
    best_u_ = u_;
    best_f_ = value;
    return keeps;
}

// Removes negative pressures from the set.
void Norm::clip() {
    for (std::size_t i = 0; i < n_; ++i) {
        if (p_[i] > 0) continue;
        p_[i] = 0;
        changed_elements_ += in_contact_[i];
        in_contact_[i] = 0;
    }
    if (problem_.pressure_sum) scale_to_sum(p_, u_);
    influence_.normal(p_, u_);
    find_approach();
}

bool Norm::change_set(Check check, bool change_all) {
    const auto matters = [&](double violation) {
        return violation > 0 && (change_all || violation > weighty_ * weighty_ * check.defect);
    };
    bool changed = false;
    if (matters(check.suction)) {
        clip();
        check = advance(0);
        changed = true;
    }
    if (check.suction == 0 && (changed || matters(check.overlap)) && !watch()) {
        check = advance(0);
        changed = true;
    }
    if (matters(check.overlap)) {
        for (std::size_t i = 0; i < n_; ++i) {
            if (in_contact_[i] > 0 || !overlaps(i)) continue;
            in_contact_[i] = 1;
            r_[i] = -gap(i);
            ++changed_elements_;
        }
        changed = true;
    }
    if (!changed) return false;
    steps_ = 0;
    if (problem_.pressure_sum) {
        find_approach();
        advance(0);
    }
    return true;
}

// Starts from the best pressures, with a step of at most 1/||A||, which cannot increase f.
void Norm::projected_gradient_step() {
    if (norm_of_A_ == 0) {
        std::fill(p_.begin(), p_.end(), 1.0);
        influence_.normal(p_, q_);
        norm_of_A_ = *std::max_element(q_.begin(), q_.end());
    }
    for (std::size_t i = 0; i < n_; ++i) p_[i] = best_p_[i] - (best_u_[i] + h_[i]) / norm_of_A_;
    if (problem_.pressure_sum) project_on_simplex(p_, *problem_.pressure_sum);
    for (std::size_t i = 0; i < n_; ++i) {
        p_[i] = std::max(p_[i], 0.0);
        changed_elements_ += std::abs(in_contact_[i] - (p_[i] > 0));
        in_contact_[i] = p_[i] > 0;
    }
    influence_.normal(p_, u_);
    find_approach();
    steps_ = 0;
}

}  // namespace contactd

#include "friction_memory.hpp"

#include <algorithm>
#include <cmath>

#include "operators/upstream.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

}  // namespace

CarriedFriction::CarriedFriction(const ContactProblem& problem, std::span<const double> mu_static)
    : problem_(problem), memory_(*problem.friction->kinetic->memory), static_(mu_static.begin(), mu_static.end()) {
    if (const auto* rolling = std::get_if<Rolling>(&problem.motion))
        seconds_ = step_length(*rolling, problem.grid) / rolling->velocity;
    else
        seconds_ = std::get<Shift>(problem.motion).duration;
}

double CarriedFriction::theta(double slip_velocity) const {
    return memory_.distance / (memory_.distance + seconds_ * std::max(slip_velocity, memory_.least_velocity));
}

// The difference of a coefficient from the static one travels with the particle; it is zero when particles enter.
void CarriedFriction::begin(const Values& before) {
    const auto* rolling = std::get_if<Rolling>(&problem_.motion);
    if (rolling != nullptr && rolling->steady()) return;
    before_ = static_;
    if (before.empty()) return;
    Values fall(before.size());
    for (std::size_t i = 0; i < fall.size(); ++i)
        fall[i] = std::clamp(static_[i] - before[i], 0.0, static_[i] - problem_.friction->kinetic->mu);
    if (rolling != nullptr) {
        const auto [x, y] = step_of(problem_);
        fall = one_step_ahead(problem_.grid, x, y, fall, 0);
    }
    for (std::size_t i = 0; i < fall.size(); ++i) before_[i] -= fall[i];
}

Values CarriedFriction::after(std::span<const double> asked, std::span<const double> slip_velocity,
                              std::span<const double> pressure) const {
    Values mu = static_;
    if (!before_.empty()) {
        for (std::size_t i = 0; i < mu.size(); ++i) {
            if (!(pressure[i] > 0)) continue;
            const double stays = theta(slip_velocity[i]);
            mu[i] = stays * before_[i] + (1 - stays) * asked[i];
        }
        return mu;
    }
    std::vector<std::size_t> elements;
    for (std::size_t i = 0; i < mu.size(); ++i)
        if (pressure[i] > 0) elements.push_back(i);
    const auto [x, y] = step_of(problem_);
    const Upstream upstream(problem_.grid, x, y, elements);
    const double diagonal = upstream.diagonal();
    Values fall(elements.size());
    upstream.travel(
        0,
        [&](std::size_t e, double came) {
            const std::size_t i = elements[e];
            const double stays = theta(slip_velocity[i]), follows = 1 - stays;
            return (stays * diagonal * came + follows * (static_[i] - asked[i])) / (follows + stays * diagonal);
        },
        fall);
    for (std::size_t e = 0; e < elements.size(); ++e) mu[elements[e]] -= fall[e];
    return mu;
}

}  // namespace contactd

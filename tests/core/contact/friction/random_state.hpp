// Creates random contact problems with a layer between the bodies or with friction memory, and checks the equations of
// both on the answers.
#pragma once

#include <algorithm>
#include <cmath>

#include "../random_contact.hpp"

namespace contactd::test {

/// Returns values one step ahead of each element, interpolated between centres; `entering` beyond the grid.
inline Values ahead(const ContactProblem& problem, const Values& values, double entering) {
    const Grid& grid = problem.grid;
    const auto [step_x, step_y] = step_of(problem);
    Values result;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const double x = ix + step_x / grid.dx, y = iy + step_y / grid.dy;
            const double left = std::floor(x + 1e-9), below = std::floor(y + 1e-9);
            double sum = 0;
            for (const int b : {0, 1})
                for (const int a : {0, 1}) {
                    const double weight =
                        std::max(1 - std::abs(x - left - a), 0.0) * std::max(1 - std::abs(y - below - b), 0.0);
                    const bool inside = left + a >= 0 && left + a < grid.nx && below + b >= 0 && below + b < grid.ny;
                    sum += weight * (inside ? values[at(grid, static_cast<int>(left) + a, static_cast<int>(below) + b)]
                                            : entering);
                }
            result.push_back(sum);
        }
    return result;
}

inline bool is_steady(const ContactProblem& problem) {
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    return rolling != nullptr && rolling->steady();
}

/// Returns the state that particles carry to the elements, for a state that is `now` after the last step and was
/// `before`.
inline Values brought(const ContactProblem& problem, const Values& now, Values before, double entering) {
    before.resize(now.size(), entering);
    if (std::holds_alternative<Shift>(problem.motion)) return before;
    return ahead(problem, is_steady(problem) ? now : before, entering);
}

/// Returns tractions carried by particles. Those that enter during the step carry the tractions of their entry.
inline Values brought_tractions(const ContactProblem& problem, const ContactSolution& solution, const Values& now,
                                Values before) {
    before.resize(now.size());
    Values result = brought(problem, now, before, 0);
    for (int iy = 0; iy < problem.grid.ny; ++iy)
        for (int ix = 0; ix < problem.grid.nx; ++ix)
            if (const auto entry = entry_of(problem, solution.pressure, ix, iy))
                result[at(problem.grid, ix, iy)] = before[entry->from];
    return result;
}

/// Creates a problem of random_contact with friction but without a slip law, with a motion along an axis.
inline std::optional<ContactProblem> random_state(std::uint64_t seed, int largest_size) {
    ContactProblem problem = random_contact(seed, largest_size);
    if (!problem.friction || problem.friction->kinetic || problem.friction->mu.size() > 1) return {};
    Dice dice(seed + 99'000'000);
    FrictionLaw& friction = *problem.friction;
    auto* rolling = std::get_if<Rolling>(&problem.motion);
    const bool forces = std::visit([](const auto& motion) { return !motion.force.empty(); }, problem.motion);
    const bool at_axis = rolling == nullptr || rolling->chi == 0;
    const ContactSolution without = solve_half_spaces(problem);
    const double g = friction.mu[0] * without.pmax;
    if (!(g > 0) || !without.converged()) return {};
    const double slip = slip_unit(problem, without, friction.mu[0]);
    problem.settings.outer.max_iterations = 300;
    if (dice.chance(0.7)) {
        InterfacialLayer layer;
        if (dice.chance(0.7)) layer.flexibility = slip / g * dice.log_uniform(0.03, 3);
        if (dice.chance(0.8)) {
            // A layer without hardening must carry all forces that friction carries.
            const bool may_stay = !forces;
            layer.yield_stress = g * dice.uniform(0.1, 0.9);
            const double own = g / slip;  // the bodies' stiffness, about
            if (at_axis && dice.chance(0.8))
                layer.hardening = own * (dice.chance(0.7) ? dice.log_uniform(0.01, 100) : -dice.uniform(0.01, 0.15));
            if (!may_stay && !(layer.hardening > 0)) layer.hardening = at_axis ? own : 0;
            if (!may_stay && layer.hardening == 0) layer.yield_stress = InterfacialLayer{}.yield_stress;
        }
        friction.layer = layer;
    }
    if (!forces && (!friction.layer || dice.chance(0.3))) {
        const SlipLaw law = dice.chance(0.3)   ? SlipLaw::linear
                            : dice.chance(0.5) ? SlipLaw::rational
                                               : SlipLaw::exponential;
        KineticFriction kinetic{law, friction.mu[0] * dice.uniform(0.6, 1), 1};
        const double seconds = rolling ? step_length(*rolling, problem.grid) / rolling->velocity
                                       : std::get<Shift>(problem.motion).duration;
        kinetic.slip_velocity = slip / seconds * dice.log_uniform(1, 30);
        if (dice.chance(0.5))
            kinetic.second = SecondTerm{(friction.mu[0] - kinetic.mu) * dice.uniform(0, 1),
                                        kinetic.slip_velocity * dice.log_uniform(1, 10)};
        kinetic.memory = FrictionMemory{slip * dice.log_uniform(0.3, 30), slip / seconds * dice.log_uniform(1e-3, 1)};
        friction.kinetic = kinetic;
    }
    problem.previous = {};
    if (dice.chance(0.5) && !is_steady(problem)) {
        const ContactSolution before = solve_half_spaces(problem);
        problem.previous = {before.pressure, before.traction_x, before.traction_y, before.yield_stress,
                            before.friction_coefficient};
    }
    if (rolling) rolling->steps = 1;
    return problem;
}

/// Checks the tangential part of contact_faults.
inline std::string state_faults(const ContactProblem& problem, const ContactSolution& solution, double accuracy) {
    const FrictionLaw& friction = *problem.friction;
    const InterfacialLayer layer = friction.layer.value_or(InterfacialLayer{});
    const SurfaceState& previous = problem.previous;
    const std::size_t n = problem.grid.size();
    const Surface u = displacements(problem, solution.pressure, solution.traction_x, solution.traction_y, 0, 0);
    const Surface w = given_slip(problem, solution, previous);
    const Values old_x = brought_tractions(problem, solution, solution.traction_x, previous.traction_x),
                 old_y = brought_tractions(problem, solution, solution.traction_y, previous.traction_y);
    const Values v = layer.hardens()
                         ? brought(problem, solution.yield_stress, previous.yield_stress, layer.yield_stress)
                         : Values(n, layer.yield_stress);
    const Values mu_came =
        friction.kinetic && friction.kinetic->memory
            ? brought(problem, solution.friction_coefficient, previous.friction_coefficient, friction.mu[0])
            : Values(n, friction.mu[0]);
    const auto* rolling = std::get_if<Rolling>(&*solution.motion);
    const double seconds =
        rolling ? step_length(*rolling, problem.grid) / rolling->velocity : std::get<Shift>(*solution.motion).duration;
    const double unit_of_flow = rolling ? step_length(*rolling, problem.grid) : 1;
    double unit = 0;
    for (std::size_t i = 0; i < n; ++i)
        if (solution.pressure[i] > 0) unit = std::max({unit, std::hypot(u.x[i], u.y[i]), std::hypot(w.x[i], w.y[i])});
    unit *= accuracy;
    const auto where = [](std::size_t i, const std::string& what) {
        return "element " + std::to_string(i) + ": " + what;
    };
    for (std::size_t i = 0; i < n; ++i) {
        if (!(solution.pressure[i] > 0)) continue;
        const double px = solution.traction_x[i], py = solution.traction_y[i], p = std::hypot(px, py);
        const double tx = w.x[i] + u.x[i] + layer.flexibility * (px - old_x[i]);
        const double ty = w.y[i] + u.y[i] + layer.flexibility * (py - old_y[i]);
        const double t = std::hypot(tx, ty);
        const double flow = layer.yields() ? unit_of_flow * std::hypot(solution.flow_x[i], solution.flow_y[i]) : 0;
        double mu = friction.mu[0];
        if (friction.kinetic) {
            const double speed =
                solution.element_division[i] == ElementState::adhesion ? 0 : std::max(t - flow, 0.0) / seconds;
            const FrictionMemory& memory = *friction.kinetic->memory;
            const double stays = memory.distance / (memory.distance + seconds * std::max(speed, memory.least_velocity));
            mu = stays * mu_came[i] + (1 - stays) * friction_coefficient(*friction.kinetic, friction.mu[0], speed);
            if (std::abs(mu - solution.friction_coefficient[i]) > 1e-3 * friction.mu[0])
                return where(i, "the coefficient is not what memory leaves");
        }
        const double g = mu * solution.pressure[i], slack = friction.kinetic ? 2e-3 * g : 1e-6 * g;
        if (g < 1e-6 * solution.pmax) continue;
        const double held = std::min(g, v[i]), k = layer.hardening;
        if (solution.element_division[i] == ElementState::adhesion) {
            if (t > unit) return where(i, "adhesion slips by " + std::to_string(t / unit));
            if (p > held + slack + 1e-6 * g) return where(i, "adhesion beyond its bound");
            continue;
        }
        if (std::abs(tx * py - ty * px) > p * unit) return where(i, "slip and traction are not aligned");
        if (tx * px + ty * py > p * unit)
            return where(i, "slip along the traction by " + std::to_string((tx * px + ty * py) / (p * unit)));
        double bound = held;
        if (layer.hardens() && v[i] < g)
            bound = k > 0 ? std::min(g, v[i] + k * t) : std::max(v[i] + k * t, layer.residual * layer.yield_stress);
        const double off = slack + std::abs(k) * unit / (1 + std::abs(k) * unit / g);
        if (std::abs(p - bound) > off + 1e-4 * g)
            return where(i, "a traction of " + std::to_string(p / g) + " and not " + std::to_string(bound / g) +
                                " of its bound");
    }
    return {};
}

}  // namespace contactd::test

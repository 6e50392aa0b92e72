// Creates random problems of viscoelastic bodies, equal and dissimilar, checked like all random contact problems.
#pragma once

#include <numbers>

#include "contact/random_contact.hpp"

namespace contactd::test {

/// f ranges from 0.1 to 10, and the distance rolled in the time tau from 1e-3 to 1e3 half-lengths of the contact.
inline ContactProblem random_viscoelastic(std::uint64_t seed, int largest_size) {
    Dice dice(seed + 78'000'000);
    ContactProblem problem;
    problem.grid = random_grid(dice, 3, largest_size);
    problem.bodies = Bodies::of(random_bodies(dice));
    const Values h = random_distance(dice, problem.grid);
    problem.gap = h;
    const auto [least, most] = std::minmax_element(h.begin(), h.end());
    problem.approach = *least + dice.log_uniform(1e-3, 1) * std::max(*most - *least, 1e-3);
    const ContactSolution normal = solve_half_spaces(problem);
    if (dice.chance(0.6)) {
        problem.Fn = normal.forces.Fn;
        problem.approach.reset();
    }
    FrictionLaw friction;
    friction.mu = {dice.chance(0.1) ? 0 : dice.uniform(0, 1)};
    const double mu = friction.mu[0], largest = mu * normal.forces.Fn;
    const double length = std::sqrt(std::max(normal.area.contact, problem.grid.element_area()));
    const double size = slip_unit(problem, normal, mu) * dice.log_uniform(0.01, 5), angle = dice.uniform(0, 6.3);
    Rolling rolling;
    rolling.dq = problem.grid.dx * (dice.chance(0.6) ? 1 : dice.uniform(0.4, 2));
    rolling.chi = dice.chance(0.7) ? 0 : std::numbers::pi;
    rolling.xi = size / length * std::cos(angle);
    rolling.eta = size / length * std::sin(angle);
    if (dice.chance(0.4)) rolling.phi = size / length / length * dice.uniform(-1, 1);
    // Creep reduces the force at a prescribed approach.
    if (dice.chance(0.3) && largest > 0 && problem.Fn) prescribe_force(dice, largest, rolling.force);
    rolling.velocity = dice.log_uniform(1, 1e5);
    problem.friction = friction;
    problem.motion = rolling;
    const auto creep = [&] {
        return Viscoelasticity{dice.log_uniform(0.1, 10),
                               dice.log_uniform(1e-3, 1e3) * 0.5 * length / rolling.velocity};
    };
    const Viscoelasticity first = creep(), second = dice.chance(0.5) ? first : creep();
    if (!problem.bodies.upper.material.is_rigid() && dice.chance(0.8)) problem.bodies.upper.viscoelastic = first;
    if (!problem.bodies.upper.viscoelastic || dice.chance(0.8)) problem.bodies.lower.viscoelastic = second;
    return problem;
}

}  // namespace contactd::test

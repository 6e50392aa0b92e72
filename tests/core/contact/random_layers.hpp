// Creates random contact problems in which one or both bodies have layers.
#pragma once

#include "influence/layered/layered_table.hpp"
#include "random_contact.hpp"

namespace contactd::test {

/// Layers range from films of a fiftieth of an element to plates of fifty elements, soft and stiff, often
/// incompressible.
inline Layers random_layers(Dice& dice, double dx) {
    const auto random_nu = [&] { return dice.chance(0.3) ? 0.5 : dice.uniform(0, 0.5); };
    const double G = dice.log_uniform(0.1, 1e5);
    Layers body{{}, Material::rigid()};
    for (int left = dice.chance(0.5) ? 1 : dice.chance(0.5) ? 2 : 3; left > 0; --left)
        body.layers.push_back({dx * dice.log_uniform(0.02, 50), G * dice.log_uniform(0.05, 20), random_nu()});
    if (!dice.chance(0.5)) body.base = {G * dice.log_uniform(0.05, 20), random_nu()};
    return body;
}

inline IcTable table_of(const Grid& grid, const Body& body) {
    if (const Layers* layers = body.layered())
        return layered_table(*layers, body.computed()->load_shape, grid.nx, grid.ny, grid.dx, grid.dy);
    return body_table(grid, body.material);
}

inline ContactInfluence layered_influence(const ContactProblem& problem) {
    return make_influence(problem, BodyTable(table_of(problem.grid, problem.bodies.upper)),
                          BodyTable(table_of(problem.grid, problem.bodies.lower)));
}

inline ContactSolution solve_layers(const ContactProblem& problem) {
    Observer observer;
    return solve_contact(problem, layered_influence(problem), observer);
}

/// Returns a problem of random_contact whose bodies have layers, against a half-space, a rigid body, other layers, or
/// the same ones. Forces are those of the new bodies under the original approach, and creepages increase with the
/// compliance.
inline ContactProblem random_layered_contact(std::uint64_t seed, int largest_size) {
    Dice dice(seed + 99'000'000);
    ContactProblem problem = random_contact(seed, largest_size);
    const bool by_force = problem.Fn.has_value();
    if (by_force) problem.approach = solve_half_spaces(problem).approach;
    problem.Fn.reset();
    Bodies& bodies = problem.bodies;
    bodies.lower = Body::of(random_layers(dice, problem.grid.dx));
    if (dice.chance(0.3))
        bodies.upper = dice.chance(0.5) ? bodies.lower : Body::of(random_layers(dice, problem.grid.dx));
    problem.previous = {};
    ContactProblem frictionless = problem;
    frictionless.friction.reset();
    const ContactSolution normal = solve_layers(frictionless);
    if (by_force) {
        problem.Fn = normal.forces.Fn;
        problem.approach.reset();
    }
    if (!problem.friction) return problem;
    problem.friction->kinetic.reset();
    const double mu = problem.friction->mu[0];
    const IcTable pair = pair_of(table_of(problem.grid, bodies.upper), table_of(problem.grid, bodies.lower));
    // Under tractions mu p.
    const double slip = mu * std::sqrt(static_cast<double>(std::max(normal.elements.contact, 1))) * normal.pmax *
                        pair(Axis::x, Axis::x, 0, 0);
    const double size = slip * dice.log_uniform(0.01, 5), angle = dice.uniform(0, 6.3);
    const double length = std::sqrt(std::max(normal.area.contact, problem.grid.element_area()));
    const auto force = [&](Force& prescribed) {
        if (prescribed.empty()) return;
        prescribed = {};
        prescribe_force(dice, mu * normal.forces.Fn, prescribed);
    };
    if (auto* rolling = std::get_if<Rolling>(&problem.motion)) {
        rolling->xi = size / length * std::cos(angle);
        rolling->eta = size / length * std::sin(angle);
        if (rolling->phi != 0) rolling->phi = size / length / length * dice.uniform(-1, 1);
        force(rolling->force);
    } else {
        auto& shift = std::get<Shift>(problem.motion);
        shift.rigid_shift = {size * std::cos(angle), size * std::sin(angle)};
        if (shift.rotation != 0) shift.rotation = size / length * dice.uniform(-1, 1);
        force(shift.force);
    }
    return problem;
}

}  // namespace contactd::test

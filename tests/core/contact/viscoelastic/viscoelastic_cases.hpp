// Creates cylinders of the standard linear solid, with results of other programs, and random problems of such bodies.
#pragma once

#include <limits>

#include "contact/contact_cases.hpp"

namespace contactd::test {

/// Creates two equal cylinders, combined radius 50 mm, 600 N/mm, that brake with 0.6 of the friction limit.
inline ContactProblem cylinders(const Material& material, double f, double tau) {
    ContactProblem problem;
    problem.grid = {99, 1, 0.16, 1000, -8, -500};
    const Body body{material, Ics{}, Viscoelasticity{f, tau}};
    problem.bodies = {body, body};
    problem.gap = Paraboloid{50, std::numeric_limits<double>::infinity()};
    problem.Fn = 6e5;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = Rolling{.velocity = 1000, .force = {-0.6 * 0.3 * 6e5, {}}};
    return problem;
}

inline ContactProblem nylon_cylinders(double tau, double f = 1) {
    return cylinders({1143, 0.4}, f, tau);
}

/// Creates two viscoelastic bodies, a ball on a plane, under a force.
inline ContactProblem spheres(int n, double f, double tau, double velocity = 1000) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, 16.0 / n, 16.0 / n);
    const Body body{{1143, 0.4}, Ics{}, Viscoelasticity{f, tau}};
    problem.bodies = {body, body};
    problem.gap = Paraboloid{50, 50};
    problem.Fn = 2000;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = Rolling{.xi = 2e-3, .velocity = velocity};
    return problem;
}

}  // namespace contactd::test

// Tests a sphere under a constant normal load whose tangential force goes to +Q, back to -Q and to +Q again, step by
// step (Mindlin and Deresiewicz 1953; Johnson, section 7.4). With nu = 0 x and y are not coupled, so theory and
// discretisation solve the same problem.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contact/contact_cases.hpp"
#include "contactd/solve_contact.hpp"
#include "support/closed_forms.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr int n = 60;
constexpr double mu = 0.4, approach = 0.02, radius = 50;
const MaterialPair bodies{{200, 0}, {200, 0}};

// Holds the contact and its history: every step starts from the end of the previous one.
struct Path {
    ContactProblem problem;
    ContactInfluence influence;
    double largest = 0;          // force in full slip
    double shift = 0, work = 0;  // since the beginning: displacement of the force, and dissipated energy

    Path() {
        problem.grid = Grid::of_elements(n, n, 2.4 / n, 2.4 / n);
        problem.bodies = Bodies::of(bodies);
        problem.gap = Paraboloid{radius, radius};
        problem.approach = approach;
        influence = make_influence(problem, pair_table(problem));
        Observer observer;
        largest = mu * solve_contact(problem, influence, observer).forces.Fn;
    }

    // Fx as a fraction of the largest force.
    void step(double Fx) {
        problem.friction = FrictionLaw{{mu}};
        problem.motion = Shift{.force = {Fx * largest, {}}};
        Observer observer;
        ContactSolution solution = solve_contact(problem, influence, observer);
        REQUIRE(solution.converged());
        const double moved = std::get<Shift>(*solution.motion).rigid_shift.x;
        CHECK(*solution.frictional_work >= -1e-9 * largest * std::abs(moved));
        shift += moved;
        work += *solution.frictional_work;
        problem.previous = {std::move(solution.pressure), std::move(solution.traction_x),
                            std::move(solution.traction_y)};
        problem.initial.traction_x = problem.previous.traction_x;
        problem.initial.traction_y = problem.previous.traction_y;
    }
};

}  // namespace

TEST_CASE("a force that goes to and fro closes its hysteresis loop", "[verification]") {
    constexpr double highest = 0.8;  // of mu Fn
    constexpr int steps = 40;        // from +Q to -Q
    const auto hertz = reference::hertz(bodies, radius, approach);
    const double largest = mu * hertz.Fn;
    const double full = reference::cattaneo(bodies, hertz, mu, largest).rigid_shift;
    constexpr double discretisation = 2e-3;  // shift of full slip, at 50 elements across the contact
    Path path;
    // The force on the upper body opposes its shift: a push +Q on the upper body is a traction -Q.
    path.step(-highest);
    const double loaded = path.shift;
    CHECK_THAT(loaded,
               WithinAbs(reference::cattaneo(bodies, hertz, mu, highest * largest).rigid_shift, discretisation * full));
    const double before = path.work;
    double area = 0, last_shift = path.shift, last_push = highest;
    const auto go_to = [&](double push) {
        path.step(-push);
        area += 0.5 * (push + last_push) * path.largest * (path.shift - last_shift);
        last_shift = path.shift;
        last_push = push;
    };
    for (int k = 1; k <= steps; ++k) {
        const double push = highest * (1 - 2.0 * k / steps);
        go_to(push);
        CHECK_THAT(path.shift,
                   WithinAbs(reference::unloading_shift(bodies, hertz, mu, highest * largest, push * largest),
                             discretisation * full));
    }
    CHECK_THAT(path.shift, WithinAbs(-loaded, 1e-5 * full));
    for (int k = 1; k <= steps; ++k) {
        const double push = highest * (2.0 * k / steps - 1);
        go_to(push);
        CHECK_THAT(path.shift,
                   WithinAbs(-reference::unloading_shift(bodies, hertz, mu, highest * largest, -push * largest),
                             discretisation * full));
    }
    CHECK_THAT(path.shift, WithinAbs(loaded, 1e-5 * full));
    // Elements slip at their final traction, so the dissipated energy is the area of the loop, for any number of steps
    // above that of the trapezoids.
    const double dissipated = path.work - before;
    CHECK_THAT(dissipated, WithinRel(reference::dissipated_work(bodies, hertz, mu, highest * largest), 0.03));
    CHECK_THAT(area, WithinRel(dissipated, 0.03));
}

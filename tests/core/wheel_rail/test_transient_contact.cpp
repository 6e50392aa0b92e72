// Tests steps of a wheel on its rail that continue from the tractions of the previous step.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <variant>

#include "contact/contact_cases.hpp"
#include "contact/rolling/rolling.hpp"
#include "contactd/error.hpp"
#include "contactd/solve_contact.hpp"
#include "contactd/solve_wheel_rail.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;

namespace {

WheelRailSetup coarse_setup() {
    WheelRailSetup setup;
    setup.dx = setup.dy = 1;
    return setup;
}

WheelRailState state_with(WheelRailMotion motion) {
    WheelRailState state;
    state.position.y = 3;
    state.velocity.x = 2000;
    state.velocity.pitch = -4.345;
    state.position.yaw = 0.002;
    state.Fz = 5e4;
    state.motion = motion;
    return state;
}

WheelRailState shift_by(double x, double y) {
    WheelRailState state = state_with(WheelRailMotion::shift);
    state.velocity = {};
    state.velocity.x = x;
    state.velocity.y = y;
    state.position.yaw = 0;
    state.time_step = 1;
    return state;
}

/// Solves steady rolling of a patch, on its elements.
ContactProblem steady_problem(const WheelRailSetup& setup, const WheelRailPatch& patch) {
    const Creepages& creepages = patch.place.creepages;
    ContactProblem problem;
    problem.grid = patch.place.grid;
    problem.bodies = setup.bodies;
    problem.gap = patch.gap;
    problem.approach = patch.place.approach;
    problem.friction = FrictionLaw{{0.3}, {}};
    Rolling rolling;
    rolling.xi = creepages.xi;
    rolling.eta = creepages.eta;
    rolling.phi = creepages.phi;
    rolling.velocity = creepages.velocity;
    rolling.spin_offset = 1.0 / 6;
    problem.motion = rolling;
    return problem;
}

ContactInfluence influence_of(const ContactProblem& problem) {
    return test::operators_of(problem, test::pair_table(problem));
}

double largest_change(const WheelRailSolution& one, const WheelRailSolution& other) {
    REQUIRE(one.patches.size() == 1);
    REQUIRE(other.patches.size() == 1);
    const ContactSolution &a = one.patches[0].solution, &b = other.patches[0].solution;
    REQUIRE(a.traction_x.size() == b.traction_x.size());
    double largest = 0;
    for (std::size_t i = 0; i < a.traction_x.size(); ++i)
        largest = std::max(largest, std::hypot(a.traction_x[i] - b.traction_x[i], a.traction_y[i] - b.traction_y[i]));
    return largest / *std::max_element(a.pressure.begin(), a.pressure.end());
}

}  // namespace

TEST_CASE("Many equal steps of transient rolling end as steady rolling") {
    const WheelRailContact contact(coarse_setup());
    Observer observer;
    WheelRailEstimates left;
    WheelRailSolution last;
    for (int step = 0; step < 40; ++step)
        last = contact.solve(state_with(WheelRailMotion::transient_rolling), left, observer);
    REQUIRE(last.converged());
    const ContactProblem problem = steady_problem(contact.setup(), last.patches.at(0));
    const ContactSolution steady = solve_contact(problem, influence_of(problem), observer);
    const ContactSolution& rolling = last.patches[0].solution;
    const double scale = 0.3 * steady.forces.Fn;
    CHECK_THAT(rolling.forces.Fn, WithinAbs(steady.forces.Fn, 1e-6 * scale));
    CHECK_THAT(rolling.forces.Fx, WithinAbs(steady.forces.Fx, 1e-4 * scale));
    CHECK_THAT(rolling.forces.Fy, WithinAbs(steady.forces.Fy, 1e-4 * scale));
    const WheelRailSolution next = contact.solve(state_with(WheelRailMotion::transient_rolling), left, observer);
    CHECK(largest_change(last, next) < 1e-4);
}

TEST_CASE("A first step of transient rolling starts from no tractions") {
    const WheelRailContact contact(coarse_setup());
    Observer observer;
    WheelRailEstimates left;
    const WheelRailState state = state_with(WheelRailMotion::transient_rolling);
    const WheelRailSolution first = contact.solve(state, left, observer);
    CHECK(largest_change(first, contact.solve(state, observer)) < 1e-6);
    const WheelRailSolution second = contact.solve(state, left, observer);
    const auto creep_force = [](const WheelRailSolution& solution) {
        const Forces& forces = solution.patches.at(0).solution.forces;
        return std::hypot(forces.Fx, forces.Fy);
    };
    CHECK(creep_force(second) > 1.3 * creep_force(first));
}

TEST_CASE("A step without motion changes nothing") {
    const WheelRailContact contact(coarse_setup());
    Observer observer;
    WheelRailEstimates left;
    const WheelRailSolution shifted = contact.solve(shift_by(0.01, 0.02), left, observer);
    REQUIRE(std::abs(shifted.forces.track.Fy) > 100);
    const WheelRailSolution still = contact.solve(shift_by(0, 0), left, observer);
    CHECK(largest_change(shifted, still) < 1e-6);
    // The same applies to a wheel that rolls and stops.
    WheelRailState standing = shift_by(0, 0);
    standing.motion = WheelRailMotion::transient_rolling;
    CHECK(largest_change(shifted, contact.solve(standing, left, observer)) < 1e-6);
}

TEST_CASE("A wheel that starts slips by what its velocities bring in the time of the step") {
    const WheelRailContact contact(coarse_setup());
    Observer observer;
    WheelRailEstimates one, other;
    WheelRailState start = shift_by(1e-7, 1);
    start.time_step = 0.02;
    const WheelRailSolution shifted = contact.solve(start, one, observer);
    start.motion = WheelRailMotion::transient_rolling;
    const WheelRailSolution started = contact.solve(start, other, observer);
    CHECK(std::abs(shifted.forces.track.Fy) > 100);
    CHECK(largest_change(shifted, started) < 1e-3);
}

TEST_CASE("A shift and its reverse leave tractions behind") {
    const WheelRailContact contact(coarse_setup());
    Observer observer;
    WheelRailEstimates left;
    std::vector<double> forces;
    double work = 0;
    for (const double y : {0.02, -0.02, -0.02, 0.02, 0.02}) {
        const WheelRailSolution solution = contact.solve(shift_by(0, y), left, observer);
        REQUIRE(solution.converged());
        forces.push_back(solution.forces.track.Fy);
        work += solution.patches.at(0).solution.frictional_work.value_or(0);
    }
    const double normal = forces[1];
    CHECK(forces[0] > normal);
    CHECK(forces[2] < normal);
    // The loop closes where it has been once.
    CHECK_THAT(forces[4], WithinAbs(forces[0], 0.05 * std::abs(forces[0] - forces[2])));
    CHECK(std::abs(forces[3] - forces[1]) > 0.05 * std::abs(forces[0] - forces[2]));
    CHECK(work > 0);
}

TEST_CASE("Each step of a shift stores or rubs away what its motion brings") {
    const WheelRailContact contact(coarse_setup());
    Observer observer;
    WheelRailEstimates left;
    WheelRailState state = shift_by(0, 0);
    state.position.z = contact.solve(state, observer).z;
    state.Fz.reset();
    state.displacements = true;
    WheelRailSolution before = contact.solve(state, left, observer);
    double most = 0;
    for (const double y : {0.01, 0.02, 0.01, -0.02, -0.02, 0.015}) {
        state.velocity.y = y;
        state.velocity.x = -y / 3;
        const WheelRailSolution after = contact.solve(state, left, observer);
        REQUIRE(after.converged());
        REQUIRE(after.patches.size() == 1);
        const ContactSolution &was = before.patches.at(0).solution, &is = after.patches[0].solution;
        const Grid& grid = after.patches[0].place.grid;
        REQUIRE(was.pressure.size() == is.pressure.size());
        const RigidSlip shift = rigid_slip(grid, std::get<Shift>(*is.motion));
        double work = 0, of_changes = 0;
        for (std::size_t i = 0; i < grid.size(); ++i) {
            work -= is.traction_x[i] * shift.x[i] + is.traction_y[i] * shift.y[i];
            of_changes += (is.traction_x[i] - was.traction_x[i]) * (is.displacement_x[i] - was.displacement_x[i]) +
                          (is.traction_y[i] - was.traction_y[i]) * (is.displacement_y[i] - was.displacement_y[i]);
        }
        work *= grid.element_area();
        most = std::max(most, std::abs(work));
        // Tractions of a step are those at its end: of what they change by, half is brought too much.
        const double stored = *is.elastic_energy - *was.elastic_energy + 0.5 * of_changes * grid.element_area();
        CHECK_THAT(stored + *is.frictional_work, WithinAbs(work, 1e-6 * most));
        before = after;
    }
    CHECK(most > 1);
}

TEST_CASE("Elements of a shift are fixed to the rail") {
    const WheelRailContact contact(coarse_setup());
    Observer observer;
    WheelRailEstimates left;
    const WheelRailSolution shifted = contact.solve(shift_by(0, 0.02), left, observer);
    WheelRailState moved = shift_by(0, 0);
    moved.position.x = 2;
    moved.velocity.x = 2;
    moved.velocity.pitch = -2 / 459.9;
    const WheelRailSolution next = contact.solve(moved, left, observer);
    REQUIRE(next.patches.size() == 1);
    const ContactPlace &before = shifted.patches[0].place, &after = next.patches[0].place;
    // Both lie at multiples of an element along the rail, and the wheel has run two of them.
    const double ahead = (after.reference.x + 2 + after.grid.x0) - (before.reference.x + before.grid.x0);
    CHECK_THAT(ahead, WithinAbs(std::round(ahead), 1e-9));
    // What it has left behind bears no traction, and what it takes along still bears its part.
    WheelRailState fresh = moved;
    const WheelRailSolution alone = contact.solve(fresh, observer);
    CHECK(next.forces.track.Fy - alone.forces.track.Fy > 0.3 * (shifted.forces.track.Fy - alone.forces.track.Fy));
}

TEST_CASE("A patch that tractions before would make too large is refused") {
    WheelRailSetup setup = coarse_setup();
    setup.dx = setup.dy = 0.05;
    const WheelRailContact contact(setup);
    WheelRailState state = shift_by(0, 0.01);
    const ContactPlace place = contact.locate(state).places.at(0);
    REQUIRE(place.grid.size() > 23000);
    WheelRailEstimates::Patch before{place.grid, place.reference.y, place.on_rail, 0, {}};
    before.grid.x0 *= 2.9;
    before.grid.y0 *= 2.9;
    before.grid.nx = static_cast<int>(2.9 * place.grid.nx);
    before.grid.ny = static_cast<int>(2.9 * place.grid.ny);
    before.tractions.traction_x.assign(before.grid.size(), 1);
    WheelRailEstimates left;
    left.patches = {before};
    Observer observer;
    CHECK_THROWS_AS(contact.solve(state, left, observer), InvalidArgument);
}

TEST_CASE("Steps that make no sense are refused by name") {
    const WheelRailContact contact(coarse_setup());
    Observer observer;
    const auto refused = [&](const WheelRailState& state, const WheelRailContact& of) -> std::string {
        try {
            of.solve(state, observer);
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return "nothing";
    };
    WheelRailState state = shift_by(0, 0.02);
    state.time_step.reset();
    CHECK(refused(state, contact) == "state.time_step");
    state = state_with(WheelRailMotion::steady_rolling);
    state.time_step = 0.1;
    CHECK(refused(state, contact) == "state.time_step");
    state = state_with(WheelRailMotion::transient_rolling);
    state.time_step = 1e9;
    CHECK(refused(state, contact) == "state.time_step");
    WheelRailSetup simplified = coarse_setup();
    simplified.model = Model::fastsim;
    CHECK(refused(shift_by(0, 0.02), WheelRailContact(simplified)) == "state.motion");
}

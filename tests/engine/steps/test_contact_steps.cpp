// Tests steps of a simulation, each of which starts from the end of the previous one, without a daemon.
#include <catch2/catch_test_macros.hpp>

#include "contactd/solve_contact.hpp"
#include "engine/engine.hpp"

using namespace contactd;
using namespace contactd::engine;

namespace {

SessionSpec ball_on_plate() {
    SessionSpec spec;
    spec.setup.grid = Grid::of_elements(12, 12, 0.5, 0.5);
    spec.setup.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    spec.setup.friction = FrictionLaw{.mu = {0.3}};
    spec.load.gap = Paraboloid{400, 400};
    spec.load.Fn = 5000;
    return spec;
}

StepInput shifted(double x) {
    StepInput input;
    input.motion = Shift{.rigid_shift = {x, 0}};
    return input;
}

ContactSteps::Overlay saying(const StepInput& input) {
    return [&input](const std::optional<Motion>& last, ContactProblem& problem) { overlay(input, last, problem); };
}

/// Holds an engine, its steps, and the current state.
struct Simulation {
    Engine engine{{}};
    Observer observer;
    std::unique_ptr<ContactSteps> steps;
    StepState state;

    explicit Simulation(SessionSpec spec) : steps(engine.open(std::move(spec), observer)), state(steps->start()) {}

    ContactSolution step(const StepInput& input) {
        ContactSolution solution = engine.solve(*steps, state, saying(input), observer);
        ContactSolution reported = solution;
        state = ContactSteps::after(state, std::move(solution));
        return reported;
    }
};

std::string field_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const InvalidArgument& error) {
        return error.field();
    }
    return "none";
}

}  // namespace

TEST_CASE("A step starts from the tractions that the one before left") {
    Simulation simulation(ball_on_plate());
    const ContactSolution first = simulation.step(shifted(0.001));
    const ContactSolution second = simulation.step(shifted(-0.0004));

    ContactProblem alone{simulation.steps->opened};
    alone.motion = Shift{.rigid_shift = {-0.0004, 0}};
    alone.previous = alone.initial = {first.pressure, first.traction_x, first.traction_y};
    const ContactSolution expected = simulation.engine.solve(alone, simulation.observer).solution;
    CHECK(second.traction_x == expected.traction_x);
    CHECK(second.pressure == expected.pressure);
    CHECK(simulation.state.step == 2);
}

TEST_CASE("A step taken from a state that was held gives what it gave before") {
    Simulation simulation(ball_on_plate());
    simulation.step(shifted(0.001));
    const StepState held = simulation.state;
    const ContactSolution once = simulation.step(shifted(0.0005));
    simulation.step(shifted(-0.002));
    simulation.state = held;
    CHECK(simulation.step(shifted(0.0005)).traction_x == once.traction_x);
    CHECK(simulation.state.step == 2);
}

TEST_CASE("What a step leaves out is as the simulation was opened") {
    Simulation simulation(ball_on_plate());
    StepInput heavier;
    heavier.Fn = 8000;
    CHECK(simulation.step(heavier).forces.Fn > 7900);
    CHECK(simulation.step({}).forces.Fn < 5100);
}

TEST_CASE("The creepage found for a prescribed force is the estimate of the next step") {
    SessionSpec spec = ball_on_plate();
    spec.load.motion = Rolling{.force = {.Fx = -600, .Fy = {}}};
    Simulation simulation(spec);
    const double xi = std::get<Rolling>(*simulation.step({}).motion).xi;
    CHECK(xi != 0);

    ContactProblem problem = simulation.steps->opened;
    overlay({}, simulation.state.motion, problem);
    CHECK(std::get<Rolling>(problem.motion).xi == xi);
}

TEST_CASE("Steps of another length get operators of their own") {
    SessionSpec spec = ball_on_plate();
    spec.load.motion = Rolling{.xi = 0.002};
    Simulation simulation(spec);
    simulation.step({});
    StepInput longer;
    longer.motion = Rolling{.xi = 0.002, .dq = 1};
    simulation.state = simulation.steps->start();
    const ContactSolution solution = simulation.step(longer);

    ContactProblem alone{simulation.steps->opened};
    alone.motion = *longer.motion;
    const ContactSolution expected = simulation.engine.solve(alone, simulation.observer).solution;
    CHECK(std::abs(solution.forces.Fx - expected.forces.Fx) < 1e-4 * std::abs(expected.forces.Fx));
}

TEST_CASE("A step that misses its tolerance counts only where such steps do") {
    SessionSpec spec = ball_on_plate();
    spec.setup.settings.normal.max_iterations = 1;
    Simulation strict(spec);
    try {
        strict.step({});
        FAIL("the step counted");
    } catch (const StatusError& error) {
        CHECK(error.status().reason == reason::not_converged);
    }
    CHECK(strict.state.step == 0);

    spec.accept_unconverged = true;
    Simulation generous(spec);
    CHECK_FALSE(generous.step({}).converged());
    CHECK(generous.state.step == 1);
}

TEST_CASE("What neither opening nor step say is named") {
    SessionSpec spec = ball_on_plate();
    spec.load.gap.reset();
    spec.load.Fn.reset();
    spec.setup.friction.reset();
    Simulation simulation(spec);
    StepInput input;
    CHECK(field_of([&] { simulation.step(input); }) == "approach");
    input.Fn = 100;
    CHECK(field_of([&] { simulation.step(input); }) == "gap");
    input.gap = Paraboloid{400, 400};
    input.motion = Shift{};
    CHECK(field_of([&] { simulation.step(input); }) == "friction.mu");
    input.motion.reset();
    input.approach = 0.01;
    CHECK(field_of([&] { simulation.step(input); }) == "Fn");
    CHECK(simulation.state.step == 0);
}

// Tests steps of a wheel on its rail, without a daemon.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "contactd/error.hpp"
#include "contactd/status.hpp"
#include "engine/engine.hpp"

using namespace contactd;
using namespace contactd::engine;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;
using Catch::Matchers::WithinAbs;

namespace {

WheelRailSessionSpec coarse() {
    WheelRailSessionSpec spec;
    spec.setup.dx = spec.setup.dy = 1;
    return spec;
}

WheelRailStepInput rolling_at(double y) {
    WheelRailStepInput input;
    input.state.position.y = y;
    input.state.velocity.x = 2000;
    input.state.velocity.pitch = -2000 / 460.0;
    input.state.Fz = 1e4;
    return input;
}

/// Holds an engine, its steps, and the current state.
struct Simulation {
    Engine engine{{}};
    Observer observer;
    std::unique_ptr<WheelRailSteps> steps;
    StepState here;

    explicit Simulation(const WheelRailSessionSpec& spec) : steps(engine.open(spec)) {}

    WheelRailSolution step(const WheelRailStepInput& input) {
        StepState after;
        WheelRailSolution solution = engine.solve(*steps, here, input, after, observer);
        here = std::move(after);
        return solution;
    }
};

}  // namespace

TEST_CASE("A step of a wheel answers what the engine does without one") {
    Simulation wheel(coarse());
    for (const double y : {0.0, 0.1, 3.0, -2.0}) {
        const WheelRailSolution kept = wheel.step(rolling_at(y));
        const WheelRailSolution alone = wheel.engine.solve(coarse().setup, rolling_at(y).state, wheel.observer);
        CHECK_THAT(kept.forces.track.Fx, WithinAbs(alone.forces.track.Fx, 0.05));
        CHECK_THAT(kept.forces.track.Fy, WithinAbs(alone.forces.track.Fy, 0.05));
    }
    CHECK(wheel.here.step == 4);
}

TEST_CASE("A step of a wheel from the same state has the same answer") {
    Simulation wheel(coarse());
    static_cast<void>(wheel.step(rolling_at(1)));
    const StepState saved = wheel.here;
    const Wrench first = wheel.step(rolling_at(1.5)).forces.track;
    static_cast<void>(wheel.step(rolling_at(4)));
    wheel.here = saved;
    CHECK(wheel.step(rolling_at(1.5)).forces.track == first);
}

TEST_CASE("A step of a wheel may name its friction, which does not stay") {
    Simulation wheel(coarse());
    WheelRailStepInput wet = rolling_at(3);
    wet.friction = WheelRailFriction{{{0, 0.05}}};
    const double dry_force = wheel.step(rolling_at(3)).forces.track.Fy;
    WheelRailSetup slippery = coarse().setup;
    slippery.friction = wet.friction;
    const Wrench alone = wheel.engine.solve(slippery, wet.state, wheel.observer).forces.track;
    CHECK_THAT(wheel.step(wet).forces.track.Fy, WithinAbs(alone.Fy, 0.05));
    CHECK_THAT(wheel.step(rolling_at(3)).forces.track.Fy, WithinAbs(dry_force, 0.05));
    wet.friction->mu = {};
    CHECK_THROWS_WITH(wheel.step(wet), StartsWith("friction.mu is empty"));
    CHECK(wheel.here.step == 3);
}

TEST_CASE("A step of a wheel that misses its tolerance counts only where that is accepted") {
    WheelRailSessionSpec spec = coarse();
    spec.setup.force = {1e-14, 2};
    Simulation wheel(spec);
    CHECK_THROWS_WITH(wheel.step(rolling_at(1)), ContainsSubstring("the search for z after 2 iterations"));
    CHECK(wheel.here.step == 0);
    spec.accept_unconverged = true;
    Simulation accepting(spec);
    CHECK_FALSE(accepting.step(rolling_at(1)).converged());
    CHECK(accepting.here.step == 1);
}

TEST_CASE("What steps of a wheel cannot use is named") {
    WheelRailSessionSpec spec = coarse();
    spec.setup.track.gauge = -1;
    Engine engine({});
    CHECK_THROWS_WITH(engine.open(spec), StartsWith("setup.track.gauge "));
    Simulation wheel(coarse());
    WheelRailStepInput deep = rolling_at(0);
    deep.state.Fz.reset();
    deep.state.position.z = 20;
    CHECK_THROWS_WITH(wheel.step(deep), StartsWith("state.position.z "));
}

// Tests wheels on rails that are kept between steps, and the engine's answers for them.
#include "engine/wheel_rail/prepared_contacts.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "contactd/error.hpp"
#include "contactd/status.hpp"
#include "engine/engine.hpp"

using namespace contactd;
using namespace contactd::engine;
using Catch::Matchers::StartsWith;
using Catch::Matchers::WithinAbs;

namespace {

WheelRailSetup coarse_setup() {
    WheelRailSetup setup;
    setup.dx = setup.dy = 1;
    return setup;
}

WheelRailState rolling_state() {
    WheelRailState state;
    state.velocity.x = 2000;
    state.velocity.pitch = -2000 / 460.0;
    state.Fz = 1e4;
    return state;
}

}  // namespace

TEST_CASE("A contact is prepared once for equal set-ups") {
    PreparedContacts contacts(nullptr);
    WheelRailSetup setup = coarse_setup();
    const auto first = contacts.of(setup);
    CHECK(contacts.of(coarse_setup()) == first);
    setup.rail.shape = Rail60E1{1.0 / 20};
    CHECK(contacts.of(setup) != first);
    CHECK(contacts.size() == 2);
    CHECK(contacts.of(coarse_setup()) == first);
}

TEST_CASE("Contacts that were not used for long go") {
    PreparedContacts contacts(nullptr);
    WheelRailSetup setup = coarse_setup();
    const auto first = contacts.of(setup);
    for (int i = 1; i <= 40; ++i) {
        setup.dx = 1 + 0.01 * i;
        static_cast<void>(contacts.of(setup));
    }
    CHECK(contacts.size() == 32);
    CHECK(contacts.of(coarse_setup()) != first);
}

TEST_CASE("A set-up that cannot be used is not cached") {
    PreparedContacts contacts(nullptr);
    WheelRailSetup setup = coarse_setup();
    setup.track.gauge = -1;
    CHECK_THROWS_AS(contacts.of(setup), InvalidArgument);
    CHECK(contacts.size() == 0);
}

TEST_CASE("The engine answers as a contact of one's own, and the same again") {
    Engine engine({});
    Observer observer;
    const WheelRailSolution alone = solve_wheel_rail(coarse_setup(), rolling_state(), observer);
    const WheelRailSolution first = engine.solve(coarse_setup(), rolling_state(), observer);
    const WheelRailSolution again = engine.solve(coarse_setup(), rolling_state(), observer);
    // Coefficients are kept dimensionless, which changes the rounding.
    CHECK_THAT(first.forces.track.Fx, WithinAbs(alone.forces.track.Fx, 1e-6));
    CHECK_THAT(first.forces.track.Fy, WithinAbs(alone.forces.track.Fy, 1e-6));
    CHECK(again.forces.track == first.forces.track);
    REQUIRE(again.patches.size() == 1);
    CHECK(again.patches[0].solution.pressure == first.patches[0].solution.pressure);
    CHECK(engine.influences().usage().entries > 0);
    CHECK(engine.counters().solves_converged == 2);
}

TEST_CASE("The engine answers for both wheels as for each of them") {
    Engine engine({});
    Observer observer;
    WheelsetState state;
    state.position.y = 2;
    state.velocity = rolling_state().velocity;
    state.Fz_left = 1e4;
    state.Fz_right = 1.2e4;
    WheelsetSetup setup{coarse_setup()};
    const WheelsetSolution both = engine.solve(setup, state, observer);
    CHECK(both.converged());
    WheelRailState alone = state_of_right_wheel(state);
    alone.position.roll = both.roll;
    const Wrench right = engine.solve(coarse_setup(), alone, observer).forces.track;
    for (double Wrench::* force : {&Wrench::Fx, &Wrench::Fy, &Wrench::Fz})
        CHECK_THAT(both.right.forces.track.*force, WithinAbs(right.*force, 2e-6 * right.Fz));
    CHECK(engine.counters().solves_converged == 3);

    setup.left = coarse_setup();
    setup.left->track.gauge = -1;
    CHECK_THROWS_WITH(engine.solve(setup, state, observer), StartsWith("left.track.gauge "));
    setup.left.reset();
    setup.setup.track.gauge = -1;
    CHECK_THROWS_WITH(engine.solve(setup, state, observer), StartsWith("setup.track.gauge "));
    state.left_rail.y = 1e9;
    CHECK_THROWS_WITH(engine.solve(setup, state, observer), StartsWith("state.left_rail.y "));
}

TEST_CASE("Fields are named as in the request") {
    Engine engine({});
    Observer observer;
    WheelRailSetup setup = coarse_setup();
    WheelRailState state = rolling_state();
    const auto refusal = [&] {
        try {
            static_cast<void>(engine.solve(setup, state, observer));
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string("taken");
    };
    SECTION("of the set-up") {
        setup.rail.shape = ProfilePoints{{{0, 0}}};
        CHECK_THAT(refusal(), StartsWith("setup.rail.points "));
    }
    SECTION("of bodies that are no half-spaces") {
        Ics ics;
        ics.source = IcSource::fem;
        setup.bodies.lower.ics = ics;
        CHECK_THAT(refusal(), StartsWith("setup.bodies.lower is not a half-space"));
    }
    SECTION("of the state") {
        state.rail.y = 1e9;
        CHECK_THAT(refusal(), StartsWith("state.rail.y "));
    }
    SECTION("of a height within the rail") {
        state.Fz.reset();
        state.position.z = 20;
        CHECK_THAT(refusal(), StartsWith("state.position.z "));
    }
    SECTION("of a model without spin") {
        setup.model = Model::hertz;
        CHECK_THAT(refusal(), StartsWith("setup.model is hertz"));
    }
}

TEST_CASE("A patch of more elements than are allowed is refused before it is solved") {
    EngineSettings settings;
    settings.most_patch_elements = 50;
    Engine engine(settings);
    Observer observer;
    try {
        static_cast<void>(engine.solve(coarse_setup(), rolling_state(), observer));
        FAIL("It was solved.");
    } catch (const StatusError& error) {
        CHECK(error.status().reason == reason::limit_exceeded);
        CHECK_THAT(error.status().message, StartsWith("setup.dx and dy result in a patch of "));
    }
}

TEST_CASE("Positions are searched one by one, and a bad one is named") {
    Engine engine({});
    Observer observer;
    std::vector<WheelRailState> states(3, rolling_state());
    states[1].position.y = 2;
    const auto geometries = engine.locate(coarse_setup(), states, observer);
    REQUIRE(geometries.size() == 3);
    CHECK(geometries[0].places[0].reference == geometries[2].places[0].reference);
    CHECK(geometries[1].places[0].reference.y != geometries[0].places[0].reference.y);
    states[1].position.roll = 2;
    try {
        static_cast<void>(engine.locate(coarse_setup(), states, observer));
        FAIL("It was taken.");
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "states[1].position.roll");
    }
}

TEST_CASE("A search ends when it is cancelled") {
    struct Impatient final : Observer {
        bool cancelled() const override { return true; }
    } observer;
    Engine engine({});
    const std::vector<WheelRailState> states(3, rolling_state());
    CHECK_THROWS_AS(engine.locate(coarse_setup(), states, observer), Cancelled);
}

TEST_CASE("Operators of rotated half-spaces are cached for positions with the same rows") {
    Engine engine({});
    WheelRailSetup setup = coarse_setup();
    setup.conformal = Conformal::rotated;
    WheelRailState state = rolling_state();
    state.position.y = 5;
    Observer observer;
    const WheelRailSolution first = engine.solve(setup, state, observer);
    REQUIRE(first.patches.size() > 0);
    REQUIRE_FALSE(first.patches[0].place.rows.empty());
    CHECK(engine.solve(setup, state, observer).forces.track == first.forces.track);
    state.position.z = first.z;
    state.Fz.reset();
    const Wrench here = engine.solve(setup, state, observer).forces.track;
    const std::size_t kept = engine.influences().usage().entries;
    CHECK(kept > 0);
    state.velocity.y = 10;
    CHECK(engine.solve(setup, state, observer).forces.track != here);
    CHECK(engine.influences().usage().entries == kept);
    setup.bodies.upper.material.G *= 2;
    static_cast<void>(engine.solve(setup, state, observer));
    const std::size_t of_both = engine.influences().usage().entries;
    CHECK(of_both > kept);
    state.position.y = 5.5;
    static_cast<void>(engine.solve(setup, state, observer));
    CHECK(engine.influences().usage().entries > of_both);
}

TEST_CASE("A state that its set-up does not allow is refused before profiles are read") {
    Engine engine({});
    WheelRailSetup setup = coarse_setup();
    setup.friction.reset();
    setup.rail.shape = ProfileFile{"rail.prr", "this is no profile"};
    WheelRailState state = rolling_state();
    state.Fx = 100;
    Observer observer;
    CHECK_THROWS_WITH(engine.solve(setup, state, observer), StartsWith("state.Fx requires friction"));
}

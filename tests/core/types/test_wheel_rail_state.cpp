#include <catch2/catch_test_macros.hpp>
#include <functional>
#include <string>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"

using namespace contactd;

namespace {

std::string refused_field(const WheelRailSetup& setup, const WheelRailState& state) {
    try {
        validate(setup, state);
    } catch (const InvalidArgument& error) {
        return error.field();
    }
    return "";
}

WheelRailState rolling_state() {
    WheelRailState state;
    state.Fz = 1e4;
    state.velocity.x = 2000;
    state.velocity.pitch = -2000 / 460.0;
    return state;
}

}  // namespace

TEST_CASE("A state is refused where its set-up does not allow it") {
    WheelRailSetup setup;
    setup.friction.reset();
    WheelRailState state = rolling_state();
    CHECK(refused_field(setup, state).empty());
    state.Fx = 100;
    CHECK(refused_field(setup, state) == "Fx");
    setup.friction.emplace();
    CHECK(refused_field(setup, state).empty());
    state.rail.Fy = 100;
    CHECK(refused_field(setup, state) == "rail.Fy");
    setup.track.springs = RailSprings{.y = 1e5, .z = {}};
    CHECK(refused_field(setup, state).empty());
    state.rail.Fz = 100;
    CHECK(refused_field(setup, state) == "rail.Fz");
}

TEST_CASE("Models and answers of steady rolling refuse other motions") {
    WheelRailState state = rolling_state();
    state.motion = WheelRailMotion::transient_rolling;
    state.time_step = 1e-3;
    CHECK(refused_field({}, state).empty());
    const std::function<void(WheelRailSetup&)> steady_only[] = {
        [](WheelRailSetup& setup) { setup.model = Model::fastsim; },
        [](WheelRailSetup& setup) { setup.temperature.emplace(); },
        [](WheelRailSetup& setup) { setup.fatigue.emplace(); },
        [](WheelRailSetup& setup) { setup.wear.emplace(); },
    };
    for (const auto& give : steady_only) {
        WheelRailSetup setup;
        give(setup);
        CHECK(refused_field(setup, state) == "motion");
        CHECK(refused_field(setup, rolling_state()).empty());
    }
}

// Cases that the tests of a wheel on a rail share.
#pragma once

#include "contactd/solve_wheel_rail.hpp"

namespace contactd::test {

inline WheelRailSolution solve(const WheelRailSetup& setup, const WheelRailState& state) {
    Observer observer;
    return solve_wheel_rail(setup, state, observer);
}

/// By Hertz's theory, without friction.
inline WheelRailSetup frictionless_hertz() {
    WheelRailSetup setup;
    setup.model = Model::hertz;
    setup.friction.reset();
    return setup;
}

/// Under 80 kN.
inline WheelRailState loaded_at(double y = 0) {
    WheelRailState state;
    state.position.y = y;
    state.Fz = 80e3;
    return state;
}

/// A cylindrical wheel of 450 mm on a rail with one radius, without friction.
inline WheelRailSetup cylinder_on_arc(double radius) {
    WheelRailSetup setup;
    setup.wheel.shape = ConeProfile{0, -40, 40};
    setup.rail.shape = ArcProfile{radius, 0, -30, 30};
    setup.track.rail_origin = ProfilePoint{750, 0};
    setup.wheelset = {1360, -70, 450};
    setup.friction.reset();
    return setup;
}

}  // namespace contactd::test

// Tests heights at which a wheel carries its load if forces jump with the height.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinRel;

TEST_CASE("Penetration models bring the load where another element becomes the deepest one") {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.4;
    setup.friction.reset();
    for (const NormalModel model : {NormalModel::kpec, NormalModel::kp}) {
        setup.normal_model = model;
        const WheelRailContact contact(setup);
        Observer observer;
        for (double y = 2; y < 6.5; y += 0.05) {
            WheelRailState state;
            state.position.y = y;
            state.Fz = 50e3;
            const WheelRailSolution found = contact.solve(state, observer);
            CHECK(found.converged());
            CHECK_THAT(found.forces.track.Fz, WithinRel(50e3, 1e-6));
            // At adjacent heights the force is smaller, and larger.
            state.Fz.reset();
            state.position.z = found.z - 1e-6;
            CHECK(contact.solve(state, observer).forces.track.Fz < 50e3);
            state.position.z = found.z + 1e-6;
            CHECK(contact.solve(state, observer).forces.track.Fz > 50e3);
        }
    }
}

TEST_CASE("Penetration models on coarse elements carry every load, also where the force jumps by much") {
    Observer observer;
    int jumps = 0;
    for (const double size : {0.8, 1.3})
        for (const NormalModel model : {NormalModel::kpec, NormalModel::kp, NormalModel::analyn}) {
            WheelRailSetup setup;
            setup.dx = setup.dy = size;
            setup.friction.reset();
            setup.normal_model = model;
            const WheelRailContact contact(setup);
            for (const double Fz : {5e3, 150e3})
                for (double y = 0; y < 8; y += 0.45) {
                    WheelRailState state;
                    state.position.y = y;
                    state.position.yaw = 0.01;
                    state.Fz = Fz;
                    const WheelRailSolution found = contact.solve(state, observer);
                    CAPTURE(size, static_cast<int>(model), Fz, y);
                    CHECK(found.converged());
                    CHECK_THAT(found.forces.track.Fz, WithinRel(Fz, 1e-6));
                    if (std::ranges::none_of(found.warnings, [](const std::string& warning) {
                            return warning.starts_with("The vertical force jumps from ");
                        }))
                        continue;
                    ++jumps;
                    state.Fz.reset();
                    for (const double side : {-1, 1}) {
                        state.position.z = found.z + side * 1e-6;
                        const double beside = contact.solve(state, observer).forces.track.Fz;
                        CHECK(side * (beside - Fz) > 0.01 * Fz);
                    }
                }
        }
    CHECK(jumps > 0);
}

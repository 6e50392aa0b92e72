// Compares gradients by forces with differences, and with solves at a given force.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "geometry/distance/heights.hpp"
#include "geometry/position.hpp"
#include "wheel_rail/force_gradient.hpp"
#include "wheel_rail/mirror.hpp"
#include "wheel_rail/resultants.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double product(const Wrench& a, const Wrench& b) {
    return a.Fx * b.Fx + a.Fy * b.Fy + a.Fz * b.Fz + a.Mx * b.Mx + a.My * b.My + a.Mz * b.Mz;
}

Wrench track_forces(const ContactReference& reference, const Forces& forces) {
    ContactPlace place;
    place.reference = reference;
    ContactSolution solution;
    solution.forces = forces;
    return resultants(place, solution, true, {{}, SlopeForces::none}, {}, {}).track;
}

}  // namespace

TEST_CASE("The gradient by the forces of a patch and its plane agrees with differences") {
    const ContactReference reference{2, 750, 3, -0.3};
    const Forces forces{80e3, 12e3, -7e3, 4e4};
    const Wrench by_track{0.3, -0.7, 1.1, 2e-3, -4e-3, 1e-3};
    const ByPatchForces by = by_patch_forces(reference, track_forces(reference, forces), by_track);
    const auto value = [&](const ContactReference& at, const Forces& of) {
        return product(by_track, track_forces(at, of));
    };
    for (double ContactReference::* of :
         {&ContactReference::x, &ContactReference::y, &ContactReference::z, &ContactReference::angle}) {
        ContactReference more = reference, less = reference;
        more.*of += 1e-4;
        less.*of -= 1e-4;
        CHECK_THAT(by.reference.*of, WithinAbs((value(more, forces) - value(less, forces)) / 2e-4, 1e-3));
    }
    CHECK_THAT(product(by.contact, {forces.Fx, forces.Fy, forces.Fn, 0, 0, forces.Mz}),
               WithinRel(value(reference, forces), 1e-12));
}

TEST_CASE("A gradient at a given force leaves out what the height compensates") {
    geometry::WheelGradient by{{{0, 2}}, {{0, 3}}, {}}, by_force{{{0, 4}}, {{0, 8}}, {}};
    by.state.position.z = 5;
    by.state.velocity.x = 1;
    by_force.state.position.z = 10;
    by_force.state.velocity.x = 6;
    const geometry::WheelGradient held = at_given_force(by, by_force);
    CHECK(held.wheel[0].z == 0);
    CHECK(held.rail[0].z == -1);
    CHECK(held.state.velocity.x == -2);
    CHECK(held.state.position.z == 0);
    CHECK(held.state.Fz == 0.5);
    by_force.state.position.z = 0;
    CHECK_THROWS_AS(at_given_force(by, by_force), InvalidArgument);
}

TEST_CASE("Mirrored gradients are those of a left wheel") {
    WheelRailSetup setup;
    setup.side = Side::left;
    WheelRailState state;
    state.position.y = -3;
    state.position.yaw = 0.001;
    const geometry::Profiles profiles = geometry::make_profiles(setup);
    const WheelRailState right = mirrored(state);
    const geometry::Position position(setup, profiles, right);
    const double z = position.clearance(0) + 0.07;
    geometry::CandidatePatch found = position.candidates(z).at(0);
    REQUIRE(position.measure(found, z));
    const geometry::WheelSurface wheel = position.wheel(z);
    geometry::PlaceGradient gradient(setup, right, wheel, position.rail(), geometry::GradientMode::exact);
    geometry::ByPlace by{.distance = std::vector<double>(found.gap.size(), 0)};
    by.reference.y = -1;  // that of a left wheel has the other sign
    gradient.add(found.place, by);
    const WheelRailState gradient_of_left = mirrored(gradient.result().state);
    state.position.z = z;
    const WheelRailContact contact(setup);
    const auto y = [&](double WheelsetPosition::* of, double step) {
        WheelRailState changed = state;
        changed.position.*of += step;
        return contact.locate(changed).places.at(0).reference.y;
    };
    for (double WheelsetPosition::* of : {&WheelsetPosition::y, &WheelsetPosition::yaw, &WheelsetPosition::roll}) {
        const double step = of == &WheelsetPosition::y ? 1e-5 : 1e-8;
        const double difference = (y(of, step) - y(of, -step)) / (2 * step);
        CHECK_THAT(gradient_of_left.position.*of,
                   WithinAbs(difference, 1e-5 * std::abs(difference) + 1e-6 / step * 1e-4));
    }
}

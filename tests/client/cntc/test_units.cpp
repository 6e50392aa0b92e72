// The three systems of units against each other.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "client/cntc/calls.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

struct System {
    int code;
    double mm;    ///< per unit of length
    double body;  ///< sign of forces
};

/// The same problem in each of them: option 0 by semi-axes, 1 by curvatures and penetration, 2 by elements.
Case problem(const System& system, int option, int tangential) {
    const double mm = system.mm;
    Case contact(1);
    contact.flag(1933, system.code);
    contact.flag(1972, tangential);
    contact.material(0.28, 0.28, 82000 * mm * mm, 82000 * mm * mm);
    contact.friction(4, {0.2, 0.1, 50 / mm, 0, 1 / mm, 0, 1 / mm});
    contact.velocity(10000 / mm);
    contact.time_step(1e-3);
    contact.rolling_step(0, 0.5 / mm);
    contact.normal_force(50000);
    if (option == 0) contact.hertz(-3, {25, 25, 6 / mm, 4 / mm, 1.1});
    if (option == 1) {
        contact.hertz(-1, {25, 25, 1e-3 * mm, 2e-3 * mm, 1.1});
        contact.penetration(0.06 / mm);
    }
    if (option == 2) {
        contact.potential(3, {25, 20, -8.4 / mm, -7.2 / mm, 0.7 / mm, 0.8 / mm});
        contact.distance(1, {1e-3 * mm, 2e-4 * mm, 2e-3 * mm, 1e-4, -1e-4, 0.01 / mm});
    }
    contact.extra_slip(Values(static_cast<std::size_t>(contact.elements()), tangential == 1 ? 1e-4 / mm : 1e-4),
                       Values(static_cast<std::size_t>(contact.elements()), 0));
    if (tangential == 1)
        contact.creepages(0.01 / mm, -0.004 / mm, 1e-3);
    else
        contact.creepages(0.002, 0.001, 1e-4 * mm);
    return contact;
}

void check_scaled(const Values& found, double unit, const Values& expected) {
    double largest = 0, difference = 0;
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        largest = std::max(largest, std::abs(expected[i]));
        difference = std::max(difference, std::abs(found[i] * unit - expected[i]));
    }
    CHECK(largest > 0);
    CHECK(difference <= 1e-5 * largest);
}

}  // namespace

TEST_CASE("the systems of units have the same answers") {
    const System si = GENERATE(System{1935, 1000, -1}, System{1936, 1000, 1});
    const int option = GENERATE(0, 1, 2), tangential = GENERATE(1, 2, 3);
    CAPTURE(si.code, option, tangential);
    const double mm = si.mm, stress = 1 / (mm * mm);
    struct Answer {
        ContactForces forces;
        double pmax, ptmax, pen, area;
        Tractions tractions;
        Values h, mu, ux, uy, un, sx, sy, wx, wy, hertz, potential;
    };
    const auto answer = [&](const System& system) {
        Case contact = problem(system, option, tangential);
        REQUIRE(contact.calculate() == 0);
        return Answer{contact.forces(),        contact.max_pressure(),
                      contact.max_traction(),  contact.found_penetration(),
                      contact.areas().contact, contact.tractions(),
                      contact.field(1),        contact.field(2),
                      contact.field(7),        contact.field(8),
                      contact.field(9),        contact.field(15),
                      contact.field(16),       contact.field(22),
                      contact.field(23),       option < 2 ? contact.hertz_back() : Values{},
                      contact.potential_back()};
    };
    const Answer in_mm = answer({1934, 1, 1});

    const Answer in_m = answer(si);

    CHECK_THAT(in_m.forces.fn, WithinRel(in_mm.forces.fn, 1e-7));
    CHECK_THAT(si.body * in_m.forces.fx, WithinRel(in_mm.forces.fx, 1e-5));
    CHECK_THAT(si.body * in_m.forces.fy, WithinRel(in_mm.forces.fy, 1e-5));
    CHECK_THAT(si.body * in_m.forces.mz * mm, WithinAbs(in_mm.forces.mz, 1e-5 * 15000 * 5));
    CHECK_THAT(in_m.pmax * stress, WithinRel(in_mm.pmax, 1e-7));
    CHECK_THAT(in_m.ptmax * stress, WithinRel(in_mm.ptmax, 1e-5));
    CHECK_THAT(in_m.pen * mm, WithinRel(in_mm.pen, 1e-7));
    CHECK_THAT(in_m.area * mm * mm, WithinRel(in_mm.area, 1e-12));
    check_scaled(in_m.tractions.pn, stress, in_mm.tractions.pn);
    check_scaled(in_m.tractions.px, si.body * stress, in_mm.tractions.px);
    check_scaled(in_m.tractions.py, si.body * stress, in_mm.tractions.py);
    check_scaled(in_m.h, mm, in_mm.h);
    check_scaled(in_m.mu, 1, in_mm.mu);
    check_scaled(in_m.ux, mm, in_mm.ux);  // of body 1 less body 2 in all of them
    check_scaled(in_m.uy, mm, in_mm.uy);
    check_scaled(in_m.un, mm, in_mm.un);
    check_scaled(in_m.sx, si.body, in_mm.sx);  // of shifts in mm
    check_scaled(in_m.sy, si.body, in_mm.sy);
    check_scaled(in_m.wx, si.body, in_mm.wx);
    check_scaled(in_m.wy, si.body, in_mm.wy);
    if (option < 2) {
        const Values units{1 / mm, 1 / mm, mm, mm, mm, mm, 1, mm, mm, 1};
        for (std::size_t i = 0; i < units.size(); ++i)
            CHECK_THAT(in_m.hertz[i] * units[i], WithinRel(in_mm.hertz[i], 1e-10));
    }
    for (std::size_t i = 0; i < 6; ++i)
        CHECK_THAT(in_m.potential[i] * (i < 2 ? 1 : mm), WithinRel(in_mm.potential[i], 1e-10));
}

TEST_CASE("a force given is that on body 1 in all systems of units") {
    for (const System& system : {System{1934, 1, 1}, System{1935, 1000, -1}, System{1936, 1000, 1}}) {
        Case contact = problem(system, 0, 3);
        contact.coulomb(0.3);
        contact.flag(1974, 2);
        contact.tangential_forces(0.3, -0.2);

        REQUIRE(contact.calculate() == 0);

        CHECK_THAT(contact.forces().fx, WithinRel(system.body * 0.3 * 0.3 * 50000, 1e-5));
        CHECK_THAT(contact.forces().fy, WithinRel(-system.body * 0.2 * 0.3 * 50000, 1e-5));
        // On body 1 a force along +x comes from a creepage of that body backwards.
        CHECK(contact.found_creepages().vx * system.body < 0);
    }
}

TEST_CASE("a force beyond friction is that of full slip") {
    Case contact = wheel(1);
    contact.flag(1974, 1);
    contact.tangential_forces(-3, 0);
    contact.creepages(0, 0, 0);
    CHECK(contact.calculate() == 0);
    CHECK_THAT(contact.forces().fx, WithinRel(-0.3 * 50000, 1e-4));
}

TEST_CASE("before anything is set there are the program's defaults") {
    Case contact(1);
    CHECK(contact.get_flag(1972) == 3);
    CHECK(contact.get_flag(1933) == 1934);
    contact.coulomb(0.3);
    const auto [vx, vy, phi] = contact.found_creepages();
    CHECK(Values{vx, vy, phi} == Values{0, 0, 0});
    double velocity = 0;
    cntc_getreferencevelocity(contact.ire(), contact.icp(), &velocity);
    CHECK(velocity == 1000);
}

TEST_CASE("what was set is given back in the units of now") {
    Case contact = problem({1934, 1, 1}, 0, 3);
    const auto parameters = [&](int task, int length) {
        Values values(static_cast<std::size_t>(length));
        cntc_getparameters(contact.ire(), contact.icp(), &task, &length, values.data());
        return values;
    };
    CHECK(parameters(2, 4) == Values{0.28, 0.28, 82000, 82000});
    CHECK(parameters(3, 7) == Values{0.2, 0.1, 50, 0, 1, 0, 1});

    contact.flag(1933, 1935);

    const Values material = parameters(2, 4), friction = parameters(3, 7);
    const Values material_in_m{0.28, 0.28, 82e9, 82e9}, friction_in_m{0.2, 0.1, 0.05, 0, 0.001, 0, 0.001};
    for (std::size_t i = 0; i < 4; ++i) CHECK_THAT(material[i], WithinRel(material_in_m[i], 1e-12));
    for (std::size_t i = 0; i < 7; ++i) CHECK_THAT(friction[i], WithinAbs(friction_in_m[i], 1e-12));
    CHECK_THAT(contact.found_creepages().phi, WithinRel(-0.1, 1e-12));
    double velocity = 0;
    cntc_getreferencevelocity(contact.ire(), contact.icp(), &velocity);
    CHECK_THAT(velocity, WithinRel(10.0, 1e-12));
    CHECK(contact.get_flag(1933) == 1935);
    CHECK(contact.get_flag(1976) == 4);
}

// Derivatives of the forces.
#include <algorithm>
#include <array>
#include <cmath>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "client/cntc/rail_calls.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Forces as sensitivities have them.
std::array<double, 4> outputs(Case& contact) {
    REQUIRE(contact.calculate() == 0);
    const ContactForces f = contact.forces();
    return {f.fn, f.fx / (0.3 * f.fn), f.fy / (0.3 * f.fn), f.mz};
}

std::size_t at(int out, int in) {
    return static_cast<std::size_t>(4 * in + out);
}

/// One of the published positions, from 1; in the first most of the contact adheres.
const contactd::test::ManchesterCase& published(contactd::Side side, int number) {
    return *std::ranges::find_if(contactd::test::manchester_cases, [&](const contactd::test::ManchesterCase& known) {
        return known.side == side && known.number == number;
    });
}

}  // namespace

TEST_CASE("sensitivities are how forces change with what moves the bodies") {
    const int tangential = GENERATE(1, 3);
    const int units = GENERATE(1934, 1935, 1936);
    CAPTURE(tangential, units);
    const double m = units == 1934 ? 1 : 1000;
    const auto contact_at = [&](int ire, std::array<double, 4> inputs) {
        Case contact(ire);
        contact.flag(1933, units);
        contact.flag(1972, tangential);
        contact.material(0.28, 0.28, 82000 * m * m, 82000 * m * m);
        contact.coulomb(0.3);
        contact.potential(1, {25, 25, -6.6 / m, -4.4 / m, 13.2 / 25 / m, 8.8 / 25 / m});
        contact.distance(1, {8e-4 * m, 0, 1.5e-3 * m, 0, 0, 0});
        contact.tolerance(1e-10);
        contact.penetration(inputs[0]);
        contact.creepages(inputs[1], inputs[2], inputs[3]);
        return contact;
    };
    const bool rolls = tangential == 3;
    const std::array inputs{0.045 / m, rolls ? 0.001 : 0.006 / m, rolls ? 5e-4 : 0.003 / m, rolls ? 1e-4 * m : 1e-3};
    Case contact = contact_at(1, inputs);
    contact.flag(1988, 3);
    const auto here = outputs(contact);
    REQUIRE(std::abs(here[1]) > 0.1);
    REQUIRE(std::abs(here[1]) < 0.9);

    const Values found = contact.sensitivities();

    for (int in = 0; in < 4; ++in) {
        const double step = 2e-3 * inputs[static_cast<std::size_t>(in)];  // twenty times theirs
        auto more = inputs, less = inputs;
        more[static_cast<std::size_t>(in)] += step;
        less[static_cast<std::size_t>(in)] -= step;
        Case ahead = contact_at(2, more), behind = contact_at(3, less);
        const auto up = outputs(ahead), down = outputs(behind);
        for (int out = 0; out < 4; ++out) {
            const auto o = static_cast<std::size_t>(out);
            // Those of the force on body 1 by the motion as it is set, in all systems of units.
            const double on_body_1 = out > 0 && units == 1935 ? -1 : 1;
            const double expected = on_body_1 * (up[o] - down[o]) / (2 * step);
            const double scale = out == 0 ? here[0] : out == 3 ? 0.3 * here[0] * 5 / m : 1;
            const double unit = inputs[static_cast<std::size_t>(in)];
            CAPTURE(out, in);
            CHECK_THAT(found[at(out, in)] * unit, WithinAbs(expected * unit, 1e-2 * scale));
        }
    }
    // More creepage, more force against it; deeper, more normal force, and more moment.
    CHECK(found[at(0, 0)] > 0);
    CHECK(found[at(1, 1)] < 0);
    CHECK(found[at(2, 2)] < 0);
    CHECK(found[at(0, 1)] == 0);
    CHECK(found[at(3, 0)] != 0);
}

TEST_CASE("sensitivities are the same whichever is prescribed") {
    Case contact = wheel(1);
    contact.flag(1988, 3);
    contact.tolerance(1e-9);
    REQUIRE(contact.calculate() == 0);
    const Values by_force = contact.sensitivities();
    const ContactForces forces = contact.forces();
    contact.hertz(-1, {25, 25, contact.hertz_back()[0], contact.hertz_back()[1], 1.1});
    contact.flag(1974, 2);
    contact.tangential_forces(forces.fx / 15000, forces.fy / 15000);
    REQUIRE(contact.calculate() == 0);

    const Values found = contact.sensitivities();

    for (std::size_t i = 0; i < 16; ++i) {
        if (i == at(0, 1) || i == at(0, 2) || i == at(0, 3)) continue;
        CHECK_THAT(found[i], WithinRel(by_force[i], 1e-3));
    }
}

TEST_CASE("the normal problem alone has one sensitivity, Hertz's") {
    Case contact = wheel(1);
    contact.flag(1988, 2);
    contact.hertz(-3, {75, 75, 6, 4, 1.1});
    REQUIRE(contact.calculate() == 0);

    const Values found = contact.sensitivities();

    // Elements that enter the contact make steps of its force: of an element out of 75, at the least.
    CHECK_THAT(found[0], WithinRel(1.5 * 50000 / contact.found_penetration(), 1.0 / 75));
    for (std::size_t i = 1; i < 16; ++i) CHECK(std::isnan(found[i]));
    CHECK(contact.sensitivities(1, 1) == Values{found[0]});
}

TEST_CASE("sensitivities that were not asked for are no numbers") {
    Case contact = wheel(1);
    REQUIRE(contact.calculate() == 0);

    for (const double value : contact.sensitivities()) CHECK(std::isnan(value));

    CHECK(last_code() == -39);
    for (const double value : contact.sensitivities(5, 4)) CHECK(std::isnan(value));
}

TEST_CASE("sensitivities of a patch on a rail are how its forces change with its creepages") {
    const auto side = GENERATE(contactd::Side::left, contactd::Side::right);
    const int number = GENERATE(1, 11);  // where regions share their displacements in part, too
    CAPTURE(side, number);
    RailCase rail(1);
    const auto solved = [&](double more_pitch, int sensitivities, double Fz = 10000) {
        rail = manchester_wheel(1, side);
        rail.whole.flag(1988, sensitivities);
        contactd::test::ManchesterCase known = published(side, number);
        known.pitch_rate *= 1 + more_pitch;
        place(rail, known);
        rail.vertical_force(Fz);
        REQUIRE(rail.whole.calculate() == 0);
        return rail.patch(1);
    };
    Case patch = solved(0, 3);
    const Values found = patch.sensitivities();
    const ContactForces forces = patch.forces();
    const double penetration = patch.found_penetration();
    Case heavier = solved(0, 0, 10100);
    if (number == 1)  // with regions, the shares change with the load, and the reference moves
        CHECK_THAT(found[0],
                   WithinRel((heavier.forces().fn - forces.fn) / (heavier.found_penetration() - penetration), 0.02));

    Case ahead = solved(1e-5, 0);
    const ContactForces more = ahead.forces();
    const auto after = ahead.found_creepages();
    Case behind = solved(-1e-5, 0);
    const ContactForces less = behind.forces();
    const auto before = behind.found_creepages();

    const auto expected = [&](int out) {
        return found[at(out, 1)] * (after.vx - before.vx) + found[at(out, 2)] * (after.vy - before.vy) +
               found[at(out, 3)] * (after.phi - before.phi);
    };
    const double change = (more.fx / more.fn - less.fx / less.fn) / 0.3;
    REQUIRE(std::abs(change) > 1e-3);
    CHECK_THAT(expected(1), WithinRel(change, 0.02));
    CHECK_THAT(expected(2), WithinAbs((more.fy / more.fn - less.fy / less.fn) / 0.3, 0.02 * std::abs(change)));
}

TEST_CASE("a patch on a rail that is more than its contact problem says so when sensitivities are read") {
    RailCase rail = manchester_wheel(1, contactd::Side::right);
    rail.whole.flag(1988, 3);
    place(rail, published(contactd::Side::right, 1));
    SECTION("curved") {
        rail.whole.flag(1977, 4);
    }
    SECTION("virtual penetration") {
        rail.whole.flag(1971, 5);
    }
    REQUIRE(rail.whole.calculate() == 0);
    Case patch = rail.patch(1);
    for (const double value : patch.sensitivities()) CHECK(std::isnan(value));
    CHECK(last_code() == -39);
    CHECK(patch.forces().fn > 0);
}

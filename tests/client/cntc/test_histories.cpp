// Cases that follow each other.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "client/cntc/calls.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Case shifted(int ire) {
    Case contact = wheel(ire);
    contact.flag(1972, 1);
    contact.flag(1970, 0);
    return contact;
}

}  // namespace

TEST_CASE("shifts add up: there and back leaves friction on the other side") {
    Case contact = shifted(1);
    contact.creepages(0.01, 0, 0);
    REQUIRE(contact.calculate() == 0);
    const double there = contact.forces().fx;
    contact.creepages(-0.01, 0, 0);
    REQUIRE(contact.calculate() == 0);
    const double back = contact.forces().fx;

    contact.flag(1970, 2);
    REQUIRE(contact.calculate() == 0);

    CHECK(there < 0);
    CHECK(back > 0);
    CHECK(back < -0.5 * there);                                // some of the way there is kept
    CHECK_THAT(contact.forces().fx, WithinRel(-there, 1e-5));  // anew: the same the other way
}

TEST_CASE("a shift in steps of a straight way ends where one step ends") {
    Case contact = shifted(1);
    for (int step = 0; step < 3; ++step) {
        contact.creepages(0.004, 0, 0);
        REQUIRE(contact.calculate() == 0);
    }
    const ContactForces in_steps = contact.forces();
    contact.flag(1970, 2);
    contact.creepages(0.012, 0, 0);

    REQUIRE(contact.calculate() == 0);

    CHECK_THAT(contact.forces().fx, WithinRel(in_steps.fx, 1e-3));
}

TEST_CASE("a transient marches to the steady state") {
    Case contact = wheel(1);
    REQUIRE(contact.calculate() == 0);
    const ContactForces steady = contact.forces();
    const double dx = contact.element_size()[0];
    contact.flag(1972, 2);
    contact.rolling_step(0, dx);
    contact.flag(1970, 2);
    REQUIRE(contact.calculate() == 0);
    CHECK(std::abs(contact.forces().fx) < 0.5 * std::abs(steady.fx));  // the first step from rest
    contact.flag(1970, 0);

    for (int step = 0; step < 150; ++step) REQUIRE(contact.calculate() == 0);

    CHECK_THAT(contact.forces().fx, WithinAbs(steady.fx, 0.1));
    CHECK_THAT(contact.forces().fy, WithinAbs(steady.fy, 0.1));
}

TEST_CASE("a step that goes on with more elements elsewhere is that on all elements from the start") {
    const auto on_quadratic = [](int ire) {
        Case contact = shifted(ire);
        contact.distance(1, {1e-3, 0, 2e-3, 0, 0, 0});
        contact.normal_force(5000);
        return contact;
    };
    const Values few{25, 25, -5, -5, 0.4, 0.4}, many{31, 29, -5.8, -5.4, 0.4, 0.4};
    Case moved = on_quadratic(1), always = on_quadratic(2);
    always.potential(1, many);
    for (const double shift : {0.006, -0.003}) {
        moved.potential(1, shift > 0 ? few : Values{31, 29, -5.75, -5.45, 0.4, 0.4});  // near whole elements
        for (Case* contact : {&moved, &always}) {
            contact->creepages(shift, 0.001, 0);
            REQUIRE(contact->calculate() == 0);
        }
    }

    CHECK_THAT(moved.potential_back()[2], WithinAbs(-5.6, 1e-12));
    CHECK_THAT(moved.potential_back()[3], WithinAbs(-5.2, 1e-12));
    CHECK_THAT(moved.forces().fx, WithinRel(always.forces().fx, 1e-5));
    CHECK_THAT(moved.forces().fy, WithinRel(always.forces().fy, 1e-5));
}

TEST_CASE("Hertz's elements keep their size in a step that goes on under another load") {
    Case contact = shifted(1);
    contact.hertz(-1, {25, 25, 1e-3, 2e-3, 1.3});
    contact.creepages(0.005, 0, 0);
    REQUIRE(contact.calculate() == 0);
    const auto size = contact.element_size();
    contact.normal_force(1.05 * 50000);
    REQUIRE(contact.calculate() == 0);
    CHECK(contact.element_size() == size);
    contact.flag(1970, 2);
    REQUIRE(contact.calculate() == 0);
    CHECK(contact.element_size()[0] > size[0]);
}

TEST_CASE("an estimate from the last case changes no answer") {
    Case contact = wheel(1);
    contact.tolerance(1e-8);
    REQUIRE(contact.calculate() == 0);
    contact.creepages(0.0015, 0.001, 1e-4);
    REQUIRE(contact.calculate() == 0);
    const ContactForces anew = contact.forces();
    contact.creepages(0.002, 0.001, 1e-4);
    REQUIRE(contact.calculate() == 0);
    contact.creepages(0.0015, 0.001, 1e-4);
    contact.flag(1983, 3);

    REQUIRE(contact.calculate() == 0);

    CHECK_THAT(contact.forces().fx, WithinRel(anew.fx, 1e-6));
    CHECK_THAT(contact.forces().fy, WithinRel(anew.fy, 1e-6));
    CHECK(contact.forces() != anew);  // it started elsewhere
}

TEST_CASE("the creepage that a force needs gives that force") {
    Case contact = wheel(1);
    contact.flag(1974, 2);
    contact.tangential_forces(-0.4, 0.2);
    REQUIRE(contact.calculate() == 0);
    const Creepages found = contact.found_creepages();
    contact.flag(1974, 0);
    contact.creepages(found.vx, found.vy, found.phi);

    REQUIRE(contact.calculate() == 0);

    CHECK_THAT(contact.forces().fx, WithinRel(-0.4 * 15000, 1e-4));
    CHECK_THAT(contact.forces().fy, WithinRel(0.2 * 15000, 1e-4));
}

TEST_CASE("forces are relative to the normal force that a penetration makes") {
    Case contact = wheel(1);
    contact.penetration(0.06);
    contact.flag(1974, 2);
    contact.tangential_forces(-0.4, 0.2);

    REQUIRE(contact.calculate() == 0);

    const ContactForces forces = contact.forces();
    CHECK_THAT(forces.fx, WithinRel(-0.4 * 0.3 * forces.fn, 1e-5));
}

TEST_CASE("a check solves nothing and keeps the history") {
    Case contact = shifted(1);
    contact.creepages(0.01, 0, 0);
    REQUIRE(contact.calculate() == 0);
    const double there = contact.forces().fx;
    contact.creepages(0, 0, 0);
    contact.flag(1986, 2);
    CHECK(contact.calculate() == 0);
    CHECK(std::isnan(contact.forces().fx));
    contact.flag(1986, 0);

    REQUIRE(contact.calculate() == 0);

    CHECK_THAT(contact.forces().fx, WithinRel(there, 1e-5));
}

TEST_CASE("contact problems of a result element are independent, and all of them are set by -1") {
    Case first = wheel(1), second = wheel(1, 2, false), all(1, -1, false);
    second.creepages(-0.002, 0, 0);
    REQUIRE(all.calculate() == 0);
    CHECK(first.forces().fx < 0);
    CHECK(second.forces().fx > 0);

    all.normal_force(60000);
    Case third(1, 3, false);
    third.hertz(-3, {25, 25, 6, 4, 1.1});  // made now: with what was set of all

    REQUIRE(all.calculate() == -39);  // the third has no material
    CHECK_THAT(first.forces().fn, WithinRel(60000.0, 1e-7));
    CHECK_THAT(second.forces().fn, WithinRel(60000.0, 1e-7));
    third.material(0.28, 0.28, 82000, 82000);
    third.flag(1972, 0);
    REQUIRE(third.calculate() == 0);
    CHECK_THAT(third.forces().fn, WithinRel(60000.0, 1e-7));
}

TEST_CASE("times add up until they are reset") {
    Case contact = wheel(1);
    double cpu = -1, wall = -1;
    const auto read = [&] { cntc_getcalculationtime(contact.ire(), contact.icp(), &cpu, &wall); };
    read();
    CHECK(cpu == 0);
    REQUIRE(contact.calculate() == 0);
    read();
    CHECK(cpu > 0);
    CHECK(wall > 0);

    cntc_resetcalculationtime(contact.ire(), contact.icp());

    read();
    CHECK(cpu == 0);
    CHECK(wall == 0);
}

// Lines that were published of the CONTACT program.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "client/cntc/calls.hpp"
#include "client/cntc/creep_table.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("steady rolling has the forces that are known of the same elements") {
    Case contact = wheel(1);

    REQUIRE(contact.calculate() == 0);

    const ContactForces forces = contact.forces();
    CHECK_THAT(forces.fx, WithinAbs(-11602.4363, 0.02));
    CHECK_THAT(forces.fy, WithinAbs(-6944.5750, 0.02));
    CHECK_THAT(forces.mz, WithinAbs(-298.8978, 0.05));
    CHECK_THAT(forces.fn, WithinRel(50000.0, 1e-8));
    CHECK_THAT(contact.max_pressure(), WithinRel(994.992217, 1e-7));
    CHECK_THAT(contact.found_penetration(), WithinRel(0.0665015273, 1e-7));
    const auto [dx, dy] = contact.element_size();
    const PatchAreas areas = contact.areas();
    CHECK_THAT(areas.adhesion / (dx * dy), WithinAbs(121, 1e-6));
    CHECK_THAT(areas.slip / (dx * dy), WithinAbs(300, 1e-6));
}

// Numbers of that program have six digits, and its tolerance is 1e-6.
TEST_CASE("a line of the table of creepages is met") {
    CreepTable table(2);
    const CreepLine line = table.solve({0, 0, 0, 5});  // a/b 0.2, no spin, -90 degrees, the sixth size

    CHECK(line.error == 0);
    CHECK_THAT(line.fx, WithinAbs(0, 1e-6));
    CHECK_THAT(line.fy, WithinAbs(0.480018, 2e-6));
    CHECK_THAT(line.mz, WithinAbs(-0.075485, 2e-6));
    CHECK_THAT(line.slip, WithinAbs(31.7, 0.05));
}

TEST_CASE("a curve of traction against creepage is met") {
    const auto [creepage, force] = GENERATE(table<double, double>(
        {{1e-5, -247.001355}, {0.0016, -27574.7638}, {0.0036, -35179.0681}, {0.03, -35210.5191}}));
    Case contact(3);
    contact.material(0.28, 0.28, 82000, 82000);
    contact.coulomb(0.33);
    contact.velocity(10000);
    contact.normal_force(106700);
    contact.hertz(-2, {48, 44, 0.0008, 0.5, 1.1});
    contact.tolerance(1e-9);
    contact.creepages(creepage, 0, 0);

    REQUIRE(contact.calculate() == 0);

    CHECK_THAT(contact.forces().fx, WithinRel(force, 1e-7));
}

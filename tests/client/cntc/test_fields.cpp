// Numbers of the elements, against the laws of contact.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "client/cntc/calls.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double sum(const Values& values) {
    double total = 0;
    for (const double v : values) total += v;
    return total;
}

}  // namespace

TEST_CASE("surfaces meet in contact, and outside displacements are not told") {
    Case contact = wheel(1);
    contact.material(0.28, 0.1, 82000, 41000);  // so that tangential tractions move the surfaces up, too
    REQUIRE(contact.calculate() == 0);
    const Values h = contact.field(1), un = contact.field(9), pn = contact.field(5);
    const double pen = contact.found_penetration();

    for (std::size_t i = 0; i < h.size(); ++i) {
        const double gap = h[i] - pen + un[i];
        if (pn[i] > 0)
            CHECK_THAT(gap, WithinAbs(0, 1e-6 * pen));
        else
            CHECK(un[i] == 0);
    }
}

TEST_CASE("slip is what motion and displacements leave, and friction opposes it") {
    Case contact = wheel(1);
    contact.flag(1972, 1);
    contact.creepages(0.01, -0.004, 1e-3);
    contact.tolerance(1e-8);
    REQUIRE(contact.calculate() == 0);
    const Values wx = contact.field(22), wy = contact.field(23), ux = contact.field(7), uy = contact.field(8);
    const Values sx = contact.field(15), sy = contact.field(16), px = contact.field(3), py = contact.field(4);
    const Values mu = contact.field(2), pn = contact.field(5);
    const std::vector<int> division = contact.division();

    double dissipated = 0;
    int slipping = 0;
    for (std::size_t i = 0; i < pn.size(); ++i) {
        CHECK(mu[i] == 0.3);
        if (division[i] == 0) {
            CHECK(px[i] == 0);
            continue;
        }
        CHECK_THAT(sx[i], WithinAbs(wx[i] + ux[i], 1e-9));
        CHECK_THAT(sy[i], WithinAbs(wy[i] + uy[i], 1e-9));
        if (division[i] == 1) CHECK(std::hypot(sx[i], sy[i]) < 1e-6);
        if (division[i] != 2) continue;
        ++slipping;
        CHECK_THAT(std::hypot(px[i], py[i]), WithinRel(mu[i] * pn[i], 1e-9));
        dissipated -= sx[i] * px[i] + sy[i] * py[i];
    }
    CHECK(slipping > 10);
    CHECK(dissipated > 0);
}

TEST_CASE("rigid slip is that of body 1 over body 2, spin evaluated a sixth of a step ahead") {
    Case contact = wheel(1);
    REQUIRE(contact.calculate() == 0);
    const Values wx = contact.field(22), wy = contact.field(23);
    const auto [dx, dy] = contact.element_size();
    const Values potential = contact.potential_back();

    CHECK_THAT(wx[0], WithinAbs(0.002 - 1e-4 * potential[3], 1e-15));
    CHECK_THAT(wy[0], WithinAbs(0.001 + 1e-4 * (potential[2] + dx / 6), 1e-15));
    CHECK_THAT(wx[25], WithinAbs(wx[0] - 1e-4 * dy, 1e-15));
    CHECK_THAT(wy[1], WithinAbs(wy[0] + 1e-4 * dx, 1e-15));
}

TEST_CASE("friction has fallen where it slips, and tractions are what it allows") {
    const int law = GENERATE(2, 4);
    Case contact = wheel(1);
    contact.velocity(10000);
    contact.friction(law, {0.2, 0.1, 20, 0, 1, 0, 1});
    REQUIRE(contact.calculate() == 0);
    const Values mu = contact.field(2), px = contact.field(3), py = contact.field(4), pn = contact.field(5);
    const std::vector<int> division = contact.division();

    double least = 1;
    for (std::size_t i = 0; i < mu.size(); ++i) {
        CHECK(mu[i] >= 0.2);
        CHECK(mu[i] <= 0.2 + 0.1);
        if (division[i] != 2) continue;
        CHECK_THAT(std::hypot(px[i], py[i]), WithinRel(mu[i] * pn[i], 1e-4));
        least = std::min(least, mu[i]);
    }
    CHECK(least < 0.29);
}

TEST_CASE("forces are sums of tractions, and maxima their largest") {
    Case contact = wheel(1);
    REQUIRE(contact.calculate() == 0);
    const Tractions tractions = contact.tractions();
    const auto [dx, dy] = contact.element_size();
    const ContactForces forces = contact.forces();

    CHECK_THAT(sum(tractions.pn) * dx * dy, WithinRel(forces.fn, 1e-12));
    CHECK_THAT(sum(tractions.px) * dx * dy, WithinRel(forces.fx, 1e-12));
    CHECK_THAT(sum(tractions.py) * dx * dy, WithinRel(forces.fy, 1e-12));
    double largest = 0;
    for (std::size_t i = 0; i < tractions.px.size(); ++i)
        largest = std::max(largest, std::hypot(tractions.px[i], tractions.py[i]));
    CHECK(contact.max_traction() == largest);
    CHECK(contact.max_pressure() == *std::ranges::max_element(tractions.pn));
    CHECK(contact.field(5) == tractions.pn);
}

TEST_CASE("there is no plasticity, heat, or slip without friction: such fields are zero") {
    Case contact = wheel(1);
    contact.flag(1972, 0);
    REQUIRE(contact.calculate() == 0);
    for (const int code : {2, 3, 4, 7, 8, 11, 12, 13, 15, 16, 20, 21, 22, 23}) {
        CAPTURE(code);
        CHECK(contact.field(code) == Values(625, 0.0));
    }
    CHECK(contact.areas().slip == 0);  // as CONTACT prints it: NADH is NCON
    CHECK(contact.areas().adhesion == contact.areas().contact);
}

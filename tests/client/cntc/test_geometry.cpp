// Hertz contacts, potential contacts and undeformed distances, each said in several ways.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>

#include "client/cntc/calls.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

void check_close(const ContactForces& found, const ContactForces& expected, double tolerance) {
    CHECK_THAT(found.fn, WithinRel(expected.fn, tolerance));
    CHECK_THAT(found.fx, WithinRel(expected.fx, tolerance));
    CHECK_THAT(found.fy, WithinRel(expected.fy, tolerance));
}

int at_border(const std::vector<int>& division, int mx, int my) {
    int count = 0;
    for (int iy = 0; iy < my; ++iy)
        for (int ix = 0; ix < mx; ++ix)
            if (ix == 0 || iy == 0 || ix == mx - 1 || iy == my - 1)
                count += division[static_cast<std::size_t>(iy * mx + ix)] != 0;
    return count;
}

}  // namespace

TEST_CASE("a Hertz contact by semi-axes, curvatures, or a ratio is the same") {
    const bool by_force = GENERATE(true, false);
    Case contact = wheel(1);
    if (!by_force) contact.penetration(0.0665);
    REQUIRE(contact.calculate() == 0);
    const ContactForces by_axes = contact.forces();
    const Values hertz = contact.hertz_back();
    const double a1 = hertz[0], b1 = hertz[1];

    contact.hertz(-1, {25, 25, a1, b1, 1.1});
    REQUIRE(contact.calculate() == 0);
    check_close(contact.forces(), by_axes, 1e-7);
    CHECK_THAT(contact.hertz_back()[2], WithinRel(6.0, 1e-9));
    CHECK_THAT(contact.hertz_back()[3], WithinRel(4.0, 1e-9));

    contact.hertz(-2, {25, 25, a1, 1.5, 1.1});
    REQUIRE(contact.calculate() == 0);
    check_close(contact.forces(), by_axes, 1e-7);
    CHECK_THAT(contact.hertz_back()[1], WithinRel(b1, 1e-9));
}

TEST_CASE("what Hertz knows of a contact is read back") {
    Case contact = wheel(1);
    const Values hertz = contact.hertz_back();

    const double a1 = hertz[0], b1 = hertz[1];
    CHECK_THAT(hertz[2], WithinRel(6.0, 1e-12));
    CHECK_THAT(hertz[3], WithinRel(4.0, 1e-12));
    CHECK_THAT(hertz[4], WithinRel(2 / (a1 + b1), 1e-12));
    CHECK_THAT(hertz[5], WithinRel(std::sqrt(24.0), 1e-12));
    CHECK_THAT(hertz[6], WithinRel(1.1, 1e-12));
    CHECK_THAT(hertz[9], WithinRel(1.5, 1e-12));
    CHECK(contact.hertz_back(6) == Values(hertz.begin(), hertz.begin() + 6));  // as far as the array goes
    const Values potential = contact.potential_back();
    CHECK(potential[0] == 25);
    CHECK_THAT(potential[4], WithinRel(13.2 / 25, 1e-12));
    CHECK_THAT(potential[2], WithinRel(-6.6 + 13.2 / 50, 1e-12));
}

TEST_CASE("a circle has Hertz's numbers") {
    Case contact(1);
    contact.material(0.3, 0.3, 1000, 1000);
    contact.flag(1972, 0);
    contact.hertz(-1, {40, 40, 0.01, 0.01, 1.2});  // a sphere of 50 mm
    contact.normal_force(100);
    REQUIRE(contact.calculate() == 0);

    const double compliance = (1 - 0.3) / 1000, a = std::cbrt(0.75 * 100 * 50 * compliance);
    CHECK_THAT(contact.hertz_back()[2], WithinRel(a, 1e-9));
    CHECK_THAT(contact.found_penetration(), WithinRel(a * a / 50, 2e-3));
    CHECK_THAT(contact.max_pressure(), WithinRel(1.5 * 100 / (std::numbers::pi * a * a), 3e-3));
}

TEST_CASE("a line contact by curvature or half width is Hertz's, as long as it was said to be") {
    Case contact(1);
    contact.material(0.3, 0.3, 1000, 1000);
    contact.flag(1972, 0);
    contact.normal_force(100);
    const double half_length = 20, per_length = 100 / (2 * half_length), R = 50;
    contact.hertz(-4, {20, 40, 1 / (2 * R), half_length, 1.5});
    const double a = std::sqrt(4 * per_length * R * (1 - 0.3) / 1000 / std::numbers::pi);
    CHECK_THAT(contact.hertz_back()[2], WithinRel(a, 1e-12));
    // 28 of 40 rows divide the line, and 6 lie beyond each end.
    CHECK_THAT(contact.potential_back()[3], WithinRel(-half_length - 5.5 * half_length / 14, 1e-12));
    REQUIRE(contact.calculate() >= 0);
    const double by_curvature = contact.max_pressure();
    const Values pressure = contact.tractions().pn;
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        const std::size_t row = i / 20;
        if (row < 6 || row >= 34) CHECK(pressure[i] == 0);
    }
    CHECK(pressure[6 * 20 + 10] > 0);
    contact.hertz(-5, {20, 40, a, half_length, 1.5});

    REQUIRE(contact.calculate() >= 0);

    CHECK_THAT(contact.max_pressure(), WithinRel(by_curvature, 1e-6));
    CHECK_THAT(contact.hertz_back()[0], WithinRel(1 / (2 * R), 1e-12));
    contact.penetration(0.1);
    CHECK(contact.calculate() == -39);
}

TEST_CASE("elements by corner, corners, centre or centres are the same") {
    Case contact = wheel(1);
    contact.distance(1, {1e-3, 0, 2e-3, 0, 0, 0});
    contact.penetration(0.05);
    contact.potential(1, {30, 20, -7, -6.5, 0.5, 0.6});
    const Values expected = contact.potential_back();
    CHECK_THAT(expected[2], WithinAbs(-6.75, 1e-12));
    CHECK_THAT(expected[3], WithinAbs(-6.2, 1e-12));
    REQUIRE(contact.calculate() == 0);
    const ContactForces forces = contact.forces();

    for (const auto& [option, numbers] :
         std::initializer_list<std::pair<int, Values>>{{2, {30, 20, -7, -6.5, 8, 5.5}},
                                                       {3, {30, 20, -6.75, -6.2, 0.5, 0.6}},
                                                       {4, {30, 20, -6.75, -6.2, 7.75, 5.2}}}) {
        contact.potential(option, numbers);
        for (std::size_t i = 0; i < 6; ++i) CHECK_THAT(contact.potential_back()[i], WithinAbs(expected[i], 1e-12));
        REQUIRE(contact.calculate() == 0);
        check_close(contact.forces(), forces, 1e-8);
    }
}

TEST_CASE("a quadratic distance is that of its values at the elements") {
    Case contact = wheel(1);
    contact.penetration(0.05);
    contact.potential(1, {30, 20, -7, -6.5, 0.5, 0.6});
    const Values b{1e-3, 3e-4, 2e-3, 1e-3, -2e-3, 0.004};
    contact.distance(1, b);
    REQUIRE(contact.calculate() == 0);
    const ContactForces expected = contact.forces();
    const Values h = contact.field(1);
    Values sampled;
    for (int iy = 0; iy < 20; ++iy)
        for (int ix = 0; ix < 30; ++ix) {
            const double x = -7 + (ix + 0.5) * 0.5, y = -6.5 + (iy + 0.5) * 0.6;
            sampled.push_back(b[0] * x * x + b[1] * x * y + b[2] * y * y + b[3] * x + b[4] * y + b[5]);
        }
    for (std::size_t i = 0; i < h.size(); ++i) CHECK_THAT(h[i], WithinAbs(sampled[i], 1e-12));
    contact.distance(9, sampled);

    REQUIRE(contact.calculate() == 0);

    check_close(contact.forces(), expected, 1e-9);
}

TEST_CASE("a distance without mixed terms has its curvatures") {
    Case contact = wheel(1);
    contact.penetration(0.05);
    contact.potential(1, {30, 20, -7, -6.5, 0.5, 0.6});
    contact.distance(1, {1e-3, 0, 0, 0, 0, 0});  // flat along y

    const int border = contact.calculate();

    CHECK(border == at_border(contact.division(), 30, 20));
    CHECK(border > 10);  // at both ends of the strip
    const Values h = contact.field(1);
    CHECK_THAT(h[0], WithinAbs(1e-3 * 6.75 * 6.75, 1e-12));
    CHECK_THAT(h[30], WithinAbs(h[0], 1e-15));
}

TEST_CASE("contact at the border of the elements is counted") {
    Case contact = wheel(1);
    contact.hertz(-3, {25, 25, 6, 4, 0.8});
    const int border = contact.calculate();
    CHECK(border > 0);
    CHECK(border == at_border(contact.division(), 25, 25));
}

TEST_CASE("bodies that part have no forces where their elements are known") {
    Case contact = wheel(1);
    contact.potential(1, {30, 20, -7, -6.5, 0.5, 0.6});
    contact.distance(1, {1e-3, 0, 2e-3, 0, 0, 0});
    contact.penetration(-0.1);
    REQUIRE(contact.calculate() == 0);
    CHECK(contact.forces() == ContactForces{0, 0, 0, 0});
    CHECK(contact.areas().contact == 0);

    contact.hertz(-3, {25, 25, 6, 4, 1.1});  // no size without load
    CHECK(contact.calculate() == -39);
}

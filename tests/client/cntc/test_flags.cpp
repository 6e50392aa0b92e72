// Values of flags, areas and distances that stand for what there is.
#include <array>
#include <cmath>
#include <numbers>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "client/cntc/rail_calls.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// A contact on elements that are set, with a shift.
Case shifted(int ire) {
    Case contact(ire);
    contact.flag(1972, 1);
    contact.material(0.28, 0.28, 82000, 82000);
    contact.coulomb(0.3);
    contact.potential(1, {15, 15, -6.6, -4.4, 0.88, 0.6});
    contact.distance(1, {8e-4, 0, 1.5e-3, 0, 0, 0});
    contact.normal_force(20000);
    contact.creepages(0.004, 0.001, 0);
    return contact;
}

Values sampled(double (*h)(double, double)) {
    Values values;
    for (int iy = 0; iy < 15; ++iy)
        for (int ix = 0; ix < 15; ++ix) values.push_back(h(-6.6 + 0.88 * (ix + 0.5), -4.4 + 0.6 * (iy + 0.5)));
    return values;
}

}  // namespace

TEST_CASE("every estimate of the last case finds the same solution") {
    const int estimate = GENERATE(1, 2, 3);
    Case contact = wheel(1);
    contact.tolerance(1e-9);
    REQUIRE(contact.calculate() == 0);
    const ContactForces expected = contact.forces();
    contact.flag(1983, estimate);
    CHECK(last_code() == 0);
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(contact.forces().fx, WithinRel(expected.fx, 1e-6));
}

TEST_CASE("coefficients 0 and 1 keep those that were set") {
    Case contact = wheel(1);
    contact.flag(1978, 3);
    contact.flag(1978, GENERATE(0, 1));
    CHECK(last_code() == 0);
    CHECK(contact.get_flag(1978) == 3);
}

TEST_CASE("a step is repeated from where the last one started") {
    Case contact = shifted(1);
    REQUIRE(contact.calculate() == 0);
    contact.flag(1970, 0);
    REQUIRE(contact.calculate() == 0);
    const ContactForces second = contact.forces();
    contact.creepages(-0.004, 0, 0);
    contact.flag(1970, 3);
    REQUIRE(contact.calculate() == 0);
    CHECK(contact.forces().fx > second.fx);
    contact.creepages(0.004, 0.001, 0);
    REQUIRE(contact.calculate() == 0);
    CHECK_THAT(contact.forces().fx, WithinRel(second.fx, 1e-5));
}

TEST_CASE("a history of pressures alone is refused where there is a history, and has no effect elsewhere") {
    Case contact = shifted(1);
    contact.flag(1970, 1);
    CHECK(last_code() == 0);
    CHECK(contact.calculate() == 0);  // the first case starts anew
    CHECK(contact.calculate() == -39);
    CHECK_THAT(last_sentence(), ContainsSubstring("Control digit P = 1 (flag 1970)"));
    contact.flag(1972, 3);
    CHECK(contact.calculate() == 0);
}

TEST_CASE("extra rigid slip is switched off and on") {
    Case contact = wheel(1);
    REQUIRE(contact.calculate() == 0);
    const ContactForces without = contact.forces();
    contact.extra_slip(Values(625, 1e-3), Values(625, 0));
    REQUIRE(contact.calculate() == 0);
    const ContactForces with = contact.forces();
    CHECK(with.fx < without.fx);
    contact.flag(1980, 0);
    REQUIRE(contact.calculate() == 0);
    CHECK(contact.forces() == without);
    contact.flag(1980, 1);
    REQUIRE(contact.calculate() == 0);
    CHECK(contact.forces() == with);
}

TEST_CASE("a flag that is not kept does not hide those behind it") {
    Case contact = wheel(1);
    int count = 3;
    std::array codes{1972, 1967, 1973}, values{0, 0, 0};
    cntc_getflags(contact.ire(), contact.icp(), &count, codes.data(), values.data());
    CHECK(values == std::array{3, -1, 1});
}

TEST_CASE("numbers that pictures are drawn from are read back") {
    Case contact = wheel(1);
    contact.flag(1933, 1936);
    contact.velocity(20);
    contact.material(0.28, 0.28, 82e9, 82e9);
    contact.hertz(-3, {25, 25, 0.006, 0.004, 1.1});
    REQUIRE(contact.calculate() == 0);
    int task = 1, length = 6;
    Values values(6);
    cntc_getparameters(contact.ire(), contact.icp(), &task, &length, values.data());
    CHECK_THAT(values[0], WithinRel(20.0, 1e-12));
    CHECK(values[1] == 0);
    CHECK_THAT(values[2], WithinRel(contact.element_size()[0], 1e-12));
    for (std::size_t i = 3; i < 6; ++i) CHECK(values[i] == 0);
}

TEST_CASE("distances of a profile across and of waves are those of their elements") {
    Case contact = shifted(1), by_elements = shifted(2);
    SECTION("a circle along x, and straight lines across") {
        // Heights 0.03 and 0.01 beyond the middle, and lines that go on beyond the ends.
        contact.distance(2, {3, 0.5, 500, -2, 2, 0.03, 0, 0.01});
        by_elements.distance(9, sampled([](double x, double y) {
                                 return (y < 0 ? -0.015 * y : 0.005 * y) + (x - 0.5) * (x - 0.5) / 1000;
                             }));
    }
    SECTION("one height") {
        contact.distance(2, {1, 0, 500, 0, 0, 0.002});
        by_elements.distance(9, sampled([](double x, double) { return 0.002 + x * x / 1000; }));
    }
    SECTION("two waves and two radii") {
        contact.distance(3, {0.002, 1.5, 0.3, 0.001, 3, 0.1, 400, 300});
        by_elements.distance(9, sampled([](double x, double y) {
                                 return 0.002 * std::sin(1.5 * (x - 0.3)) - 0.001 * std::sin(3 * (x - 0.1)) +
                                        x * x / 400 + y * y / 300;
                             }));
    }
    const int code = contact.calculate();
    REQUIRE(code >= 0);
    REQUIRE(by_elements.calculate() == code);
    const Values h = contact.field(1), expected = by_elements.field(1);
    for (std::size_t i = 0; i < h.size(); ++i) CHECK_THAT(h[i], WithinAbs(expected[i], 1e-15));
    CHECK_THAT(contact.forces().fx, WithinRel(by_elements.forces().fx, 1e-9));
    contact.flag(1933, 1936);
    for (const auto& [base, wrong] :
         {std::pair{2, Values{2, 0, 500, 0, 0, 1, 1}}, std::pair{2, Values{3, 0, 1, 0, 1, 1}},
          std::pair{2, Values{1, 0, 0, 0, 1, 1}}, std::pair{3, Values{0, 0, 0, 0, 0, 0, 0, 1}}}) {
        contact.distance(base, wrong);
        CHECK(last_code() == -39);
    }
}

TEST_CASE("pressures over two half ellipses are those of each half") {
    constexpr double a = 6, negative = 3, positive = 5, Fn = 50000;
    Case contact = wheel(1);
    contact.hertz(-6, {45, 45, a, negative, positive, 1.1});
    contact.flag(1971, 4);
    REQUIRE(contact.calculate() == 0);
    const Values pn = contact.field(5), back = contact.hertz_back(10);
    CHECK(contact.forces().fn == Fn);
    CHECK_THAT(back[3], WithinRel(4.0, 1e-12));
    CHECK_THAT(back[7], WithinRel(negative, 1e-12));
    CHECK_THAT(back[8], WithinRel(positive, 1e-12));
    const double p0 = 1.5 * Fn / (std::numbers::pi * a * (negative + positive) / 2);
    const auto [dx, dy] = contact.element_size();
    for (std::size_t i = 0; i < pn.size(); ++i) {
        const double x = (static_cast<double>(i % 45) - 22) * dx, y = (static_cast<double>(i / 45) - 22) * dy + 1;
        const double s = y / (y > 0 ? positive : negative), e = 1 - x * x / (a * a) - s * s;
        CHECK_THAT(pn[i], WithinAbs(e > 0 ? p0 * std::sqrt(e) : 0, 1e-9 * p0));
    }
}

TEST_CASE("a patch on a rail has fewer elements than the flag says") {
    const auto& known = contactd::test::manchester_cases[0];
    RailCase rail = manchester_wheel(1, known.side);
    place(rail, known);
    REQUIRE(rail.whole.calculate() == 0);
    CHECK(rail.patch(1).element_size()[0] == 0.2);
    CHECK(rail.whole.get_flag(1993) == 20000);
    REQUIRE(rail.patch(1).elements() > 2000);
    rail.whole.flag(1993, 2000);
    CHECK(rail.whole.get_flag(1993) == 2000);
    REQUIRE(rail.whole.calculate() == 0);
    CHECK(rail.patch(1).elements() < 2000);
    CHECK(rail.patch(1).element_size()[0] == 0.4);
}

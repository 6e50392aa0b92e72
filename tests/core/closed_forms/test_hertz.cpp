#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "closed_forms/hertz.hpp"
#include "contactd/error.hpp"

using namespace contactd;
using Catch::Matchers::WithinRel;

namespace {

constexpr double compliance = 3e-6;

void check_same(const HertzContact& contact, const HertzContact& expected) {
    CHECK_THAT(contact.a, WithinRel(expected.a, 1e-13));
    CHECK_THAT(contact.b, WithinRel(expected.b, 1e-13));
    CHECK_THAT(contact.pmax, WithinRel(expected.pmax, 1e-13));
    CHECK_THAT(contact.approach, WithinRel(expected.approach, 1e-13));
    CHECK_THAT(contact.Fn, WithinRel(expected.Fn, 1e-13));
}

}  // namespace

TEST_CASE("semi-axes and radii belong to each other", "[hertz]") {
    const double ratio = GENERATE(0.01, 0.1, 0.5, 0.999999, 1.0, 1.0000001, 1.3, 10.0, 100.0);
    const SemiAxes axes{2 * ratio, 2};
    const HertzContact contact = hertz_of_semi_axes_and_force(axes, compliance, 1234);

    const Paraboloid gap = radii_of_force(axes, compliance, 1234);

    check_same(hertz_of_force(gap, compliance, 1234), contact);
    check_same(hertz_of_approach(gap, compliance, contact.approach), contact);
    check_same(hertz_of_semi_axes_and_approach(axes, compliance, contact.approach), contact);
    const Paraboloid same = radii_of_approach(axes, contact.approach);
    CHECK_THAT(same.Rx, WithinRel(gap.Rx, 1e-13));
    CHECK_THAT(same.Ry, WithinRel(gap.Ry, 1e-13));
}

TEST_CASE("ellipses follow Johnson's integrals", "[hertz]") {
    // Johnson (4.26) with e^2 = 1 - b^2/a^2, a > b.
    const double a = GENERATE(1.2, 3.0, 50.0), b = 1;
    const double e = std::sqrt(1 - b * b / (a * a)), K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
    const HertzContact contact = hertz_of_semi_axes_and_force({a, b}, compliance, 100);
    const double common = contact.pmax * b * compliance / (e * e * a * a);

    const Paraboloid gap = radii_of_force({a, b}, compliance, 100);

    CHECK_THAT(contact.pmax, WithinRel(1.5 * 100 / (std::numbers::pi * a * b), 1e-13));
    CHECK_THAT(contact.approach, WithinRel(contact.pmax * b * K * compliance, 1e-12));
    CHECK_THAT(gap.Rx, WithinRel(0.5 / (common * (K - E)), 1e-11));
    CHECK_THAT(gap.Ry, WithinRel(0.5 / (common * (a * a * E - K)), 1e-11));
}

TEST_CASE("circles have the approach a^2/R", "[hertz]") {
    const HertzContact contact = hertz_of_approach({50, 50}, (1 - 0.42) / 200, 0.02);
    CHECK_THAT(contact.a, WithinRel(1.0, 1e-14));
    CHECK_THAT(contact.b, WithinRel(1.0, 1e-14));
    CHECK_THAT(contact.Fn, WithinRel(9.195402, 1e-7));
    CHECK_THAT(contact.pmax, WithinRel(4.390481, 1e-6));
}

TEST_CASE("nothing touches without a force or an approach", "[hertz]") {
    CHECK(hertz_of_force({50, 50}, compliance, 0).a == 0);
    const HertzContact apart = hertz_of_approach({50, 50}, compliance, -0.1);
    CHECK(apart.Fn == 0);
    CHECK(apart.approach == -0.1);
}

TEST_CASE("Hertz refuses what makes no ellipse", "[hertz]") {
    CHECK_THROWS_AS(hertz_of_force({50, INFINITY}, compliance, 1), InvalidArgument);
    CHECK_THROWS_AS(hertz_of_approach({-50, 10}, compliance, 1), InvalidArgument);
    CHECK_THROWS_AS(hertz_of_force({50, 50}, 0, 1), InvalidArgument);
    CHECK_THROWS_AS(hertz_of_force({50, 50}, compliance, NAN), InvalidArgument);
    CHECK_THROWS_AS(radii_of_force({0, 1}, compliance, 1), InvalidArgument);
    CHECK_THROWS_AS(radii_of_force({1, 1}, compliance, -1), InvalidArgument);
    CHECK_THROWS_AS(radii_of_approach({1, 1}, 0), InvalidArgument);
}

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "half_space_cases.hpp"
#include "quadrature.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double by_quadrature(Axis i, Axis j, double x, double y, double dx, double dy, const Material& material,
                     double tolerance) {
    const auto f = [&](double X, double Y) { return kernel(i, j, X, Y, material.nu) / material.G; };
    return test::integrate(f, x - dx / 2, x + dx / 2, y - dy / 2, y + dy / 2, tolerance);
}

}  // namespace

TEST_CASE("closed form agrees with quadrature for all components", "[half_space]") {
    const double aspect = GENERATE(0.1, 0.6, 1.0, 3.0, 10.0);
    const double nu = GENERATE(0.0, 0.28, 0.5);
    const Material material{200, nu};
    const double dx = 0.3, dy = dx / aspect;
    const double largest = half_space_coefficient(Axis::x, Axis::x, 0, 0, dx, dy, material) +
                           half_space_coefficient(Axis::y, Axis::y, 0, 0, dx, dy, material);
    for (const auto& [k, l] : {std::pair{0.0, 0.0},
                               {1.0, 0.0},
                               {0.0, 1.0},
                               {-1.0, 2.0},
                               {3.0, -2.0},
                               {-4.0, -3.0},
                               {0.0, -5.0},
                               {-7.0, 0.0},
                               {11.0, 13.0},
                               {0.5, 0.5},
                               {-0.5, 0.2},
                               {0.5, 0.0}})
        for (const Axis i : axes)
            for (const Axis j : axes) {
                CAPTURE(aspect, nu, k, l, int(i), int(j));
                const double expected = by_quadrature(i, j, k * dx, l * dy, dx, dy, material, 1e-11 * largest);
                CHECK_THAT(half_space_coefficient(i, j, k * dx, l * dy, dx, dy, material),
                           WithinAbs(expected, 3e-10 * largest));
            }
}

// The middle of a strip of half-width a under unit pressure is deeper than at x by (1 - nu)/(pi G) ((x+a) ln|x+a| -
// (x-a) ln|x-a| - 2 a ln a) (Johnson, Contact Mechanics, 2.5(a)). Ends at the distance L change this by (x/L)^2.
TEST_CASE("elements a hundred thousand times longer than wide act as strips", "[half_space]") {
    const double dx = 0.05, dy = 1e5 * dx, a = dx / 2;
    const Material material{82000, 0.28};
    const double middle = half_space_coefficient(Axis::z, Axis::z, 0, 0, dx, dy, material);
    for (const int k : {1, 2, 5, 20, 90}) {
        CAPTURE(k);
        const double x = k * dx;
        const double deeper = (1 - material.nu) / (std::numbers::pi * material.G) *
                              ((x + a) * std::log(x + a) - (x - a) * std::log(x - a) - 2 * a * std::log(a));
        CHECK_THAT(middle - half_space_coefficient(Axis::z, Axis::z, x, 0, dx, dy, material), WithinRel(deeper, 1e-6));
    }
}

TEST_CASE("closed form keeps its relative accuracy far away", "[half_space]") {
    const double aspect = GENERATE(0.1, 1.0, 10.0);
    const Material material{82000, 0.28};
    const double dx = 0.8, dy = dx / aspect;
    for (const auto& [k, l] : {std::pair{9, 8}, {40, -1}, {-99, 60}, {101, 3}, {300, 500}, {1, 1999}})
        for (const Axis i : axes)
            for (const Axis j : axes) {
                CAPTURE(aspect, k, l, int(i), int(j));
                const double size = dx * dy / material.G / std::hypot(k * dx, l * dy);
                const double expected = by_quadrature(i, j, k * dx, l * dy, dx, dy, material, 1e-13 * size);
                CHECK_THAT(half_space_coefficient(i, j, k * dx, l * dy, dx, dy, material), WithinRel(expected, 1e-10));
            }
}

TEST_CASE("closed form has the exact parity of each component", "[half_space]") {
    const Material material{1, 0.3};
    for (const Axis i : axes)
        for (const Axis j : axes) {
            const auto [along_x, along_y] = parity(i, j);
            const auto A = [&](double x, double y) { return half_space_coefficient(i, j, x, y, 1, 0.7, material); };
            CHECK(A(-3, 2) == along_x * A(3, 2));
            CHECK(A(3, -2) == along_y * A(3, 2));
            if (along_x < 0) CHECK(A(0, 2) == 0);
            if (along_y < 0) CHECK(A(3, 0) == 0);
        }
}

TEST_CASE("table holds the coefficients at the element centres", "[half_space]") {
    const IcSpec spec = analytic({200, 0.42}, 0.06, 0.05, 7, 4);
    const IcTable table = half_space_table(spec);
    REQUIRE(table.nx == 7);
    REQUIRE(table.ny == 4);
    CHECK(table(Axis::x, Axis::z, 6, 3) ==
          half_space_coefficient(Axis::x, Axis::z, 6 * spec.dx, 3 * spec.dy, spec.dx, spec.dy, spec.material));
    CHECK(table(Axis::z, Axis::x, 6, 3) == -table(Axis::x, Axis::z, 6, 3));
}

TEST_CASE("coefficients scale with dx/G", "[half_space]") {
    const IcTable table = half_space_table(analytic({200, 0.3}, 0.25, 0.1, 5, 5));
    const IcTable unit = scaled(half_space_table(analytic({1, 0.3}, 1, 0.4, 5, 5)), 0.25 / 200);
    for (std::size_t i = 0; i < table.values.size(); ++i)
        CHECK_THAT(table.values[i], WithinAbs(unit.values[i], 1e-14 * unit.values[0]));
}

TEST_CASE("a pair of equal bodies has no coupling between normal and tangential directions", "[half_space]") {
    const IcTable body = half_space_table(analytic({200, 0.3}, 1, 1, 4, 3));
    const IcTable pair = pair_of(body, body);
    for (int l = 0; l < 3; ++l)
        for (int k = 0; k < 4; ++k) {
            CHECK(pair(Axis::x, Axis::z, k, l) == 0);
            CHECK(pair(Axis::z, Axis::y, k, l) == 0);
            CHECK(pair(Axis::z, Axis::z, k, l) == 2 * body(Axis::z, Axis::z, k, l));
        }
}

TEST_CASE("no closed form is made for what has none", "[half_space]") {
    IcSpec spec = analytic({200, 0.3}, 1, 1, 4, 4);
    SECTION("finite elements") {
        spec.source = IcSource::fem;
    }
    SECTION("a block") {
        spec.body = BodyShape::block;
    }
    CHECK_THROWS_AS(half_space_table(spec), InvalidArgument);
}

TEST_CASE("comparison finds the errors put into a table", "[half_space]") {
    const LoadShape load_shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    const IcSpec spec = analytic({200, 0.3}, 0.5, 0.4, 6, 5, load_shape);
    IcTable table = half_space_table(spec);
    const double shift = 1e-6;
    table(Axis::z, Axis::z, 0, 0) *= 0.99;
    table(Axis::z, Axis::z, 3, 2) *= 1.04;
    table(Axis::y, Axis::x, 2, 1) += shift;
    table(Axis::z, Axis::y, 0, 4) += shift;
    IcEvidence evidence;

    compare_with_half_space(spec, table, evidence);

    CHECK_THAT(evidence.errors.zz->origin, WithinAbs(-0.01, 1e-12));
    CHECK_THAT(evidence.errors.zz->largest, WithinAbs(0.04, 1e-12));
    CHECK(evidence.errors.xx->largest == 0);
    CHECK(evidence.errors.yy->largest == 0);
    const double unit = 2 * std::numbers::pi * 200 / (0.5 * 0.4);
    CHECK_THAT(*evidence.errors.scaled_xy, WithinRel(shift * unit * std::hypot(1.0, 0.4), 1e-9));
    CHECK_THAT(*evidence.errors.scaled_xz, WithinRel(shift * unit * 1.6, 1e-9));
}

TEST_CASE("a block has nothing to be compared with", "[half_space]") {
    IcSpec spec = analytic({200, 0.3}, 1, 1, 2, 2);
    const IcTable table = half_space_table(spec);
    IcEvidence evidence;
    spec.source = IcSource::fem;
    spec.body = BodyShape::block;
    CHECK_THROWS_AS(compare_with_half_space(spec, table, evidence), InvalidArgument);
    CHECK(!evidence.errors.zz);
}

TEST_CASE("a long element is the sum of its parts", "[half_space]") {
    const Material material{200, 0.28};
    const double dx = 0.05, dy = 1000;
    constexpr int parts = 64;
    for (const int k : {0, 1, 20, 400})
        for (const Axis i : axes) {
            double sum = 0;
            for (int part = 0; part < parts; ++part)
                sum += half_space_coefficient(i, i, k * dx, (part - 0.5 * (parts - 1)) * dy / parts, dx, dy / parts,
                                              material);
            CAPTURE(k, int(i));
            CHECK_THAT(half_space_coefficient(i, i, k * dx, 0, dx, dy, material), WithinRel(sum, 1e-9));
        }
    IcSpec spec;
    spec.material = material;
    spec.dx = dx;
    spec.dy = dy;
    spec.nx = 4;
    spec.ny = 1;
    CHECK_NOTHROW(half_space_table(spec));
    spec.load_shape = LoadShape::bilinear;
    CHECK_THROWS_WITH(half_space_table(spec), Catch::Matchers::ContainsSubstring("it must lie in [0.001, 1000]"));
}

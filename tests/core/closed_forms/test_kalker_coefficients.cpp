#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "closed_forms/kalker_coefficients.hpp"
#include "contactd/error.hpp"

using namespace contactd;
using Catch::Matchers::WithinRel;

namespace {

void check(const KalkerCoefficients& C, double C11, double C22, double C23, double C33, double tolerance) {
    CHECK_THAT(C.C11, WithinRel(C11, tolerance));
    CHECK_THAT(C.C22, WithinRel(C22, tolerance));
    CHECK_THAT(C.C23, WithinRel(C23, tolerance));
    CHECK_THAT(C.C33, WithinRel(C33, tolerance));
}

}  // namespace

TEST_CASE("Kalker's coefficients are those he published", "[kalker]") {
    check(kalker_coefficients(1, 0.25), 4.12, 3.67, 1.47, 1.19, 0.006);
    check(kalker_coefficients(0.1, 0.25), 3.31, 2.52, 0.473, 8.28, 0.01);
    check(kalker_coefficients(10, 0.25), 11.7, 12.8, 14.6, 0.526, 0.015);
}

TEST_CASE("without lateral contraction longitudinal and lateral creepage cost the same", "[kalker]") {
    const double ratio = GENERATE(0.04, 0.13, 1.0, 2.7, 30.0);
    const KalkerCoefficients C = kalker_coefficients(ratio, 0);
    CHECK_THAT(C.C11, WithinRel(C.C22, 1e-5));
}

TEST_CASE("strips across the rolling direction have the coefficients of line contact", "[kalker]") {
    const double nu = GENERATE(0.0, 0.28, 0.5), ratio = 1.0 / 32;
    const double pi2 = std::numbers::pi * std::numbers::pi;
    const KalkerCoefficients C = kalker_coefficients(ratio, nu);
    CHECK_THAT(C.C11, WithinRel(pi2 / (4 * (1 - nu)), 0.005));
    CHECK_THAT(C.C22, WithinRel(pi2 / 4, 0.005));
    CHECK_THAT(C.C33, WithinRel(pi2 / (16 * (1 - nu) * ratio), 0.02));
}

TEST_CASE("Kalker's coefficients end where their table does", "[kalker]") {
    const double edge = GENERATE(1.0 / 32, 32.0), nu = GENERATE(0.0, 0.3, 0.5);
    const double inwards = edge > 1 ? 1 - 1e-9 : 1 + 1e-9, outwards = edge > 1 ? 1.001 : 0.999;
    const KalkerCoefficients inside = kalker_coefficients(edge * inwards, nu);
    check(kalker_coefficients(edge, nu), inside.C11, inside.C22, inside.C23, inside.C33, 1e-8);
    CHECK_THROWS_AS(kalker_coefficients(edge * outwards, nu), InvalidArgument);
    CHECK_THROWS_AS(kalker_coefficients(0, nu), InvalidArgument);
}

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "creep_table/full_slip.hpp"

using namespace contactd::creep_table;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;

void check(const Triple& found, const Triple& expected, double tolerance) {
    for (int i = 0; i < 3; ++i) CHECK_THAT(found[i], WithinAbs(expected[i], tolerance));
}

// Sums the Hertzian pressure times the direction of slip over rings of the unit circle.
Triple summed(double a_over_b, const Triple& w) {
    const double a = std::sqrt(a_over_b), b = 1 / a;
    constexpr int rings = 400, angles = 3000;
    Triple sum{};
    for (int i = 0; i < rings; ++i) {
        const double s = pi / 2 * (i + 0.5) / rings, r = std::sin(s);  // r dr sqrt(1 - r^2) = sin s cos^2 s ds
        const double weight = 3 / (2 * pi) * r * std::cos(s) * std::cos(s) * (pi / 2 / rings) * (2 * pi / angles);
        for (int k = 0; k < angles; ++k) {
            const double x = a * r * std::cos(2 * pi * k / angles), y = b * r * std::sin(2 * pi * k / angles);
            const double slip_x = w[0] - w[2] * y, slip_y = w[1] + w[2] * x, size = std::hypot(slip_x, slip_y);
            sum[0] += weight * slip_x / size;
            sum[1] += weight * slip_y / size;
            sum[2] += weight * (x * slip_y - y * slip_x) / size;
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("the creepages of full slip are those of the closed form of a circle", "[creep_table]") {
    const double nu = GENERATE(0.0, 0.28, 0.5);
    const Triple scale = full_slip(1, nu);
    CHECK_THAT(scale[0], WithinRel(3 * (4 - 3 * nu) / 16, 1e-12));
    CHECK_THAT(scale[1], WithinRel(3 * (4 - nu) / 16, 1e-12));
}

TEST_CASE("the creepages of full slip are those computed before", "[creep_table]") {
    check(full_slip(0.05, 0.28), {0.6867, 0.9499, 0.15344}, 6e-5);
    check(full_slip(1, 0.28), {0.5925, 0.6975, 0.45157}, 6e-5);
    check(full_slip(20, 0.28), {0.14851, 0.12970, 0.028975}, 6e-6);
}

TEST_CASE("without lateral contraction, full slip starts at the same creepage in both directions", "[creep_table]") {
    const Triple scale = full_slip(GENERATE(0.05, 0.7, 20.0), 0);
    CHECK_THAT(scale[0], WithinRel(scale[1], 1e-12));
}

TEST_CASE("without spin, infinite creepage produces the friction bound against the slip", "[creep_table]") {
    check(forces_at_infinite_creepage(3, {3, -4, 0}), {0.6, -0.8, 0}, 1e-15);
    check(forces_at_infinite_creepage(3, {3, -4, 1e-7}), {0.6, -0.8, 0}, 1e-7);
}

TEST_CASE("infinite spin produces the moment of a disc", "[creep_table]") {
    check(forces_at_infinite_creepage(1, {0, 0, 2}), {0, 0, 3 * pi / 16}, 1e-9);
    check(forces_at_infinite_creepage(1, {0, 0, -2}), {0, 0, -3 * pi / 16}, 1e-9);
}

TEST_CASE("forces at infinite creepage are the integral over the contact", "[creep_table]") {
    const double ratio = GENERATE(0.1, 1.0, 6.0);
    const Triple w = GENERATE(Triple{0.3, 0.2, 1}, Triple{1, -2, 0.5}, Triple{0.05, -0.4, 0.3}, Triple{0, 1.5, -1});
    check(forces_at_infinite_creepage(ratio, w), summed(ratio, w), 2e-4);
}

TEST_CASE("forces at infinite creepage are continuous where the pole of the slip leaves the contact", "[creep_table]") {
    const double ratio = GENERATE(0.05, 1.0, 20.0), a = std::sqrt(ratio), b = 1 / a, angle = GENERATE(0.0, 0.7, 1.5);
    const Triple inside{0.999999 * b * std::sin(angle), -0.999999 * a * std::cos(angle), 1};
    const Triple outside{1.000001 * b * std::sin(angle), -1.000001 * a * std::cos(angle), 1};
    check(forces_at_infinite_creepage(ratio, inside), forces_at_infinite_creepage(ratio, outside), 2e-5);
}

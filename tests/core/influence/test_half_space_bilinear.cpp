// Tests coefficients of the hat function of bilinear tractions (paper, Remark 1).
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "contactd/half_space.hpp"
#include "half_space_cases.hpp"
#include "quadrature.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

// Integrates the kernel times the hat function over the four rectangles on which the hat function is a polynomial.
double by_quadrature(Axis i, Axis j, double x, double y, double dx, double dy, const Material& material,
                     double tolerance) {
    const auto f = [&](double X, double Y) {
        return kernel(i, j, X, Y, material.nu) / material.G * (1 - std::abs(X - x) / dx) * (1 - std::abs(Y - y) / dy);
    };
    const double xs[] = {x - dx, x, x + dx}, ys[] = {y - dy, y, y + dy};
    double sum = 0;
    for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) sum += integrate(f, xs[a], xs[a + 1], ys[b], ys[b + 1], tolerance / 4);
    return sum;
}

// Returns the largest component anywhere, as the scale of absolute errors.
double largest_entry(double dx, double dy, const Material& material) {
    return std::max({half_space_bilinear_coefficient(Axis::x, Axis::x, 0, 0, dx, dy, material),
                     half_space_bilinear_coefficient(Axis::y, Axis::y, 0, 0, dx, dy, material),
                     half_space_bilinear_coefficient(Axis::z, Axis::z, 0, 0, dx, dy, material)});
}

// A hat function is the sum of nine of half its size.
double from_half_hats(Axis i, Axis j, double x, double y, double dx, double dy, const Material& material) {
    double sum = 0;
    for (const int k : {-1, 0, 1})
        for (const int l : {-1, 0, 1})
            sum += (k == 0 ? 1 : 0.5) * (l == 0 ? 1 : 0.5) *
                   half_space_bilinear_coefficient(i, j, x - 0.5 * k * dx, y - 0.5 * l * dy, dx / 2, dy / 2, material);
    return sum;
}

}  // namespace

TEST_CASE("the hat function agrees with quadrature for all components", "[half_space]") {
    const double aspect = GENERATE(0.1, 0.25, 1.0, 3.0, 10.0);
    const double nu = GENERATE(0.0, 0.28, 0.5);
    const Material material{200, nu};
    const double dx = 0.3, dy = dx / aspect;
    const double largest = largest_entry(dx, dy, material);
    for (const auto& [k, l] : {std::pair{0.0, 0.0},
                               {1.0, 0.0},
                               {0.0, -1.0},
                               {-1.0, 1.0},
                               {-2.0, 1.0},
                               {3.0, -2.0},
                               {-4.0, -3.0},
                               {0.0, 5.0},
                               {-7.0, 0.0},
                               {11.0, 13.0},
                               {0.5, 0.5},
                               {-1.5, 0.2}})
        for (const Axis i : axes)
            for (const Axis j : axes) {
                CAPTURE(aspect, nu, k, l, int(i), int(j));
                const double expected = by_quadrature(i, j, k * dx, l * dy, dx, dy, material, 1e-10 * largest);
                CHECK_THAT(half_space_bilinear_coefficient(i, j, k * dx, l * dy, dx, dy, material),
                           WithinAbs(expected, 1e-9 * largest));
            }
}

TEST_CASE("the hat function keeps its relative accuracy far away", "[half_space]") {
    const double aspect = GENERATE(0.1, 1.0, 10.0);
    const Material material{82000, 0.28};
    const double dx = 0.8, dy = dx / aspect;
    for (const auto& [k, l] : {std::pair{9, 8}, {40, -1}, {-99, 60}, {101, 3}, {300, 500}, {1, 1999}})
        for (const Axis i : axes)
            for (const Axis j : axes) {
                CAPTURE(aspect, k, l, int(i), int(j));
                const double size = dx * dy / material.G / std::hypot(k * dx, l * dy);
                const double expected = by_quadrature(i, j, k * dx, l * dy, dx, dy, material, 1e-13 * size);
                CHECK_THAT(half_space_bilinear_coefficient(i, j, k * dx, l * dy, dx, dy, material),
                           WithinRel(expected, 1e-10));
            }
}

// The half hat functions use other points and formulas than the whole one.
TEST_CASE("the hat function is the sum of its half hat functions to rounding", "[half_space]") {
    const double aspect = GENERATE(1e-3, 0.01, 0.1, 0.7, 1.0, 5.0, 10.0, 100.0, 1e3);
    const Material material{1, 0.3};
    const double dy = 0.4, dx = dy * aspect;
    double worst = 0;
    for (double k = -6; k <= 6; k += 0.37)
        for (double l = -6; l <= 6; l += 0.43) {
            const double x = k * dx, y = l * dy;
            const double local = half_space_bilinear_coefficient(Axis::x, Axis::x, x, y, dx, dy, material);
            for (const Axis i : axes)
                for (const Axis j : axes)
                    worst = std::max(worst, std::abs(half_space_bilinear_coefficient(i, j, x, y, dx, dy, material) -
                                                     from_half_hats(i, j, x, y, dx, dy, material)) /
                                                local);
        }
    CHECK(worst < 2e-13);
}

TEST_CASE("the hat function is the constant load averaged over an element", "[half_space]") {
    const Material material{200, 0.42};
    const double dx = 0.3, dy = 0.2;
    const double largest = largest_entry(dx, dy, material);
    for (const auto& [k, l] : {std::pair{0, 0}, {-1, 1}, {2, 0}})
        for (const Axis i : axes)
            for (const Axis j : axes) {
                CAPTURE(k, l, int(i), int(j));
                const auto constant = [&](double x, double y) {
                    return half_space_coefficient(i, j, x, y, dx, dy, material) / (dx * dy);
                };
                const double mean =
                    adaptive(constant, (k - 0.5) * dx, (k + 0.5) * dx, (l - 0.5) * dy, (l + 0.5) * dy, 1e-6 * largest);
                CHECK_THAT(half_space_bilinear_coefficient(i, j, k * dx, l * dy, dx, dy, material),
                           WithinAbs(mean, 1e-5 * largest));
            }
}

// Hat functions on a grid add up to 1, with a slope of one element around it: the average of constant loads over one
// element.
TEST_CASE("hat functions side by side sum to a constant load", "[half_space]") {
    const Material material{200, 0.3};
    const double dx = 0.1, dy = 0.25;
    const int nx = 12, ny = 7;  // to each side of the middle
    const double offset = 0.37 * dx;
    for (const Axis i : axes)
        for (const Axis j : axes) {
            CAPTURE(int(i), int(j));
            double sum = 0;
            for (int k = -nx; k <= nx; ++k)
                for (int l = -ny; l <= ny; ++l)
                    sum += half_space_bilinear_coefficient(i, j, offset - k * dx, -l * dy, dx, dy, material);
            const auto large = [&](double x, double y) {
                return half_space_coefficient(i, j, x, y, (2 * nx + 1) * dx, (2 * ny + 1) * dy, material) / (dx * dy);
            };
            const double largest = half_space_coefficient(Axis::x, Axis::x, 0, 0, 2 * nx * dx, 2 * ny * dy, material);
            const double mean = gauss(large, offset - dx / 2, offset + dx / 2, -dy / 2, dy / 2);
            CHECK_THAT(sum, WithinAbs(mean, 1e-11 * largest));
        }
}

TEST_CASE("far away the hat function is a force of dx dy", "[half_space]") {
    const double aspect = GENERATE(0.1, 1.0, 10.0);
    const Material material{200, 0.3};
    const double dx = 0.5, dy = dx / aspect, x = 3e5 * dx, y = -4e5 * dx;
    for (const Axis i : axes)
        for (const Axis j : axes) {
            CAPTURE(aspect, int(i), int(j));
            CHECK_THAT(half_space_bilinear_coefficient(i, j, x, y, dx, dy, material),
                       WithinRel(dx * dy * kernel(i, j, x, y, material.nu) / material.G, 1e-9));
        }
}

TEST_CASE("the hat function has the exact parity of each component", "[half_space]") {
    const Material material{1, 0.3};
    const double distance = GENERATE(0.0, 0.3, 1.0, 2.0, 5.0, 40.0, 1000.0);
    for (const Axis i : axes)
        for (const Axis j : axes) {
            const auto [along_x, along_y] = parity(i, j);
            const auto A = [&](double x, double y) {
                return half_space_bilinear_coefficient(i, j, x, y, 1, 0.7, material);
            };
            CHECK(A(-distance, 2) == along_x * A(distance, 2));
            CHECK(A(3, -distance) == along_y * A(3, distance));
            if (along_x < 0) CHECK(A(0, distance) == 0);
            if (along_y < 0) CHECK(A(distance, 0) == 0);
        }
}

TEST_CASE("a table of bilinear loads holds the hat function at the element centres", "[half_space]") {
    const IcSpec spec = analytic({200, 0.42}, 0.06, 0.05, 7, 4, LoadShape::bilinear);
    const IcTable table = half_space_table(spec);
    for (const Axis i : axes)
        for (const Axis j : axes)
            CHECK(table(i, j, 6, 3) ==
                  half_space_bilinear_coefficient(i, j, 6 * spec.dx, 3 * spec.dy, spec.dx, spec.dy, spec.material));
}

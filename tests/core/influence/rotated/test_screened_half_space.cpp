#include "influence/rotated/screened_half_space.hpp"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "fourier.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

constexpr std::array kernels = {&KernelIntegrals::xx, &KernelIntegrals::yy, &KernelIntegrals::y, &KernelIntegrals::xy,
                                &KernelIntegrals::x};
constexpr std::size_t even = 3;  // the first ones

double wave(std::size_t kernel, double phase) {
    return kernel < even ? std::cos(phase) : std::sin(phase);
}

}  // namespace

TEST_CASE("Screened kernels and their transforms belong to each other", "[rotated]") {
    const double s = GENERATE(0.0, 0.2, -0.8, 3.0), xi = GENERATE(0.0, 0.03, 3.0);
    constexpr double dx = 0.5, ds = 0.4, xi0 = 0.1;
    CAPTURE(s, xi);
    const KernelIntegrals transform = screened_transform(xi, s, ds, xi0);
    const double element = xi > 0 ? 2 * std::sin(xi * dx / 2) / xi : dx;
    std::array<double, kernels.size()> sums{};
    const auto add = [&](double x, double weight) {
        const KernelIntegrals here = screened_integrals(x, s, dx, ds, xi0);
        for (std::size_t i = 0; i < kernels.size(); ++i) sums[i] += 2 * weight * (here.*kernels[i]) * wave(i, xi * x);
    };
    // Integrals over the load have kinks at its end.
    for_each_node(0, dx / 2, 1e-5, 0.1, [&](double before, double weight) { add(dx / 2 - before, weight); });
    for_each_node(dx / 2, 300, 1e-5, 4, add);
    for (std::size_t i = 0; i < kernels.size(); ++i)
        CHECK_THAT(sums[i], WithinAbs(element * (transform.*kernels[i]), 1e-9));
}

TEST_CASE("The transform of what is not screened leads back to the closed form of the half-space", "[rotated]") {
    const double s = GENERATE(-0.9, 0.7, 2.0), x = GENERATE(0.0, 0.5, 2.3);
    constexpr double dx = 0.5, ds = 0.4;
    CAPTURE(s, x);
    const KernelIntegrals exact = constant_load_integrals(x, s, dx, ds);
    for (std::size_t i = 0; i < kernels.size(); ++i) {
        const auto f = [&](double xi) {
            return screened_transform(xi, s, ds, 0).*kernels[i] * wave(i, xi * x) * 2 * std::sin(xi * dx / 2) / xi;
        };
        const double most = 40 / (std::abs(s) - ds / 2);
        CHECK_THAT(integral(f, 1e-14, most, 1e-14, 1) / std::numbers::pi, WithinAbs(exact.*kernels[i], 1e-10));
    }
}

TEST_CASE("A little screening changes the kernels by little", "[rotated]") {
    const double x = GENERATE(0.0, 0.25, -1.0, 7.0), s = GENERATE(0.0, -0.4, 5.0);
    CAPTURE(x, s);
    const KernelIntegrals exact = constant_load_integrals(x, s, 0.5, 0.4);
    const KernelIntegrals none = screened_integrals(x, s, 0.5, 0.4, 0),
                          little = screened_integrals(x, s, 0.5, 0.4, 1e-6);
    for (std::size_t i = 0; i < kernels.size(); ++i) {
        CHECK(none.*kernels[i] == exact.*kernels[i]);
        CHECK_THAT(little.*kernels[i], WithinAbs(exact.*kernels[i], 2e-6 * 0.5 * 0.4));
    }
}

TEST_CASE("Transforms have the parity of their kernels", "[rotated]") {
    for (const double s : {0.1, 0.8, 30.0})
        for (const double xi : {0.0, 0.5, 7.0}) {
            const KernelIntegrals a = screened_transform(xi, s, 0.4, 0.02), b = screened_transform(xi, -s, 0.4, 0.02);
            CHECK_THAT(a.xx, WithinAbs(b.xx, 1e-13));
            CHECK_THAT(a.yy, WithinAbs(b.yy, 1e-13));
            CHECK_THAT(a.x, WithinAbs(b.x, 1e-13));
            CHECK_THAT(a.xy, WithinAbs(-b.xy, 1e-13));
            CHECK_THAT(a.y, WithinAbs(-b.y, 1e-13));
        }
}

#include "influence/rotated/macdonald.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "fourier.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("K0 and K1 agree with those of the standard library", "[rotated]") {
    const double t = GENERATE(1e-12, 1e-5, 0.01, 0.3, 1.0, 1.9999, 2.0, 2.0001, 3.0, 10.0, 60.0, 300.0);
    CAPTURE(t);
    const Macdonald k = macdonald(t);
    CHECK_THAT(k.k0, WithinRel(std::cyl_bessel_k(0, t), 1e-12));
    CHECK_THAT(k.t_k1 + 1, WithinAbs(t * std::cyl_bessel_k(1, t), 1e-13));
}

TEST_CASE("t K1(t) - 1 keeps its digits where t is small", "[rotated]") {
    for (const double t : {1e-8, 1e-5}) {
        const double leading = t * t / 2 * (std::log(t / 2) + std::numbers::egamma - 0.5);
        CHECK_THAT(macdonald(t).t_k1, WithinRel(leading, 1e-9));
    }
}

TEST_CASE("The integral of K0 is that of its values", "[rotated]") {
    const auto k0 = [](double t) { return std::cyl_bessel_k(0, t); };
    for (const double t : {0.01, 0.5, 1.7, 2.5, 8.0, 20.0})
        CHECK_THAT(macdonald(t).integral,
                   WithinRel(macdonald(1e-3).integral + integral(k0, 1e-3, t, 1e-4, 0.5), 1e-11));
    CHECK_THAT(macdonald(1e-9).integral, WithinRel(1e-9 * (1 - std::log(0.5e-9) - std::numbers::egamma), 1e-12));
    CHECK_THAT(macdonald(800).integral, WithinRel(std::numbers::pi / 2, 1e-15));
    CHECK(macdonald(0).integral == 0);
}

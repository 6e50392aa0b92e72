#include "influence/rotated/screened_columns.hpp"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "circle_of_columns.hpp"
#include "fourier.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using enum Axis;
using std::numbers::pi;

TEST_CASE("Screened tables are those of the transform", "[rotated]") {
    const auto frames = circle(-6, 5, 0.4);
    constexpr double nu = 0.28, dx = 0.5, xi0 = 0.1;
    const ColumnGrid grid{frames, 0.4, 0, dx, 3};
    constexpr double shift = 0.13;
    const ColumnTable table = screened_table(grid, nu, xi0, shift);
    for (const Axis i : {x, y, z})
        for (const Axis j : {x, y, z})
            for (const auto& [I, J] : {std::pair{4, 1}, std::pair{0, 3}}) {
                const auto at = ((static_cast<std::size_t>(i) * 3 + static_cast<std::size_t>(j)) * 5 +
                                 static_cast<std::size_t>(I)) *
                                    5 +
                                static_cast<std::size_t>(J);
                const bool odd = (i == x) != (j == x);
                for (int k = 0; k < 3; ++k) {
                    const auto f = [&](double xi) {
                        const double phase = xi * (k * dx + shift);
                        return screened_spectrum(grid, nu, xi0, xi)[at] * (odd ? std::sin(phase) : std::cos(phase)) *
                               2 * std::sin(xi * dx / 2) / xi / pi;
                    };
                    CHECK_THAT(table(i, j, I, J, k), WithinAbs(integral(f, 1e-9, 45, 0.01, 1), 1e-9));
                }
            }
}

#include "closed_forms/semi_ellipsoid.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cfenv>
#include <cmath>
#include <limits>
#include <vector>

using namespace contactd;
using Catch::Matchers::WithinAbs;

TEST_CASE("Half an ellipsoid has its heights at element centres, and none outside", "[simplified]") {
    const int nx = GENERATE(1, 3, 4, 7, 30);
    const Grid grid = Grid::of_elements(nx, 9, 14.0 / nx, 1.1);
    const SemiEllipsoid of{{6, 4}, 0.8, 1.2, -0.3};
    std::vector<double> heights(static_cast<std::size_t>(nx));
    for (int iy = 0; iy < grid.ny; ++iy) {
        heights_along(grid, iy, of, heights);
        for (int ix = 0; ix < nx; ++ix) {
            const double x = (grid.x(ix) - 1.2) / 6, y = (grid.y(iy) + 0.3) / 4, square = 0.64 - x * x - y * y;
            const double found = heights[static_cast<std::size_t>(ix)];
            if (square > 1e-12)
                CHECK_THAT(found, WithinAbs(std::sqrt(square), 1e-9));
            else if (square < -1e-12)
                CHECK(found == 0);
        }
    }
}

TEST_CASE("Half an ellipsoid of infinite length is the half cylinder of a line contact", "[simplified]") {
    const double infinite = std::numeric_limits<double>::infinity();
    const Grid grid = Grid::of_elements(5, 4, 1e3, 1);
    std::vector<double> heights(5);
    std::feclearexcept(FE_ALL_EXCEPT);
    heights_along(grid, 1, {{infinite, 2}}, heights);
    CHECK(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW) == 0);
    for (const double height : heights) CHECK_THAT(height, WithinAbs(std::sqrt(1 - 0.0625), 1e-15));
}

// Tests heights of rails with slices: where the surface is smooth, a few columns determine all others.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <memory>
#include <vector>

#include "contactd/make_profile.hpp"
#include "geometry/distance/heights.hpp"

using namespace contactd;
using namespace contactd::geometry;
using Catch::Matchers::WithinAbs;

namespace {

/// Creates rails of 60E1 whose height and position change along the track, every 25 mm.
std::shared_ptr<const SlicedRail> waved() {
    const ProfileCurve plain = make_profile({ProfileKind::rail, Rail60E1{1.0 / 40}}).curve;
    std::vector<SlicedRail::Slice> slices;
    for (int i = -6; i <= 6; ++i) {
        const double x = 25.0 * i;
        ProfilePoints points;
        for (const ProfilePoint& point : plain.points())
            points.points.push_back({point.y + 0.2 * std::sin(x / 40), point.z + 0.1 * std::cos(x / 30)});
        slices.push_back({x, make_profile({ProfileKind::rail, points}).curve});
    }
    return std::make_shared<const SlicedRail>(slices);
}

}  // namespace

TEST_CASE("A grid over slices has the heights that each of its columns has by itself") {
    const double along = GENERATE(0.0, 7.0, 12.5);  // position of the grid's middle, after a slice or between two
    const double y = GENERATE(0.0, -20.0);
    const int nx = GENERATE(36, 9, 80);
    Track track;
    track.rail_origin = ProfilePoint{760, 0};
    const RailSurface rail(waved(), along, track, *track.rail_origin, {});
    const double z = rail.height(0, 760 + y, rail.profile().s_at_y(y));
    REQUIRE(std::isfinite(z));
    const ContactReference reference{0, 760 + y, z, 0.05};
    const Grid grid = Grid::of_elements(nx, 20, 0.5, 0.4);
    const std::vector<double> heights = rail_heights(rail, reference, grid);
    REQUIRE(heights.size() == grid.size());
    for (int ix = 0; ix < nx; ++ix) {
        Grid column = grid;
        column.nx = 1;
        column.x0 = grid.x0 + ix * grid.dx;
        const std::vector<double> alone = rail_heights(rail, reference, column);
        for (int iy = 0; iy < grid.ny; ++iy)
            CHECK_THAT(heights[static_cast<std::size_t>(iy * nx + ix)],
                       WithinAbs(alone[static_cast<std::size_t>(iy)], 1e-9));
    }
}

TEST_CASE("The next slice is the first one behind a place along the track") {
    const auto slices = waved();
    CHECK(slices->next_slice(-1000) == -150);
    CHECK(slices->next_slice(0) == 25);
    CHECK(slices->next_slice(24.9) == 25);
    CHECK(std::isinf(slices->next_slice(150)));
}

#include <catch2/catch_test_macros.hpp>

#include <stdexcept>

#include "contactd/subsurface_stress.hpp"

using namespace contactd;

TEST_CASE("Results of a block have z slowest and x fastest", "[stress]") {
    SubsurfaceRequest request;
    request.points = StressBlock{{0, 1}, {-1, 0, 1.0 / 3}, {0, -0.5}};

    CHECK(request.shape() == std::vector<std::size_t>{2, 3, 2});
    CHECK(request.point(1) == std::array{1.0, -1.0, 0.0});
    CHECK(request.point(2) == std::array{0.0, 0.0, 0.0});
    CHECK(request.point(11) == std::array{1.0, 1.0 / 3, -0.5});
    CHECK_THROWS_AS(request.point(12), std::out_of_range);
}

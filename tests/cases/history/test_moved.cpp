// Tests steps whose elements have moved.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "history/moved.hpp"

using namespace contactd;
using namespace contactd::cases;
using Catch::Matchers::WithinAbs;

TEST_CASE("elements that go on keep their size and lie whole elements away") {
    const Grid before{4, 3, 0.5, 0.25, -1, -0.375};
    const Grid found = continued({6, 2, 0.7, 0.9, -1.6, 0.1}, before);
    CHECK(found.nx == 6);
    CHECK(found.ny == 2);
    CHECK(found.dx == 0.5);
    CHECK(found.dy == 0.25);
    CHECK_THAT(found.x0, WithinAbs(-1.5, 1e-15));
    CHECK_THAT(found.y0, WithinAbs(0.125, 1e-15));
    CHECK(continued(before, before) == before);
}

TEST_CASE("values go with their places, and new elements have those of elsewhere") {
    const Grid from{2, 2, 1, 1, 0, 0}, to{3, 2, 1, 1, -1, 1};
    CHECK(on_grid({1, 2, 3, 4}, from, to) == std::vector<double>{0, 3, 4, 0, 0, 0});
    CHECK(on_grid({1, 2, 3, 4}, from, to, {9}) == std::vector<double>{9, 3, 4, 9, 9, 9});
    CHECK(on_grid({1, 2, 3, 4}, from, to, {10, 20, 30, 40, 50, 60}) == std::vector<double>{10, 3, 4, 40, 50, 60});
    CHECK(on_grid(std::vector<double>{}, from, to).empty());
}

TEST_CASE("particles that come new have the layer and the friction of the start") {
    const Grid from{2, 1, 1, 1, 0, 0}, to{2, 1, 1, 1, 1, 0};
    FrictionLaw friction;
    friction.mu = {0.3};
    friction.layer = InterfacialLayer{1e-5, 120, 10};
    const SurfaceState end{{1, 2}, {3, 4}, {5, 6}, {130, 140}, {0.2, 0.25}};
    const SurfaceState moved = on_grid(end, from, to, friction);
    CHECK(moved.pressure == std::vector<double>{2, 0});
    CHECK(moved.traction_x == std::vector<double>{4, 0});
    CHECK(moved.traction_y == std::vector<double>{6, 0});
    CHECK(moved.yield_stress == std::vector<double>{140, 120});
    CHECK(moved.friction_coefficient == std::vector<double>{0.25, 0.3});
}

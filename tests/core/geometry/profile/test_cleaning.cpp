// Tests cleaning of the points of measured profiles.
#include "geometry/profile/cleaning.hpp"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace contactd;
using namespace contactd::geometry;

TEST_CASE("points that repeat the one before are left out", "[profile]") {
    CHECK(without_repetitions({{0, 0}, {0, 5e-5}, {1, 0}, {1, 0}, {1, 2e-4}}) == Points{{0, 0}, {1, 0}, {1, 2e-4}});
}

TEST_CASE("a zigzag becomes its mean", "[profile]") {
    CHECK(without_zigzags({{0, 0}, {1, 0}, {0.6, 0}, {2, 0}}) == Points{{0, 0}, {0.8, 0}, {2, 0}});
    const Points corner{{0, 0}, {1, 0}, {1, 1}, {2, 1}};
    CHECK(without_zigzags(corner) == corner);
}

TEST_CASE("of a wheel remains what advances from its middle", "[profile]") {
    const Points wheel{{-60, 0}, {-70, 5}, {-69, 15}, {-55, 28}, {-40, 15},
                       {-30, 4}, {0, 0},   {60, -3},  {58, -6},  {61, -7}};
    CHECK(wheel_seen_from_above(wheel) ==
          Points{{-70, 5}, {-69, 15}, {-55, 28}, {-40, 15}, {-30, 4}, {0, 0}, {60, -3}, {61, -7}});
}

TEST_CASE("of a rail remains what nothing lies above", "[profile]") {
    const Points rail{{-35, 40}, {-37, 30}, {-36, 14}, {-20, 2}, {0, 0}, {20, 2}, {36, 14}, {37, 30}, {20, 40}};
    CHECK(rail_seen_from_above(rail) == Points{{-37, 30}, {-36, 14}, {-20, 2}, {0, 0}, {20, 2}, {36, 14}, {37, 30}});
    const Points lip{{0, 0}, {20, 5}, {30, 8}, {25, 6}, {35, 7}};  // returns above the earlier points
    CHECK(rail_seen_from_above(lip) == Points{{0, 0}, {20, 5}, {25, 6}, {35, 7}});
}

TEST_CASE("below a lip a rail's outline falls upright, to where the lower side comes out", "[profile]") {
    // The lip at (-25, 12) hides the face, down to a foot that is farther out.
    const Points worn{{-27, 34}, {-23, 33}, {-23.5, 25}, {-24, 16}, {-25, 12}, {-22, 8}, {0, 0}, {30, 4}};
    const Visible visible = visible_part(worn, {1, 5}, ProfileKind::rail);
    REQUIRE(visible.points.size() == 6);
    CHECK(visible.points[0] == ProfilePoint{-27, 34});
    CHECK(visible.points[1].y == Catch::Approx(-25.001));
    CHECK(visible.points[1].z == Catch::Approx(33 + 2.001 / 4));
    CHECK(visible.points[2] == ProfilePoint{-25, 12});
    CHECK(visible.kinks == std::vector<std::size_t>{1, 2, 3});
    CHECK(visible.places == std::vector<std::optional<std::size_t>>{0, std::nullopt, 4, 5, 6, 7});
    REQUIRE(visible.bridged.size() == 1);
    CHECK(visible.bridged[0] == std::pair{ProfilePoint{-27, 34}, ProfilePoint{-25, 12}});
    Points mirrored;
    for (auto point = worn.rbegin(); point != worn.rend(); ++point) mirrored.push_back({-point->y, point->z});
    const Visible other = visible_part(mirrored, {2, 6}, ProfileKind::rail);
    REQUIRE(other.points.size() == 6);
    CHECK(other.points[4].y == Catch::Approx(25.001));
    CHECK(other.points[4].z == Catch::Approx(visible.points[1].z));
    CHECK(other.kinks == std::vector<std::size_t>{2, 3, 4});
}

TEST_CASE("behind a wheel's lip its outline rises upright, and adds nothing to what the rail may touch", "[profile]") {
    // The back of the flange recedes above (-70, 20), and reappears 3 mm farther at (-73, 4).
    const Points wheel{{-73, 4}, {-69, 6}, {-69, 15}, {-70, 20}, {-60, 28}, {-40, 15}, {0, 0}, {60, -3}};
    const Visible visible = visible_part(wheel, {}, ProfileKind::wheel);
    REQUIRE(visible.points.size() == 7);
    CHECK(visible.points[1].y == Catch::Approx(-70.001));
    CHECK(visible.points[1].z == Catch::Approx(5.4995));
    CHECK(visible.points[2] == ProfilePoint{-70, 20});
    CHECK(visible.kinks == std::vector<std::size_t>{1, 2});
}

TEST_CASE("what noise hides is left out without a kink", "[profile]") {
    Points upright{{0, 0}, {30, 4}};
    for (int i = 0; i < 20; ++i) upright.push_back({35 + 1e-3 * i - (i % 4 == 3 ? 0.02 : 0), 10.0 + i});
    const Visible visible = visible_part(upright, {}, ProfileKind::rail);
    CHECK(visible.points.size() == upright.size() - 5);
    CHECK(visible.kinks.empty());
    CHECK(visible.bridged.empty());
}

TEST_CASE("kinks are sharp corners between smooth parts", "[profile]") {
    const Points roof{{0, 5}, {1, 4}, {2, 3}, {3, 2}, {4, 3}, {5, 4}, {6, 5}};
    CHECK(kinks_of(roof) == std::vector<std::size_t>{3});
    const Points noise{{0, 0}, {1, 1}, {2, 0}, {3, 1}, {4, 0}};
    CHECK(kinks_of(noise).empty());
    const Points gentle{{0, 0}, {1, 0}, {2, 0.5}, {3, 1}};
    CHECK(kinks_of(gentle).empty());
}

TEST_CASE("a point alone between two kinks is one, too", "[profile]") {
    const KinkRule each{.angle = 0.5, .rest = 0.1, .width = 0};
    const Points steps{{0, 5}, {1, 5}, {2, 5}, {3, 4}, {4, 3}, {5, 3}, {6, 3}, {7, 3}, {8, 4}, {9, 5}};
    CHECK(kinks_of(steps, each) == std::vector<std::size_t>{2, 3, 4, 7});
    const Points apart{{0, 5}, {1, 5}, {2, 5}, {3, 5}, {4, 4}, {5, 3}, {6, 2}, {7, 2}};
    CHECK(kinks_of(apart, each) == std::vector<std::size_t>{3, 6});
}

TEST_CASE("chords that cross are found", "[profile]") {
    const auto crossing = crossing_of({{0, 0}, {10, 0}, {10, 5}, {5, 5}, {5, -5}});
    CHECK(crossing.found());
    CHECK(crossing.first == 0);
    CHECK(crossing.second == 3);
    CHECK_FALSE(crossing_of({{0, 0}, {10, 0}, {10, 5}, {5, 5}, {5, 1}}).found());
    CHECK_FALSE(crossing_of({{0, 0}, {1, 0}, {2, 1}, {3, 3}}).found());
}

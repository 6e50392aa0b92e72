#include "contactd/rotated_strips.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <numbers>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"

using namespace contactd;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::StartsWith;
using Catch::Matchers::WithinAbs;
using enum Axis;

namespace {

constexpr Material steel{82000, 0.28};

double scale() {
    return half_space_coefficient(z, z, 0, 0, 0.5, 0.5, steel);
}

}  // namespace

TEST_CASE("The table of a slab is that of the half-space", "[rotated]") {
    const Grid grid = Grid::of_elements(7, 9, 0.5, 0.4);
    const StripTable table = rotated_strips({Slab{20, 100}}, grid, steel, LoadShape::constant);
    for (const Axis i : {x, y, z})
        for (const Axis j : {x, y, z})
            for (int I = 0; I < 9; ++I)
                for (int k = 0; k < 7; ++k)
                    CHECK_THAT(table(i, j, I, 4, k),
                               WithinAbs(half_space_coefficient(i, j, k * 0.5, (I - 4) * 0.4, 0.5, 0.4, steel),
                                         1e-15 * scale()));
}

TEST_CASE("A body has the same table however it lies", "[rotated]") {
    const Grid grid = Grid::of_elements(3, 30, 0.5, 0.5);
    const RailSection upright{0, RailSupport::cut, 10}, inclined{0.05, RailSupport::cut, 10};
    const StripTable table = rotated_strips({upright}, grid, steel, LoadShape::constant);
    const StripTable other = GENERATE_COPY(rotated_strips({inclined}, grid, steel, LoadShape::constant),
                                           rotated_strips({upright, 1, 2.5}, grid, steel, LoadShape::constant));
    for (std::size_t i = 0; i < table.values.size(); ++i)
        CHECK_THAT(other.values[i], WithinAbs(table.values[i], 1e-12 * scale()));
}

TEST_CASE("All round a cylinder every strip has the same neighbours", "[rotated]") {
    constexpr int strips = 24;
    const Grid grid = Grid::of_elements(2, strips, 0.5, 20 * std::numbers::pi / strips);
    const StripTable table = rotated_strips({Disc{10, 0}, 1, 0, true}, grid, steel, LoadShape::constant);
    for (int turn = 1; turn < strips; ++turn)
        for (const int apart : {1, 5, 11})
            CHECK_THAT(table(y, z, (turn + apart) % strips, turn, 1),
                       WithinAbs(table(y, z, apart, 0, 1), 1e-12 * scale()));
}

TEST_CASE("A section that can not be is refused where it was given", "[rotated]") {
    CHECK_THROWS_MATCHES(
        rotated_strips({Disc{10, 0}}, Grid::of_elements(3, 5, 1, 1), steel, LoadShape::constant, 0, "ics.section"),
        InvalidArgument, MessageMatches(StartsWith("ics.section has no clamped part")));
}

#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "contactd/strip_table.hpp"

using namespace contactd;

namespace {

using enum Axis;
constexpr Material steel{82000, 0.28}, rubber{20, 0.45};

IcTable half_space(const Material& material) {
    IcSpec spec;
    spec.material = material;
    spec.nx = 4;
    spec.ny = 3;
    spec.dx = 0.5;
    spec.dy = 0.3;
    return half_space_table(spec);
}

}  // namespace

TEST_CASE("the strip table of a flat surface is that of the surface at the distance of its strips") {
    const IcTable flat = half_space(steel);
    const StripTable table = strip_table_of(flat);
    REQUIRE(table.strips == 3);
    REQUIRE(table.nx == 4);
    for (const Axis i : {x, y, z})
        for (const Axis j : {x, y, z}) {
            CHECK(table.at(i, j, 2, 0, -3) == flat.at(i, j, -3, 2));
            CHECK(table.at(i, j, 0, 1, 2) == flat.at(i, j, 2, -1));
        }
}

TEST_CASE("a half-space is reciprocal, and symmetrising does not change it") {
    const StripTable table = strip_table_of(half_space(rubber));
    CHECK(reciprocity_defect(table) < 1e-15);
    const StripTable same = symmetrised(table);
    for (std::size_t at = 0; at < table.values.size(); ++at)
        REQUIRE(std::abs(same.values[at] - table.values[at]) <= 1e-15 * table(x, x, 0, 0, 0));
}

TEST_CASE("symmetrising halves what is not reciprocal") {
    StripTable table = strip_table_of(half_space(rubber));
    const double self = table(z, z, 1, 1, 0);
    table(x, z, 2, 0, 1) += 0.01 * self;
    CHECK(std::abs(reciprocity_defect(table) - 0.01) < 1e-12);
    const StripTable mean = symmetrised(table);
    CHECK(reciprocity_defect(mean) == 0);
    CHECK(mean(z, x, 0, 2, 1) == -mean(x, z, 2, 0, 1));
}

TEST_CASE("a half-space is its own mirror image") {
    const StripTable table = strip_table_of(half_space(steel));
    CHECK(mirrored(table) == table);
}

TEST_CASE("a mirror image has strips in reverse order and the signs of y reversed") {
    StripTable table(2, 3);
    for (std::size_t at = 0; at < table.values.size(); ++at) table.values[at] = static_cast<double>(at);
    const StripTable image = mirrored(table);
    CHECK(image(x, x, 0, 1, 1) == table(x, x, 2, 1, 1));
    CHECK(image(y, y, 0, 0, 1) == table(y, y, 2, 2, 1));
    CHECK(image(y, z, 0, 2, 0) == -table(y, z, 2, 0, 0));
    CHECK(mirrored(image) == table);
}

TEST_CASE("flat bodies make the same pair by either kind of table") {
    const IcTable upper = half_space(rubber), lower = half_space(steel);
    CHECK(pair_of(strip_table_of(upper), strip_table_of(lower)) == strip_table_of(pair_of(upper, lower)));
}

TEST_CASE("equal bodies that lie symmetrically couple nothing") {
    const StripTable table = strip_table_of(half_space(steel)), pair = pair_of(table, table);
    CHECK(pair(z, z, 1, 0, 2) == 2 * table(z, z, 1, 0, 2));
    CHECK(pair(y, z, 1, 0, 2) == 0);
    CHECK(pair(x, z, 1, 0, 2) == 0);
}

TEST_CASE("a part of a strip table has the strips and offsets that are asked for") {
    const StripTable table = strip_table_of(half_space(steel)), part = cropped(table, 1, 2, 3, 2.0);
    CHECK(part.strips == 2);
    CHECK(part.nx == 3);
    CHECK(part(x, y, 0, 1, 2) == 2 * table(x, y, 1, 2, 2));
    CHECK_THROWS_AS(cropped(table, 2, 2, 3), InvalidArgument);
    CHECK_THROWS_AS(cropped(table, 0, 3, 5), InvalidArgument);
}

TEST_CASE("strip tables of unlike extents are no pair") {
    const StripTable table = strip_table_of(half_space(steel));
    CHECK_THROWS_AS(pair_of(cropped(table, 0, 2, 4), table), InvalidArgument);
}

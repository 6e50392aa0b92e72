// Stresses below the surface, through the library.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "client/cntc/calls.hpp"
#include "contactd/subsurface.hpp"

using namespace contactd::cntc::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

struct Block {
    Case& contact;
    int number = 1;

    void add(int kind, Values x, Values y, Values z) {
        int nx = static_cast<int>(x.size()), ny = static_cast<int>(y.size()), nz = static_cast<int>(z.size());
        subs_addblock(contact.ire(), contact.icp(), &number, &kind, &nx, &ny, &nz, x.data(), y.data(), z.data());
    }
    int calculate() {
        int error = -1000;
        subs_calculate(contact.ire(), contact.icp(), &error);
        return error;
    }
    std::array<int, 3> size() {
        std::array n{0, 0, 0};
        subs_getblocksize(contact.ire(), contact.icp(), &number, &n[0], &n[1], &n[2]);
        return n;
    }
    Values column(int code) {
        const auto [nx, ny, nz] = size();
        int length = nx * ny * nz, columns = 1;
        Values values(static_cast<std::size_t>(length));
        subs_getresults(contact.ire(), contact.icp(), &number, &length, &columns, &code, values.data());
        return values;
    }
};

constexpr double depth = 1.5;

}  // namespace

TEST_CASE("stresses are those of core, in the frame of the contact") {
    Case contact = wheel(1);
    contact.material(0.28, 0.1, 82000, 41000);
    Block block{contact};
    const Values x{-3, 0.2, 4}, y{-1, 2};
    block.add(9, x, y, {depth, -depth});
    REQUIRE(contact.calculate() == 0);

    REQUIRE(block.calculate() == 0);

    CHECK(block.size() == std::array{3, 2, 2});
    const Tractions t = contact.tractions();
    const Values p = contact.potential_back();
    const contactd::Grid grid{25, 25, p[4], p[5], p[2] - p[4] / 2, p[3] - p[5] / 2};
    contactd::Observer observer;
    for (const auto body : {contactd::ContactBody::upper, contactd::ContactBody::lower}) {
        const bool upper = body == contactd::ContactBody::upper;
        const auto stress =
            contactd::subsurface_stress(grid, contactd::tractions_on(body, t.pn, t.px, t.py), upper ? 0.28 : 0.1,
                                        contactd::StressBlock{x, y, {-depth}}, observer);
        const double turn = upper ? -1 : 1;  // its frame is mirrored
        for (std::size_t i = 0; i < 6; ++i) {
            const std::size_t k = upper ? i : 6 + i;
            const auto at = [&](int column) { return block.column(column)[k]; };
            CHECK_THAT(at(1), WithinAbs(x[i % 3], 1e-12));
            CHECK_THAT(at(2), WithinAbs(y[i / 3], 1e-12));
            CHECK_THAT(at(3), WithinAbs(-turn * depth, 1e-12));
            const double scale = 1e-6 * contact.max_pressure();
            CHECK_THAT(at(13), WithinAbs(stress.xx[i], scale));
            CHECK_THAT(at(17), WithinAbs(stress.yy[i], scale));
            CHECK_THAT(at(21), WithinAbs(stress.zz[i], scale));
            CHECK_THAT(at(14), WithinAbs(stress.xy[i], scale));
            CHECK_THAT(at(15), WithinAbs(turn * stress.xz[i], scale));
            CHECK_THAT(at(18), WithinAbs(turn * stress.yz[i], scale));
            CHECK_THAT(at(8), WithinAbs(stress.von_mises[i], scale));
        }
    }
}

TEST_CASE("stresses are symmetric, and invariants those of the tensor") {
    Case contact = wheel(1);
    Block block{contact};
    block.add(9, {-3, 0.2, 4}, {-1, 2}, {0.5, 2, -1});
    REQUIRE(contact.calculate() == 0);
    REQUIRE(block.calculate() == 0);
    std::array<Values, 22> s;
    for (int column = 7; column <= 21; ++column) s[static_cast<std::size_t>(column)] = block.column(column);
    const double scale = contact.max_pressure();

    for (std::size_t i = 0; i < 18; ++i) {
        CHECK(s[14][i] == s[16][i]);
        CHECK(s[15][i] == s[19][i]);
        CHECK(s[18][i] == s[20][i]);
        const double p1 = s[10][i], p2 = s[11][i], p3 = s[12][i];
        CHECK(p1 >= p2);
        CHECK(p2 >= p3);
        CHECK_THAT(s[7][i], WithinAbs((s[13][i] + s[17][i] + s[21][i]) / 3, 1e-12 * scale));
        CHECK_THAT(p1 + p2 + p3, WithinAbs(3 * s[7][i], 1e-12 * scale));
        const double squares = s[13][i] * s[13][i] + s[17][i] * s[17][i] + s[21][i] * s[21][i] +
                               2 * (s[14][i] * s[14][i] + s[15][i] * s[15][i] + s[18][i] * s[18][i]);
        CHECK_THAT(p1 * p1 + p2 * p2 + p3 * p3, WithinAbs(squares, 1e-12 * scale * scale));
        const double mises = ((p1 - p2) * (p1 - p2) + (p2 - p3) * (p2 - p3) + (p3 - p1) * (p3 - p1)) / 2;
        CHECK_THAT(s[8][i], WithinAbs(std::sqrt(mises), 1e-9 * scale));
        CHECK_THAT(s[9][i], WithinAbs(p1 - p3, 1e-12 * scale));
    }
}

TEST_CASE("at the surface the bodies are pressed") {
    Case contact = wheel(1);
    Block block{contact};
    block.add(1, {}, {}, {2, 1e-6, 1});
    REQUIRE(contact.calculate() == 0);

    REQUIRE(block.calculate() == 0);

    CHECK(block.size() == std::array{25, 25, 2});
    const Values zz = block.column(21), xz = block.column(19), depths = block.column(3);
    const Tractions t = contact.tractions();
    for (std::size_t i = 0; i < 625; ++i) {
        CHECK_THAT(zz[i], WithinAbs(-t.pn[i], 2e-3 * contact.max_pressure()));
        // The upper body's outward normal is -z: what acts on it along x is -xz.
        CHECK_THAT(-xz[i], WithinAbs(t.px[i], 2e-3 * contact.max_pressure()));
        CHECK_THAT(depths[625 + i], WithinAbs(1 + 1e-6, 1e-12));
    }
}

TEST_CASE("points by elements are those by coordinates") {
    Case contact = wheel(1);
    Block block{contact};
    REQUIRE(contact.calculate() == 0);
    const Values p = contact.potential_back();
    const auto x = [&](int i) { return p[2] + (i - 1) * p[4]; };
    const auto y = [&](int i) { return p[3] + (i - 1) * p[5]; };
    block.add(9, {x(3), x(8), x(13)}, {y(2), y(4)}, {1, 1.5, 2});
    REQUIRE(block.calculate() == 0);
    const Values expected = block.column(8);
    const auto [kind, xs, ys, zs] =
        GENERATE(table<int, Values, Values, Values>({{2, {3, 5, 14}, {2, 2, 5}, {3, 1, 0.5}},
                                                     {3, {3, 8, 13}, {2, 4}, {3, 1, 0.5}},
                                                     {6, {3, 5, 14}, {2, 2, 5}, {1, 1.5, 2}},
                                                     {7, {3, 8, 13}, {2, 4}, {1, 1.5, 2}}}));
    CAPTURE(kind);

    block.add(kind, xs, ys, zs);

    REQUIRE(block.calculate() == 0);
    const Values found = block.column(8);
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) CHECK_THAT(found[i], WithinRel(expected[i], 1e-9));
}

TEST_CASE("stresses are N per square of the length of the units") {
    Case contact(1);
    contact.flag(1933, 1935);
    contact.material(0.28, 0.28, 82e9, 82e9);
    contact.coulomb(0.3);
    contact.hertz(-3, {25, 25, 0.006, 0.004, 1.1});
    contact.normal_force(50000);
    contact.creepages(0.002, 0.001, 0.1);
    Block in_m{contact};
    in_m.add(9, {0.001}, {-0.001}, {0.002});
    REQUIRE(contact.calculate() == 0);
    REQUIRE(in_m.calculate() == 0);
    Case other = wheel(2);
    Block in_mm{other};
    in_mm.add(9, {1}, {-1}, {2});
    REQUIRE(other.calculate() == 0);
    REQUIRE(in_mm.calculate() == 0);

    for (int column = 7; column <= 21; ++column)
        CHECK_THAT(in_m.column(column)[0] * 1e-6, WithinRel(in_mm.column(column)[0], 1e-4));
    CHECK_THAT(in_m.column(3)[0], WithinRel(0.002, 1e-12));
}

TEST_CASE("a block replaces those with its number and larger ones") {
    Case contact = wheel(1);
    Block first{contact, 1}, second{contact, 2};
    first.add(9, {0}, {0}, {1});
    second.add(9, {0, 1}, {0}, {1});
    REQUIRE(contact.calculate() == 0);
    REQUIRE(first.calculate() == 0);
    CHECK(second.column(8).size() == 2);

    first.add(9, {0, 1, 2}, {0}, {1});

    CHECK(first.size() == std::array{3, 1, 1});
    CHECK(second.size() == std::array{0, 0, 0});
    CHECK(last_code() == -39);
}

TEST_CASE("stresses go with the solution they are of") {
    Case contact = wheel(1);
    Block block{contact};
    block.add(9, {0}, {0}, {1});
    CHECK(block.calculate() == -39);  // nothing was solved
    REQUIRE(contact.calculate() == 0);
    CHECK(std::isnan(block.column(8)[0]));
    REQUIRE(block.calculate() == 0);
    CHECK(block.column(8)[0] > 0);
    REQUIRE(contact.calculate() == 0);
    CHECK(std::isnan(block.column(8)[0]));
}

TEST_CASE("displacements below the surface are those of its elements where the bodies meet") {
    Case contact = wheel(1);
    contact.material(0.28, 0.1, 82000, 41000);
    Block block{contact};
    constexpr double just_below = 1e-9;
    block.add(5, {}, {}, {just_below, -just_below});
    REQUIRE(contact.calculate() == 0);
    REQUIRE(block.calculate() == 0);
    constexpr int elements = 625, middle = elements / 2;
    int length = elements;
    Values un(elements), ux(elements), uy(elements);
    cntc_getdisplacements(contact.ire(), contact.icp(), &length, un.data(), ux.data(), uy.data());
    for (const auto& [column, surface] : {std::pair(4, ux), std::pair(5, uy), std::pair(6, un)}) {
        const Values below = block.column(column);
        REQUIRE(below.size() == 2 * elements);
        CHECK_THAT(below[middle] - below[elements + middle], WithinRel(surface[middle], 1e-6));
    }
    const double up = block.column(6)[middle], down = block.column(6)[elements + middle];
    CHECK(up > 0);    // the upper body is pressed upwards
    CHECK(down < 0);  // and the lower one downwards
    contact.flag(1933, 1936);
    CHECK_THAT(block.column(6)[middle], WithinRel(up / 1000, 1e-12));
}

TEST_CASE("a column that does not exist leaves the others alone") {
    Case contact = wheel(1);
    Block block{contact};
    block.add(9, {0}, {0}, {1});
    REQUIRE(contact.calculate() == 0);
    REQUIRE(block.calculate() == 0);
    int length = 1, columns = 3;
    std::array codes{8, 22, 3};
    Values values(3);

    subs_getresults(contact.ire(), contact.icp(), &block.number, &length, &columns, codes.data(), values.data());

    CHECK(last_code() == -39);
    CHECK(values[0] > 0);
    CHECK(std::isnan(values[1]));
    CHECK(values[2] == 1);
}

TEST_CASE("a block that is refused is not there, and no solve minds") {
    Case contact = wheel(1);
    Block block{contact};
    block.add(9, {0}, {0}, {1});
    const auto [kind, x, z] = GENERATE(table<int, Values, Values>({{4, {0}, {1}},
                                                                   {9, {no_number}, {1}},
                                                                   {9, {}, {1}},
                                                                   {1, {}, {0, 0, 1}},
                                                                   {1, {}, {2.5, 0, 1}},
                                                                   {3, {1.5}, {1, 0, 1}}}));
    block.add(kind, x, {1}, z);
    CHECK(last_code() == -39);

    CHECK(contact.calculate() == 0);
    CHECK(block.calculate() == 0);
    CHECK(block.size() == std::array{0, 0, 0});
    CHECK(last_code() == -39);
}

TEST_CASE("blocks of elements that there are not, and of too many points, are refused") {
    Case contact = wheel(1);
    Block block{contact};
    REQUIRE(contact.calculate() == 0);
    const auto [kind, x, z] = GENERATE(table<int, Values, Values>({{3, {26}, {1, 0, 1}},
                                                                   {3, {0}, {1, 0, 1}},
                                                                   {2, {1, 0, 5}, {1, 0, 1}},
                                                                   {2, {1, 1, 26}, {1, 0, 1}},
                                                                   {9, Values(4000), {0, 1, 2, 3}}}));
    block.add(kind, x, kind == 2 ? Values{1, 1, 2} : kind == 9 ? Values(4000) : Values{1}, z);
    CHECK(last_code() == 0);
    CHECK(block.calculate() == -39);
}

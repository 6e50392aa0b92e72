#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contact/contact_cases.hpp"
#include "contactd/given_ics.hpp"
#include "contactd/half_space.hpp"
#include "influence/half_space_cases.hpp"
#include "operators/convolution.hpp"
#include "operators/shifted_operator.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

ShiftedTable random_table(int nx, int ny) {
    ShiftedTable table(nx, ny);
    table.values = random_values(table.values.size(), 5);
    return table;
}

Values dense_product(const ShiftedTable& table, Axis i, Axis j, const Values& p) {
    Values u(p.size());
    const int n = table.nx * table.ny;
    for (int to = 0; to < n; ++to)
        for (int from = 0; from < n; ++from)
            u[static_cast<std::size_t>(to)] +=
                table(i, j, to % table.nx - from % table.nx, to / table.nx - from / table.nx) *
                p[static_cast<std::size_t>(from)];
    return u;
}

void check_equal(const Values& computed, const Values& expected) {
    for (std::size_t i = 0; i < computed.size(); ++i) CHECK_THAT(computed[i], WithinAbs(expected[i], 1e-12));
}

}  // namespace

TEST_CASE("shifted operator equals the dense sum", "[shifted]") {
    const auto [nx, ny] = GENERATE(std::pair{1, 1}, std::pair{1, 9}, std::pair{8, 1}, std::pair{2, 2},
                                   std::pair{13, 11}, std::pair{5, 18});
    CAPTURE(nx, ny);
    const ShiftedTable table = random_table(nx, ny);
    const ShiftedOperator shifted(table);
    const std::size_t n = shifted.size();
    const Values px = random_values(n, 1), py = random_values(n, 2), pz = random_values(n, 3);
    Values ux(n), uy(n);

    shifted.tangential(px, py, ux, uy);

    const Values xx = dense_product(table, Axis::x, Axis::x, px), xy = dense_product(table, Axis::x, Axis::y, py);
    const Values yx = dense_product(table, Axis::y, Axis::x, px), yy = dense_product(table, Axis::y, Axis::y, py);
    for (std::size_t e = 0; e < n; ++e) {
        CHECK_THAT(ux[e], WithinAbs(xx[e] + xy[e], 1e-12));
        CHECK_THAT(uy[e], WithinAbs(yx[e] + yy[e], 1e-12));
    }
    shifted.tangential_of_normal(pz, ux, uy);
    check_equal(ux, dense_product(table, Axis::x, Axis::z, pz));
    check_equal(uy, dense_product(table, Axis::y, Axis::z, pz));
}

TEST_CASE("displacements on a shifted grid are those the particles have there", "[shifted]") {
    // A shift by one element along x gives the displacements of the neighbour.
    const int nx = 9, ny = 6;
    const Material upper{3, 0.4}, lower{1, 0.1};
    const auto pair = [&](int extent_x) {
        return pair_of(half_space_table(analytic(upper, 1, 0.5, extent_x, ny)),
                       half_space_table(analytic(lower, 1, 0.5, extent_x, ny)));
    };
    const ConvolutionOperator influence(pair(nx), nx, ny);
    const ShiftedOperator shifted(shifted_table(pair(nx + 1), {}, Grid::of_elements(nx, ny, 1, 0.5), 1, 0));
    REQUIRE(shifted.coupled());
    const Values p = random_values(influence.size(), 1), q = random_values(influence.size(), 2);
    Values ux(p.size()), uy(p), ahead_x(p), ahead_y(p);
    const auto check_neighbours = [&] {
        for (std::size_t e = 0; e < p.size(); ++e) {
            if (e % nx == nx - 1) continue;
            CHECK_THAT(ahead_x[e], WithinAbs(ux[e + 1], 1e-13));
            CHECK_THAT(ahead_y[e], WithinAbs(uy[e + 1], 1e-13));
        }
    };
    influence.tangential(p, q, ux, uy);
    shifted.tangential(p, q, ahead_x, ahead_y);
    check_neighbours();
    influence.tangential_of_normal(p, ux, uy);
    shifted.tangential_of_normal(p, ahead_x, ahead_y);
    check_neighbours();
}

TEST_CASE("bodies alike give no shifted displacements across", "[shifted]") {
    const Grid grid = Grid::of_elements(4, 4, 1, 1);
    const ShiftedOperator shifted(shifted_half_spaces({{{1, 0.3}, {1, 0.3}}, LoadShape::constant}, grid, 0.5, 0));
    CHECK_FALSE(shifted.coupled());
    Values ux(16, 1.0), uy(16, 1.0);
    shifted.tangential_of_normal(Values(16, 3.0), ux, uy);
    CHECK(ux == Values(16));
    CHECK(uy == Values(16));
}

TEST_CASE("coarser shifted operator stands for elements of twice the size", "[shifted]") {
    const int nx = 40, ny = 21;
    const ShiftedTable table = random_table(nx, ny);
    const ShiftedOperator fine(table);
    const StepOperator* coarse = fine.coarser();
    REQUIRE(coarse != nullptr);
    REQUIRE(coarse->size() == 20 * 11);
    Values p_coarse(coarse->size()), ux_coarse(p_coarse), uy_coarse(p_coarse), p(fine.size()), ux(p), uy(p);
    p_coarse[3 * 20 + 4] = 1;
    for (const int iy : {6, 7})
        for (const int ix : {8, 9}) p[static_cast<std::size_t>(iy * nx + ix)] = 1;

    coarse->tangential(p_coarse, p_coarse, ux_coarse, uy_coarse);
    fine.tangential(p, p, ux, uy);

    for (int Y = 0; Y < 10; ++Y)
        for (int X = 0; X < 20; ++X) {
            double mean = 0;
            for (const int iy : {2 * Y, 2 * Y + 1})
                for (const int ix : {2 * X, 2 * X + 1}) mean += ux[static_cast<std::size_t>(iy * nx + ix)] / 4;
            CHECK_THAT(ux_coarse[static_cast<std::size_t>(Y * 20 + X)], WithinAbs(mean, 1e-12));
        }
}

TEST_CASE("small grids have no coarser shifted operator", "[shifted]") {
    CHECK(ShiftedOperator(random_table(10, 1)).coarser() == nullptr);
}

TEST_CASE("shifted operator on a box takes the offsets that fit into it", "[shifted]") {
    const ShiftedTable table = random_table(9, 8);
    const auto part = ShiftedOperator(table).on({2, 1, 6, 5});
    REQUIRE(part->size() == 30);
    const Values p = random_values(30, 4), none(30);
    Values ux(30), uy(30);

    part->tangential(p, none, ux, uy);

    check_equal(ux, dense_product(cropped(table, 6, 5), Axis::x, Axis::x, p));
    check_equal(uy, dense_product(cropped(table, 6, 5), Axis::y, Axis::x, p));
}

TEST_CASE("the inverse of a step with something added undoes its product away from the border", "[shifted]") {
    const auto [nx, ny] = GENERATE(std::pair{40, 40}, std::pair{64, 1}, std::pair{31, 50});
    CAPTURE(nx, ny);
    const Material material{3, 0.3};
    const Grid grid = Grid::of_elements(nx, ny, 1, 0.7);
    const IcTable body = half_space_table(analytic(material, 1, 0.7, nx, ny)), pair = pair_of(body, body);
    const ShiftedOperator change(
        change_over_step(pair, shifted_half_spaces({{material, material}, LoadShape::constant}, grid, 0.8, 0.3)));
    const double added = GENERATE(0.3, 2.0) * pair(Axis::x, Axis::x, 0, 0);
    const std::size_t n = change.size();
    Values rx = random_values(n, 1), ry = random_values(n, 2), zx(n), zy(n), ux(n), uy(n);

    change.inverse(added)->tangential(rx, ry, zx, zy);

    change.tangential(zx, zy, ux, uy);
    double error = 0, size = 0;
    for (int iy = 0; iy < ny; ++iy)
        for (int ix = nx / 4; ix < 3 * nx / 4; ++ix) {
            if (ny > 1 && (iy < ny / 4 || iy >= 3 * ny / 4)) continue;
            const auto i = static_cast<std::size_t>(iy * nx + ix);
            error += std::pow(ux[i] + added * zx[i] - rx[i], 2) + std::pow(uy[i] + added * zy[i] - ry[i], 2);
            size += rx[i] * rx[i] + ry[i] * ry[i];
        }
    CHECK(std::sqrt(error / size) < 0.1);
}

TEST_CASE("an inverse is one for the shift it was made for", "[shifted]") {
    const ShiftedOperator shifted(random_table(6, 5));
    CHECK(shifted.inverse(2.0) == shifted.inverse(2.0));
    CHECK(shifted.inverse(2.0) != shifted.inverse(3.0));
}

TEST_CASE("inverses of rough tables stay bounded by what is added", "[shifted]") {
    const ShiftedOperator shifted(random_table(9, 7));  // of no sign
    const std::size_t n = shifted.size();
    const Values r = random_values(n, 4);
    Values zx(n), zy(n);
    shifted.inverse(0.5)->tangential(r, r, zx, zy);
    double size = 0, bound = 0;
    for (std::size_t i = 0; i < n; ++i) {
        size += zx[i] * zx[i] + zy[i] * zy[i];
        bound += 2 * r[i] * r[i];
    }
    CHECK(std::sqrt(size) <= 2 / 0.5 * std::sqrt(bound) * (1 + 1e-12));
}

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <thread>

#include "contact/contact_cases.hpp"
#include "contactd/error.hpp"
#include "operators/convolution.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

IcTable dissimilar_pair(const Grid& grid) {
    const auto body = [&](const Material& material) {
        IcSpec spec;
        spec.material = material;
        spec.dx = grid.dx;
        spec.dy = grid.dy;
        spec.nx = grid.nx;
        spec.ny = grid.ny;
        return half_space_table(spec);
    };
    return pair_of(body({3, 0.4}), body({1, 0.1}));
}

// Creates a table without a closed form: every component has its own values, odd ones zero on the axes.
IcTable rough_table(const Grid& grid) {
    IcTable table = dissimilar_pair(grid);
    const Values noise = random_values(table.values.size(), 7, 0.9, 1.1);
    for (std::size_t i = 0; i < noise.size(); ++i) table.values[i] *= noise[i];
    return table;
}

void check_equal(const Values& computed, const Values& expected) {
    REQUIRE(computed.size() == expected.size());
    for (std::size_t i = 0; i < computed.size(); ++i)
        CHECK_THAT(computed[i], WithinAbs(expected[i], 1e-13 * largest(expected)));
}

void check_against_dense_sums(const ConvolutionOperator& influence, const IcTable& table, int nx, int ny) {
    const std::size_t n = influence.size();
    const Values px = random_values(n, 1), py = random_values(n, 2), pz = random_values(n, 3);
    Values ux(n), uy(n), uz(n);
    influence.normal(pz, uz);
    influence.tangential(px, py, ux, uy);
    check_equal(uz, dense_product(table, Axis::z, Axis::z, nx, ny, pz));
    check_equal(ux, sum(dense_product(table, Axis::x, Axis::x, nx, ny, px),
                        dense_product(table, Axis::x, Axis::y, nx, ny, py)));
    check_equal(uy, sum(dense_product(table, Axis::y, Axis::x, nx, ny, px),
                        dense_product(table, Axis::y, Axis::y, nx, ny, py)));
}

void check_coupling_against_dense_sums(const InfluenceOperator& influence, const IcTable& table, int nx, int ny) {
    const std::size_t n = influence.size();
    const Values px = random_values(n, 4), py = random_values(n, 5), pz = random_values(n, 6);
    Values ux(n), uy(n), uz(n);
    influence.normal_of_tangential(px, py, uz);
    influence.tangential_of_normal(pz, ux, uy);
    check_equal(uz, sum(dense_product(table, Axis::z, Axis::x, nx, ny, px),
                        dense_product(table, Axis::z, Axis::y, nx, ny, py)));
    check_equal(ux, dense_product(table, Axis::x, Axis::z, nx, ny, pz));
    check_equal(uy, dense_product(table, Axis::y, Axis::z, nx, ny, pz));
}

}  // namespace

TEST_CASE("convolution equals the dense sum", "[convolution]") {
    const auto [nx, ny] =
        GENERATE(std::pair{1, 1}, std::pair{1, 9}, std::pair{8, 1}, std::pair{2, 2}, std::pair{13, 11}, std::pair{8, 6},
                 std::pair{5, 17}, std::pair{23, 3}, std::pair{128, 2}, std::pair{129, 3});
    CAPTURE(nx, ny);
    const IcTable table = rough_table(Grid::of_elements(nx + 2, ny + 1, 1, 0.7));
    const ConvolutionOperator influence(table, nx, ny);
    CHECK(influence.diagonal(Axis::y) == Values(influence.size(), table(Axis::y, Axis::y, 0, 0)));
    check_against_dense_sums(influence, table, nx, ny);
    check_coupling_against_dense_sums(influence, table, nx, ny);
    CHECK(influence.coupled() == (nx * ny > 1));
}

TEST_CASE("without Poisson's effect the tangential directions are on their own", "[convolution]") {
    IcTable table = rough_table(Grid::of_elements(7, 5, 1, 0.7));
    for (const auto& [i, j] : {std::pair{Axis::x, Axis::y}, {Axis::y, Axis::x}})
        std::fill_n(&table(i, j, 0, 0), table.component_size(), 0.0);
    check_against_dense_sums(ConvolutionOperator(table, 7, 5), table, 7, 5);
}

TEST_CASE("an uncoupled operator gives no displacements across", "[convolution]") {
    IcTable table = half_space_pair(Grid::of_elements(6, 4, 1, 1), {1, 0.3});
    table(Axis::x, Axis::z, 2, 1) = 1e-9;  // rounding
    const ConvolutionOperator influence(table, 6, 4);
    CHECK_FALSE(influence.coupled());
    const Values p = random_values(24, 1);
    Values u(24, 7.0), uy(24, 7.0);
    influence.normal_of_tangential(p, p, u);
    CHECK(u == Values(24));
    influence.tangential_of_normal(p, u, uy);
    CHECK(u == Values(24));
    CHECK(uy == Values(24));
}

TEST_CASE("convolution skips rows without traction correctly", "[convolution]") {
    const IcTable table = rough_table(Grid::of_elements(6, 7, 1, 1));
    const ConvolutionOperator influence(table, 6, 7);
    Values p(42), u(42);
    p[20] = 2;
    influence.normal(random_values(42, 5), u);  // leaves data in the workspace
    influence.normal(p, u);
    check_equal(u, dense_product(table, Axis::z, Axis::z, 6, 7, p));
}

TEST_CASE("convolution of both tangential components skips rows without traction correctly", "[convolution]") {
    const int nx = 6, ny = 11;
    const IcTable table = rough_table(Grid::of_elements(nx, ny, 1, 1));
    const ConvolutionOperator influence(table, nx, ny);
    const Values noise = random_values(influence.size(), 5), none(influence.size());
    Values p(influence.size()), ux(influence.size()), uy(ux);
    p[56] = 2;
    influence.tangential(noise, noise, ux, uy);  // leaves data in the workspace
    influence.tangential(p, none, ux, uy);
    check_equal(ux, dense_product(table, Axis::x, Axis::x, nx, ny, p));
    check_equal(uy, dense_product(table, Axis::y, Axis::x, nx, ny, p));
    influence.tangential(none, p, ux, uy);
    check_equal(ux, dense_product(table, Axis::x, Axis::y, nx, ny, p));
    check_equal(uy, dense_product(table, Axis::y, Axis::y, nx, ny, p));
}

TEST_CASE("one operator serves several threads at once", "[convolution]") {
    const int nx = 11, ny = 14;
    const IcTable table = rough_table(Grid::of_elements(nx, ny, 1, 1));
    const ConvolutionOperator shared(table, nx, ny);
    const Values p = random_values(shared.size(), 3);
    const Values expected = dense_product(table, Axis::z, Axis::z, nx, ny, p);
    std::vector<Values> results(4, Values(shared.size()));
    std::vector<std::thread> threads;
    for (Values& u : results)
        threads.emplace_back([&] {
            for (int repeat = 0; repeat < 50; ++repeat) {
                const ConvolutionOperator own(table, nx, ny - repeat % 3);  // plans while others compute
                shared.normal(p, u);
            }
        });
    for (std::thread& thread : threads) thread.join();
    for (const Values& u : results) check_equal(u, expected);
}

TEST_CASE("preconditioner is symmetric and positive on any contact set", "[convolution]") {
    const auto [nx, ny, aspect] =
        GENERATE(std::tuple{7, 6, 1.0}, std::tuple{1, 20, 1.0}, std::tuple{9, 4, 10.0}, std::tuple{5, 9, 0.01});
    const Axis axis = GENERATE(Axis::x, Axis::y, Axis::z);
    const ConvolutionOperator influence(rough_table(Grid::of_elements(nx, ny, aspect, 1)), nx, ny);
    const std::size_t n = influence.size();
    std::vector<std::size_t> set;
    const Values chance = random_values(n, 11, 0, 1);
    for (std::size_t i = 0; i < n; ++i)
        if (chance[i] < 0.7) set.push_back(i);
    std::vector<Values> matrix;
    for (const std::size_t j : set) {
        Values unit(n), column(n);
        unit[j] = 1;
        influence.precondition(axis, unit, column);
        Values& restricted = matrix.emplace_back();
        for (const std::size_t i : set) restricted.push_back(column[i]);
    }
    for (std::size_t i = 0; i < set.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) CHECK_THAT(matrix[i][j], WithinAbs(matrix[j][i], 1e-12 * matrix[0][0]));
    for (std::size_t k = 0; k < set.size(); ++k) {  // elimination has positive pivots exactly for positive matrices
        REQUIRE(matrix[k][k] > 0);
        for (std::size_t i = k + 1; i < set.size(); ++i)
            for (std::size_t j = k + 1; j < set.size(); ++j) matrix[i][j] -= matrix[i][k] * matrix[k][j] / matrix[k][k];
    }
}

TEST_CASE("coarser operator stands for elements of twice the size", "[convolution]") {
    const int nx = 40, ny = 21;
    const Grid grid = Grid::of_elements(nx, ny, 1, 1);
    const ConvolutionOperator fine(dissimilar_pair(grid), nx, ny);
    const CoarserGrid* grid_of_coarse = fine.coarser();
    REQUIRE(grid_of_coarse != nullptr);
    CHECK(grid_of_coarse->along_x() == 2);
    CHECK(grid_of_coarse->along_y() == 2);
    const InfluenceOperator* coarse = &grid_of_coarse->influence();
    REQUIRE(coarse->size() == 20 * 11);
    REQUIRE(coarse->coupled());
    Values p_coarse(coarse->size()), u_coarse(coarse->size()), p(fine.size()), u(fine.size()), mean(coarse->size());
    p_coarse[3 * 20 + 4] = 1;
    for (const int iy : {6, 7})
        for (const int ix : {8, 9}) p[at(grid, ix, iy)] = 1;

    coarse->normal(p_coarse, u_coarse);
    fine.normal(p, u);
    grid_of_coarse->average(u, mean);

    for (std::size_t i = 0; i < 20 * 10; ++i) CHECK_THAT(u_coarse[i], WithinAbs(mean[i], 1e-13));
    Values other_coarse(coarse->size()), other(fine.size());
    coarse->tangential_of_normal(p_coarse, u_coarse, other_coarse);
    fine.tangential_of_normal(p, u, other);
    grid_of_coarse->average(u, mean);
    for (std::size_t i = 0; i < 20 * 10; ++i) CHECK_THAT(u_coarse[i], WithinAbs(mean[i], 1e-13));
}

TEST_CASE("small grids have no coarser operator", "[convolution]") {
    const ConvolutionOperator influence(half_space_pair(Grid::of_elements(10, 1, 1, 1), {1, 0.3}), 10, 1);
    CHECK(influence.coarser() == nullptr);
}

TEST_CASE("a convenient box holds what is needed, with a margin where the contact may grow", "[convolution]") {
    const ConvolutionOperator influence(half_space_pair(Grid::of_elements(40, 30, 0.1, 0.1), {200, 0.3}), 40, 30);
    const ElementBox needed = GENERATE(ElementBox{3, 4, 11, 9}, ElementBox{29, 0, 11, 12}, ElementBox{20, 20, 1, 1});
    for (const bool may_grow : {true, false}) {
        const ElementBox box = influence.boxes()->convenient(needed, may_grow);
        CHECK(box.size() < influence.size());
        CHECK((box.first_x >= 0 && box.first_x <= needed.first_x));
        CHECK((box.first_y >= 0 && box.first_y <= needed.first_y));
        CHECK((box.first_x + box.nx <= 40 && box.first_x + box.nx >= needed.first_x + needed.nx));
        CHECK((box.first_y + box.ny <= 30 && box.first_y + box.ny >= needed.first_y + needed.ny));
        if (may_grow) CHECK((box.nx >= needed.nx + 2 && box.ny >= needed.ny + 2));
    }
    CHECK(influence.boxes()->convenient({}, false).size() > 0);
    CHECK(influence.boxes()->convenient({1, 1, 39, 29}, false) == influence.boxes()->extent());
}

TEST_CASE("convolution refuses a table that is too small", "[convolution]") {
    const IcTable table = half_space_pair(Grid::of_elements(5, 5, 1, 1), {1, 0.3});
    CHECK_THROWS_AS(ConvolutionOperator(table, 6, 5), InvalidArgument);
    CHECK_THROWS_AS(ConvolutionOperator(table, 5, 0), InvalidArgument);
}

TEST_CASE("smooth sizes have small prime factors only", "[convolution]") {
    CHECK(smooth_size(1) == 1);
    CHECK(smooth_size(11) == 12);
    CHECK(smooth_size(49) == 50);
    CHECK(smooth_size(121) == 125);
    CHECK(smooth_size(320) == 320);
}

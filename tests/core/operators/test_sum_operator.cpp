#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <random>

#include "contact/contact_cases.hpp"
#include "contact/normal/normal.hpp"
#include "contactd/error.hpp"
#include "operators/convolution.hpp"
#include "operators/shifted_operator.hpp"
#include "operators/sum_operator.hpp"
#include "operators/sum_step.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

const Grid grid = Grid::of_elements(40, 24, 0.2, 0.3);
const Material steel{82000, 0.28}, rubber{20000, 0.45};

std::shared_ptr<const ConvolutionOperator> convolution(IcTable table) {
    return std::make_shared<const ConvolutionOperator>(std::move(table));
}

std::shared_ptr<const StepOperator> step(const IcTable& table, const MaterialPair& materials) {
    const ShiftedTable ahead = shifted_half_spaces({materials}, grid, 0.15, 0.05);
    return std::make_shared<const ShiftedOperator>(change_over_step(table, ahead));
}

Values random_values(unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Values values(grid.size());
    for (double& value : values) value = uniform(generator);
    return values;
}

void check_equal(const Values& computed, const Values& expected) {
    double largest = 0;
    for (double value : expected) largest = std::max(largest, std::abs(value));
    REQUIRE(largest > 0);
    for (std::size_t i = 0; i < computed.size(); ++i) CHECK_THAT(computed[i], WithinAbs(expected[i], 1e-12 * largest));
}

}  // namespace

TEST_CASE("a sum of two bodies' operators is the operator of the pair", "[sum]") {
    const IcTable upper = body_table(grid, rubber), lower = body_table(grid, steel);
    const ConvolutionOperator pair(pair_of(upper, lower));
    const SumOperator sum({convolution(upper), convolution(lower)});
    const Values px = random_values(1), py = random_values(2), pz = random_values(3);
    Values ux(px.size()), uy(px.size()), expected_x(px.size()), expected_y(px.size());

    REQUIRE(sum.size() == pair.size());
    CHECK(sum.coupled());
    sum.normal(pz, ux);
    pair.normal(pz, expected_x);
    check_equal(ux, expected_x);
    sum.tangential(px, py, ux, uy);
    pair.tangential(px, py, expected_x, expected_y);
    check_equal(ux, expected_x);
    check_equal(uy, expected_y);
    sum.normal_of_tangential(px, py, ux);
    pair.normal_of_tangential(px, py, expected_x);
    check_equal(ux, expected_x);
    sum.tangential_of_normal(pz, ux, uy);
    pair.tangential_of_normal(pz, expected_x, expected_y);
    check_equal(ux, expected_x);
    check_equal(uy, expected_y);
    for (const Axis i : {Axis::x, Axis::y, Axis::z}) check_equal(sum.diagonal(i), pair.diagonal(i));
}

TEST_CASE("the change over a step of a sum is that of the pair", "[sum]") {
    const IcTable upper = body_table(grid, rubber), lower = body_table(grid, steel);
    const auto pair = step(pair_of(upper, lower), {rubber, steel});
    const SumStep sum({step(upper, {Material::rigid(), rubber}), step(lower, {Material::rigid(), steel})});
    const Values px = random_values(1), py = random_values(2);
    Values ux(px.size()), uy(px.size()), expected_x(px.size()), expected_y(px.size());

    sum.tangential(px, py, ux, uy);
    pair->tangential(px, py, expected_x, expected_y);
    check_equal(ux, expected_x);
    check_equal(uy, expected_y);
    sum.tangential_of_normal(px, ux, uy);
    pair->tangential_of_normal(px, expected_x, expected_y);
    check_equal(ux, expected_x);
    check_equal(uy, expected_y);
    REQUIRE(sum.coarser() != nullptr);
    CHECK(sum.coarser()->size() == pair->coarser()->size());
    const auto part = sum.on({3, 2, 20, 12});
    REQUIRE(part != nullptr);
    CHECK(part->size() == 20 * 12);
}

TEST_CASE("the preconditioner of a sum is that of the pair when one body is a multiple of the other", "[sum]") {
    const IcTable lower = body_table(grid, steel), upper = scaled(lower, 5);
    const ConvolutionOperator pair(pair_of(upper, lower));
    const SumOperator sum({convolution(upper), convolution(lower)});
    const Values rx = random_values(1), ry = random_values(2);
    Values zx(rx.size()), zy(rx.size()), expected_x(rx.size()), expected_y(rx.size());

    sum.precondition(Axis::z, rx, zx);
    pair.precondition(Axis::z, rx, expected_x);
    check_equal(zx, expected_x);
    sum.precondition_tangential(rx, ry, zx, zy);
    pair.precondition_tangential(rx, ry, expected_x, expected_y);
    check_equal(zx, expected_x);
    check_equal(zy, expected_y);
}

TEST_CASE("a sum has the coarser grids and the boxes that both bodies have", "[sum]") {
    const IcTable upper = body_table(grid, rubber), lower = body_table(grid, steel);
    const ConvolutionOperator pair(pair_of(upper, lower));
    const SumOperator sum({convolution(upper), convolution(lower)});
    Values gap = sampled(Paraboloid{80, 80}, grid);
    for (double& h : gap) h -= 0.05;
    Observer observer;

    REQUIRE(sum.coarser() != nullptr);
    CHECK(sum.coarser()->influence().size() == pair.coarser()->influence().size());
    REQUIRE(sum.boxes() != nullptr);
    CHECK(sum.boxes()->influence({3, 2, 20, 12})->size() == 20 * 12);
    const NormalSolution solution = solve_normal(sum, gap, {1e-10, 100}, {}, observer);
    const NormalSolution expected = solve_normal(pair, gap, {1e-10, 100}, {}, observer);
    REQUIRE(solution.evidence.converged);
    CHECK(solution.evidence.iterations <= expected.evidence.iterations + 2);
    const double unit = expected.pressure[at(grid, grid.nx / 2, grid.ny / 2)];
    REQUIRE(unit > 0);
    for (std::size_t i = 0; i < gap.size(); ++i)
        CHECK_THAT(solution.pressure[i], WithinAbs(expected.pressure[i], 1e-8 * unit));
}

TEST_CASE("a rigid body adds nothing to a sum", "[sum]") {
    const IcTable body = body_table(grid, rubber);
    const ConvolutionOperator pair(pair_of(body, IcTable(grid.nx, grid.ny)));
    const SumOperator sum({convolution(body), nullptr});
    const Values pz = random_values(3);
    Values ux(pz.size()), uy(pz.size()), expected_x(pz.size()), expected_y(pz.size());

    sum.tangential_of_normal(pz, ux, uy);
    pair.tangential_of_normal(pz, expected_x, expected_y);
    check_equal(ux, expected_x);
    check_equal(uy, expected_y);
}

TEST_CASE("a sum refuses rigid bodies only and bodies on different grids", "[sum]") {
    CHECK_THROWS_AS(SumOperator({nullptr, nullptr}), InvalidArgument);
    CHECK_THROWS_AS(SumStep({nullptr, nullptr}), InvalidArgument);
    CHECK_THROWS_AS(SumOperator({convolution(IcTable(3, 4)), convolution(IcTable(3, 5))}), InvalidArgument);
}

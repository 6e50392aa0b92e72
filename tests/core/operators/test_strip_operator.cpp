#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>
#include <thread>

#include "bodies/strip_influence.hpp"
#include "contact/contact_cases.hpp"
#include "contactd/error.hpp"
#include "operators/convolution.hpp"
#include "operators/shifted_operator.hpp"
#include "operators/strips/strip_operator.hpp"
#include "operators/strips/strip_step.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

using enum Axis;

/// Creates a reciprocal table of unrelated strips, whose offsets along x are those of half-spaces.
StripTable rough_table(int nx, int strips) {
    const Material soft{1, 0.1}, stiff{3, 0.4};
    const Grid grid = Grid::of_elements(nx, strips, 1, 0.7);
    StripTable table = strip_table_of(pair_of(body_table(grid, stiff), body_table(grid, soft)));
    const Values noise = random_values(table.values.size(), 7, 0.9, 1.1);
    for (std::size_t i = 0; i < noise.size(); ++i) table.values[i] *= noise[i];
    return symmetrised(std::move(table));
}

/// Returns u_i = A[i,j] p_j with A at `ahead` elements ahead, element by element of a box of strips from `first` on.
Values dense(const StripTable& table, Axis i, Axis j, const ElementBox& box, const Values& p, int ahead = 0) {
    Values u(p.size());
    for (std::size_t to = 0; to < u.size(); ++to)
        for (std::size_t from = 0; from < p.size(); ++from) {
            const int at = static_cast<int>(to), of = static_cast<int>(from);
            u[to] += p[from] * table.at(i, j, box.first_y + at / box.nx, box.first_y + of / box.nx,
                                        at % box.nx - of % box.nx + ahead);
        }
    return u;
}

Values difference(Values a, const Values& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    return a;
}

void check_equal(const Values& computed, const Values& expected) {
    REQUIRE(computed.size() == expected.size());
    for (std::size_t i = 0; i < computed.size(); ++i)
        CHECK_THAT(computed[i], WithinAbs(expected[i], 2e-13 * largest(expected)));
}

void check_against_dense_sums(const InfluenceOperator& influence, const StripTable& table, const ElementBox& box) {
    const std::size_t n = influence.size();
    REQUIRE(n == box.size());
    const Values px = random_values(n, 1), py = random_values(n, 2), pz = random_values(n, 3);
    Values ux(n), uy(n), uz(n);
    influence.normal(pz, uz);
    check_equal(uz, dense(table, z, z, box, pz));
    influence.tangential(px, py, ux, uy);
    check_equal(ux, sum(dense(table, x, x, box, px), dense(table, x, y, box, py)));
    check_equal(uy, sum(dense(table, y, x, box, px), dense(table, y, y, box, py)));
    influence.normal_of_tangential(px, py, uz);
    check_equal(uz, sum(dense(table, z, x, box, px), dense(table, z, y, box, py)));
    influence.tangential_of_normal(pz, ux, uy);
    check_equal(ux, dense(table, x, z, box, pz));
    check_equal(uy, dense(table, y, z, box, pz));
}

std::shared_ptr<const ConvolutionOperator> near_operator(int nx, int ny) {
    return std::make_shared<const ConvolutionOperator>(half_space_pair(Grid::of_elements(nx, ny, 1, 0.7), {1, 0.3}), nx,
                                                       ny);
}

StripOperator operator_of(const StripTable& table, int nx) {
    const auto parts = std::make_shared<const StripParts>(table, nx);
    return {parts, parts->extent(), near_operator(nx, table.strips)};
}

/// Creates two half-spaces that roll along x, as flat bodies with a cross-section.
struct FlatRolling {
    ContactProblem problem;
    ContactInfluence strips, half_spaces;

    explicit FlatRolling(double chi, double elements_per_step, int more_offsets = 0) {
        problem.grid = Grid::of_elements(14, 9, 0.5, 0.4);
        problem.bodies = {{Material{300, 0.3}}, {Material{100, 0.45}}};
        problem.friction = FrictionLaw{{0.3}};
        problem.motion = Rolling{.xi = 1e-3, .chi = chi, .dq = elements_per_step * problem.grid.dx};
        Grid grid = problem.grid;
        half_spaces = make_influence(problem, pair_table(problem));
        grid.nx += more_offsets;
        const auto table = [&](const Body& body) { return strip_table_of(body_table(grid, body.material)); };
        strips =
            make_influence(problem, BodyTable(table(problem.bodies.upper)), BodyTable(table(problem.bodies.lower)));
    }
};

void check_same_step(const FlatRolling& rolling, double accuracy) {
    const std::size_t n = rolling.problem.grid.size();
    const Values px = random_values(n, 1), py = random_values(n, 2), pz = random_values(n, 3);
    const auto products = [&](const StepOperator& change) {
        Values ux(n), uy(n), vx(n), vy(n);
        change.tangential(px, py, ux, uy);
        change.tangential_of_normal(pz, vx, vy);
        return std::array{ux, uy, vx, vy};
    };
    const auto computed = products(*rolling.strips.increment), expected = products(*rolling.half_spaces.increment);
    for (std::size_t which = 0; which < computed.size(); ++which)
        for (std::size_t i = 0; i < n; ++i)
            CHECK_THAT(computed[which][i], WithinAbs(expected[which][i], accuracy * largest(expected[which])));
}

}  // namespace

TEST_CASE("products with a strip table equal dense sums", "[strips]") {
    const auto [nx, strips] = GENERATE(std::pair{1, 1}, std::pair{1, 6}, std::pair{7, 1}, std::pair{2, 2},
                                       std::pair{13, 11}, std::pair{8, 6}, std::pair{23, 3}, std::pair{65, 2});
    CAPTURE(nx, strips);
    const StripTable table = rough_table(nx + 2, strips);
    const StripOperator influence = operator_of(table, nx);
    check_against_dense_sums(influence, table, {0, 0, nx, strips});
    CHECK(influence.diagonal(y)[0] == table(y, y, 0, 0, 0));
    CHECK(influence.diagonal(z)[influence.size() - 1] == table(z, z, strips - 1, strips - 1, 0));
}

TEST_CASE("a strip operator on a box has the products of its strips", "[strips]") {
    const StripTable table = rough_table(30, 26);
    const StripOperator whole = operator_of(table, 30);
    REQUIRE(whole.boxes() != nullptr);
    const ElementBox box{3, 7, 9, 5}, part{2, 1, 4, 3};
    const auto influence = whole.boxes()->influence(box);
    check_against_dense_sums(*influence, table, box);
    CHECK(influence->diagonal(x)[0] == table(x, x, 7, 7, 0));
    check_against_dense_sums(*influence->boxes()->influence(part), table, {5, 8, 4, 3});
    CHECK(whole.boxes()->influence({0, 7, 9, 5}) == influence);  // with its coarser grids
}

TEST_CASE("a strip table that is not reciprocal counts with its symmetric part", "[strips]") {
    StripTable table = rough_table(5, 4);
    for (double& value : table.values) value *= 1 + 1e-3 * std::sin(1e6 * value);
    check_against_dense_sums(operator_of(table, 5), symmetrised(table), {0, 0, 5, 4});
}

TEST_CASE("the strip operator of a flat surface is that of half-spaces", "[strips]") {
    const FlatRolling rolling(0, 1);
    const InfluenceOperator &strips = *rolling.strips.current, &half_spaces = *rolling.half_spaces.current;
    REQUIRE(strips.coupled());
    const std::size_t n = strips.size();
    const Values px = random_values(n, 1), py = random_values(n, 2);
    const auto products = [&](const InfluenceOperator& influence) {
        Values u(n), ux(n), uy(n), vx(n), vy(n), w(n), mx(n), my(n), m(n);
        influence.normal(px, u);
        influence.tangential(px, py, ux, uy);
        influence.tangential_of_normal(px, vx, vy);
        influence.normal_of_tangential(px, py, w);
        influence.precondition_tangential(px, py, mx, my);
        influence.precondition(z, px, m);
        return std::array{u, ux, uy, vx, vy, w, mx, my, m};
    };
    const auto computed = products(strips), expected = products(half_spaces);
    for (std::size_t which = 0; which < computed.size(); ++which) check_equal(computed[which], expected[which]);
}

TEST_CASE("coarser grids of a flat strip operator are those of half-spaces", "[strips]") {
    const int n = 23;
    const IcTable flat = half_space_pair(Grid::of_elements(n, n, 1, 0.7), {1, 0.3});
    const auto near = std::make_shared<const ConvolutionOperator>(flat, n, n);
    const auto parts = std::make_shared<const StripParts>(strip_table_of(flat), n);
    const StripOperator strips(parts, parts->extent(), near);
    REQUIRE(strips.coarser() != nullptr);
    const InfluenceOperator &coarse = strips.coarser()->influence(), &expected = near->coarser()->influence();
    REQUIRE(coarse.size() == expected.size());
    const Values p = random_values(coarse.size(), 1);
    Values u(p.size()), v(p.size()), ux(p.size()), uy(p.size());
    coarse.normal(p, u);
    expected.normal(p, v);
    check_equal(u, v);
    coarse.tangential(p, v, ux, uy);
    Values wx(p.size()), wy(p.size());
    expected.tangential(p, v, wx, wy);
    check_equal(ux, wx);
    check_equal(uy, wy);
}

TEST_CASE("a strip step by whole elements changes what its table says", "[strips]") {
    const int nx = 9, strips = 5, ahead = GENERATE(1, -1, 2, -3);
    CAPTURE(ahead);
    const StripTable table = rough_table(nx + 3, strips);
    const auto parts = std::make_shared<const StripParts>(table, nx);
    const auto near = std::make_shared<const ShiftedOperator>(ShiftedTable(nx, strips));
    const StripStep whole(parts, parts->extent(), ahead, near);
    const auto part = whole.on({2, 1, 6, 3});
    const auto check = [&](const StepOperator& step, const ElementBox& box) {
        const std::size_t n = step.size();
        const Values px = random_values(n, 1), py = random_values(n, 2);
        Values ux(n), uy(n);
        const auto change = [&](Axis i, Axis j, const Values& p) {
            return difference(dense(table, i, j, box, p), dense(table, i, j, box, p, ahead));
        };
        step.tangential(px, py, ux, uy);
        check_equal(ux, sum(change(x, x, px), change(x, y, py)));
        check_equal(uy, sum(change(y, x, px), change(y, y, py)));
        step.tangential_of_normal(px, ux, uy);
        check_equal(ux, change(x, z, px));
        check_equal(uy, change(y, z, px));
    };
    check(whole, {0, 0, nx, strips});
    check(*part, {2, 1, 6, 3});
    CHECK_THROWS_AS(StripStep(parts, parts->extent(), 4, near), InvalidArgument);
}

TEST_CASE("a step of rolling changes the same on a flat strip table as on half-spaces", "[strips]") {
    const double chi = GENERATE(0.0, std::numbers::pi);
    const double elements_per_step = GENERATE(1.0, 2.0, 0.4, 2.7);
    const int more_offsets = GENERATE(0, 1, 8);
    CAPTURE(chi, elements_per_step, more_offsets);
    check_same_step(FlatRolling(chi, elements_per_step, more_offsets), 1e-12);
}

TEST_CASE("operators of an upper body alone are those of its mirror image below", "[strips]") {
    ContactProblem problem;
    problem.grid = Grid::of_elements(6, 5, 0.5, 0.4);
    problem.bodies = {{Material{300, 0.3}}, {Material{100, 0.45}}};
    const Grid& grid = problem.grid;
    StripTable upper = symmetrised([&] {
        StripTable table = strip_table_of(body_table(grid, problem.bodies.upper.material));
        const Values noise = random_values(table.values.size(), 3, 0.9, 1.1);
        for (std::size_t i = 0; i < noise.size(); ++i) table.values[i] *= noise[i];
        return table;
    }());
    const IcTable lower = body_table(grid, problem.bodies.lower.material);
    const ContactInfluence sum = make_influence(problem, BodyTable(upper), BodyTable(lower));
    check_against_dense_sums(*sum.current, pair_of(upper, strip_table_of(lower)), {0, 0, grid.nx, grid.ny});
}

TEST_CASE("one strip operator serves several threads at once", "[strips]") {
    const StripTable table = rough_table(11, 7);
    const StripOperator shared = operator_of(table, 11);
    const Values p = random_values(shared.size(), 3);
    const Values expected = dense(table, z, z, {0, 0, 11, 7}, p);
    std::vector<Values> results(4, Values(shared.size()));
    std::vector<std::thread> threads;
    for (Values& u : results)
        threads.emplace_back([&] {
            for (int repeat = 0; repeat < 50; ++repeat) {
                const StripOperator own = operator_of(table, 11 - repeat % 3);  // plans while others compute
                shared.normal(p, u);
            }
        });
    for (std::thread& thread : threads) thread.join();
    for (const Values& u : results) check_equal(u, expected);
}

TEST_CASE("bodies with a cross-section roll along x only, and not farther than their grid is long", "[strips]") {
    const auto refused = [](double chi, double elements_per_step) -> std::string {
        try {
            const FlatRolling rolling(chi, elements_per_step);
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return "";
    };
    CHECK(refused(0.1, 1) == "friction.rolling.chi");
    CHECK(refused(std::numbers::pi / 2, 1) == "friction.rolling.chi");
    CHECK(refused(0, 15) == "friction.rolling.dq");
    CHECK(refused(-std::numbers::pi, 3) == "");
}

TEST_CASE("a strip table must fit the grid", "[strips]") {
    ContactProblem problem;
    problem.grid = Grid::of_elements(6, 5, 0.5, 0.4);
    problem.bodies = {{Material{300, 0.3}}, {Material::rigid()}};
    CHECK_THROWS_AS(strip_influence(problem, StripTable(6, 4)), InvalidArgument);
    CHECK_THROWS_AS(strip_influence(problem, StripTable(5, 5)), InvalidArgument);
}

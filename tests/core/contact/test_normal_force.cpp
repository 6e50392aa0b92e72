// Tests normal contact with prescribed force, and on boxes within the potential contact area.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "closed_forms/hertz.hpp"
#include "contact/normal/normal.hpp"
#include "contact_cases.hpp"
#include "contactd/error.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const Material steel{82000, 0.28};
const double compliance = (1 - steel.nu) / steel.G;

struct Case {
    Grid grid;
    PairOperator influence;
    Values distance;

    Case(const Grid& grid_, const Paraboloid& gap)
        : grid(grid_), influence(half_space_pair(grid, steel), grid.nx, grid.ny), distance(sampled(gap, grid)) {}

    NormalSolution at_force(double Fn, const Values& initial = {}, const SolverSettings& settings = {}) const {
        Observer observer;
        return solve_normal_force(influence, distance, Fn / grid.element_area(), settings, initial, observer);
    }
    NormalSolution at_approach(double approach, const Values& initial = {}) const {
        Observer observer;
        Values gap = distance;
        for (double& h : gap) h -= approach;
        return solve_normal(influence, gap, {}, initial, observer);
    }
    double force(const NormalSolution& solution) const {
        double sum = 0;
        for (const double p : solution.pressure) sum += p;
        return sum * grid.element_area();
    }
};

Case ellipse() {
    return {Grid::of_elements(30, 24, 0.1, 0.09), radii_of_force({1.3, 0.9}, compliance, 2000)};
}

}  // namespace

TEST_CASE("the force that an approach makes finds the approach", "[normal]") {
    const Case problem = ellipse();
    const auto expected = problem.at_approach(0.005);

    const auto solution = problem.at_force(problem.force(expected));

    REQUIRE(solution.evidence.converged);
    CHECK_THAT(solution.approach, WithinRel(0.005, 1e-6));
    CHECK_THAT(problem.force(solution), WithinRel(problem.force(expected), 1e-12));
    for (std::size_t i = 0; i < solution.pressure.size(); ++i)
        CHECK_THAT(solution.pressure[i], WithinAbs(expected.pressure[i], 1e-4 * largest(expected.pressure)));
}

TEST_CASE("the established code's approach and largest pressure", "[normal]") {
    const Case problem(Grid::of_elements(25, 25, 13.2 / 25, 8.8 / 25), radii_of_force({6, 4}, compliance, 50000));
    const auto solution = problem.at_force(50000, {}, {1e-8, 1000});
    REQUIRE(solution.evidence.converged);
    CHECK_THAT(solution.approach, WithinRel(0.0665015273, 1e-9));
    CHECK_THAT(largest(solution.pressure), WithinRel(994.992217, 1e-9));
}

TEST_CASE("without a force the bodies just touch", "[normal]") {
    Case problem = ellipse();
    for (double& h : problem.distance) h += 0.5;
    const auto solution = problem.at_force(0);
    CHECK(solution.evidence.converged);
    CHECK(solution.approach == *std::min_element(problem.distance.begin(), problem.distance.end()));
    CHECK(largest(solution.pressure) == 0);
}

TEST_CASE("a large force brings the whole window into contact", "[normal]") {
    const Case problem = ellipse();
    const auto solution = problem.at_force(1e8);
    CHECK(solution.evidence.converged);
    CHECK(*std::min_element(solution.pressure.begin(), solution.pressure.end()) > 0);
    CHECK(border_elements(problem.grid, solution.pressure) == 2 * (30 + 24) - 4);
}

TEST_CASE("one element carries all of the force", "[normal]") {
    const Case problem(Grid::of_elements(1, 1, 0.1, 0.1), {50, 50});
    const auto solution = problem.at_force(3);
    CHECK(solution.evidence.converged);
    CHECK_THAT(solution.pressure[0], WithinRel(300.0, 1e-12));
    CHECK_THAT(solution.approach, WithinRel(300 * problem.influence.diagonal(Axis::z)[0], 1e-12));
}

TEST_CASE("the pressures of another force are a good start", "[normal]") {
    const Case problem(Grid::of_elements(60, 60, 0.05, 0.04), radii_of_force({1.3, 0.9}, compliance, 2000));
    const auto before = problem.at_force(2000);
    const auto cold = problem.at_force(2100);

    const auto warm = problem.at_force(2100, before.pressure);

    CHECK(warm.evidence.converged);
    CHECK_THAT(warm.approach, WithinRel(cold.approach, 1e-6));
    CHECK(problem.at_force(2000, before.pressure).evidence.iterations == 0);
}

TEST_CASE("forces that pull or have no value are refused", "[normal]") {
    const Case problem = ellipse();
    CHECK_THROWS_AS(problem.at_force(-1), InvalidArgument);
    CHECK_THROWS_AS(problem.at_force(NAN), InvalidArgument);
    CHECK_THROWS_AS(problem.at_force(INFINITY), InvalidArgument);
}

TEST_CASE("a small contact anywhere in a large window is that of a small window", "[normal]") {
    const double x = GENERATE(0.0, -1.9, 1.2), y = GENERATE(0.0, 1.6);
    Case large(Grid::of_elements(100, 90, 0.05, 0.05), {});
    large.distance = sampled({10, 10}, {100, 90, 0.05, 0.05, -2.5 - x, -2.25 - y});
    const Case small(Grid::of_elements(30, 30, 0.05, 0.05), {10, 10});
    const auto expected = small.at_force(50);

    const auto by_force = large.at_force(50), by_approach = large.at_approach(expected.approach);

    REQUIRE(by_force.evidence.converged);
    REQUIRE(by_approach.evidence.converged);
    CHECK_THAT(by_force.approach, WithinRel(expected.approach, 1e-6));
    CHECK_THAT(large.force(by_approach), WithinRel(50.0, 1e-5));
    CHECK_THAT(largest(by_force.pressure), WithinRel(largest(expected.pressure), 1e-4));
}

TEST_CASE("a second contact far from the estimate is found", "[normal]") {
    Case problem(Grid::of_elements(100, 90, 0.05, 0.05), {});
    const Grid& grid = problem.grid;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix)
            problem.distance[at(grid, ix, iy)] =
                std::min(std::hypot(grid.x(ix) - 2, grid.y(iy)), std::hypot(grid.x(ix) + 2, grid.y(iy) + 1));
    Values one_sided(grid.size());
    one_sided[at(grid, 90, 45)] = 1;

    const auto solution = problem.at_approach(0.1, one_sided);

    REQUIRE(solution.evidence.converged);
    const auto cold = problem.at_approach(0.1);
    for (std::size_t i = 0; i < cold.pressure.size(); ++i)
        CHECK_THAT(solution.pressure[i], WithinAbs(cold.pressure[i], 1e-4 * largest(cold.pressure)));
}

TEST_CASE("border elements are counted once", "[normal]") {
    const Grid grid = Grid::of_elements(4, 3, 1, 1);
    Values pressure(12);
    CHECK(border_elements(grid, pressure) == 0);
    pressure[5] = 1;
    CHECK(border_elements(grid, pressure) == 0);
    pressure[0] = pressure[7] = 1;
    CHECK(border_elements(grid, pressure) == 2);
    CHECK(border_elements(Grid::of_elements(1, 1, 1, 1), Values{1}) == 1);
}

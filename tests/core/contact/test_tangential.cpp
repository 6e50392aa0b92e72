#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contact/tangential/tangential.hpp"
#include "contact_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const Material material{200, 0.42};

struct ShiftCase {
    Grid grid;
    IcTable table;
    PairOperator influence;
    Values bound, rigid_x, rigid_y;

    // Creates an elliptic bound that fills the window, with a uniform shift.
    ShiftCase(const Grid& grid_, double largest_bound, double wx, double wy)
        : grid(grid_),
          table(half_space_pair(grid, material)),
          influence(table, grid.nx, grid.ny),
          rigid_x(grid.size(), wx),
          rigid_y(grid.size(), wy) {
        for (int iy = 0; iy < grid.ny; ++iy)
            for (int ix = 0; ix < grid.nx; ++ix) {
                const double x = 2 * grid.x(ix) / (grid.nx * grid.dx), y = 2 * grid.y(iy) / (grid.ny * grid.dy);
                bound.push_back(largest_bound * std::sqrt(std::max(1 - x * x - y * y, 0.0)));
            }
    }

    TangentialSolution solve(const Values& initial_x = {}, const Values& initial_y = {},
                             const SolverSettings& settings = {}) const {
        Observer observer;
        return solve_tangential(influence, bound, rigid_x, rigid_y, settings, initial_x, initial_y, observer);
    }
};

struct Division {
    int adhesion = 0, slip = 0;
};

// Checks Coulomb's law element by element, with displacements from dense sums. `accuracy` applies to slip and traction.
Division check_friction_law(const ShiftCase& shift, const TangentialSolution& solution, double accuracy) {
    REQUIRE(solution.evidence.converged);
    const int nx = shift.grid.nx, ny = shift.grid.ny;
    const auto &px = solution.traction_x, &py = solution.traction_y;
    const auto A = [&](Axis i, Axis j, const Values& p) { return dense_product(shift.table, i, j, nx, ny, p); };
    const Values sx = sum(sum(A(Axis::x, Axis::x, px), A(Axis::x, Axis::y, py)), shift.rigid_x);
    const Values sy = sum(sum(A(Axis::y, Axis::x, px), A(Axis::y, Axis::y, py)), shift.rigid_y);
    const double unit = std::max(largest(shift.rigid_x), largest(shift.rigid_y)) * accuracy;
    Division counts;
    for (std::size_t i = 0; i < px.size(); ++i) {
        const double p = std::hypot(px[i], py[i]), g = shift.bound[i];
        CAPTURE(i, p, g, sx[i], sy[i]);
        switch (solution.element_division[i]) {
            case ElementState::exterior:
                CHECK(g == 0);
                CHECK(p == 0);
                break;
            case ElementState::adhesion:
                ++counts.adhesion;
                CHECK(p <= g * (1 + 1e-12));
                CHECK_THAT(std::hypot(sx[i], sy[i]), WithinAbs(0, unit));
                break;
            case ElementState::flow:  // there is no layer
            case ElementState::slip:
                ++counts.slip;
                CHECK_THAT(p, WithinRel(g, 1e-12));
                CHECK_THAT((sx[i] * py[i] - sy[i] * px[i]) / g, WithinAbs(0, unit));
                CHECK((sx[i] * px[i] + sy[i] * py[i]) / g <= unit);
                break;
        }
    }
    return counts;
}

double total(const Values& p) {
    double result = 0;
    for (const double value : p) result += value;
    return result;
}

constexpr double law_accuracy = 1e-4;  // error of displacements for tractions to 1e-6

}  // namespace

TEST_CASE("friction law holds for shifts in any direction and size", "[tangential]") {
    const auto [nx, ny, aspect] = GENERATE(std::tuple{16, 15, 1.0}, std::tuple{1, 25, 1.0}, std::tuple{30, 1, 0.2},
                                           std::tuple{11, 23, 5.0}, std::tuple{26, 22, 1.0});
    const double angle = GENERATE(0.0, 1.1, 3.9);
    const double size = GENERATE(0.0005, 0.003, 0.008, 0.1);
    CAPTURE(nx, ny, angle, size);
    const ShiftCase shift(Grid::of_elements(nx, ny, 2.0 / nx, 2.0 / nx / aspect), 1.7, size * std::cos(angle),
                          size * std::sin(angle));
    check_friction_law(shift, shift.solve(), law_accuracy);
}

TEST_CASE("friction law holds for rigid slip that differs by element", "[tangential]") {
    ShiftCase shift(Grid::of_elements(19, 16, 0.1, 0.12), 1.5, 0, 0);
    SECTION("spin") {
        const double shift_x = GENERATE(0.0, 0.002);
        for (int iy = 0; iy < 16; ++iy)
            for (int ix = 0; ix < 19; ++ix) {
                shift.rigid_x[at(shift.grid, ix, iy)] = shift_x - 0.006 * shift.grid.y(iy);
                shift.rigid_y[at(shift.grid, ix, iy)] = 0.006 * shift.grid.x(ix);
            }
    }
    SECTION("no pattern at all") {
        const unsigned seed = GENERATE(1u, 2u, 3u);
        shift.rigid_x = random_values(shift.bound.size(), seed, -0.002, 0.002);
        shift.rigid_y = random_values(shift.bound.size(), seed + 10, -0.002, 0.002);
        shift.bound = random_values(shift.bound.size(), seed + 20, 0, 3);
    }
    const Division counts = check_friction_law(shift, shift.solve(), law_accuracy);
    CHECK(counts.adhesion > 0);
    CHECK(counts.slip > 0);
}

TEST_CASE("small shifts adhere everywhere, large ones slip everywhere", "[tangential]") {
    const Grid grid = Grid::of_elements(14, 14, 0.15, 0.15);
    ShiftCase small(grid, 1.7, 1e-3, 0);
    for (double& g : small.bound)
        if (g > 0) g = 1e3;
    CHECK(check_friction_law(small, small.solve(), law_accuracy).slip == 0);

    const ShiftCase large(grid, 1.7, 0.5, -0.5);
    const auto solution = large.solve();
    CHECK(check_friction_law(large, solution, law_accuracy).adhesion == 0);
    CHECK_THAT(total(solution.traction_x), WithinRel(-std::sqrt(0.5) * total(large.bound), 1e-3));
    CHECK_THAT(total(solution.traction_y), WithinRel(std::sqrt(0.5) * total(large.bound), 1e-3));
}

TEST_CASE("no shift, no traction", "[tangential]") {
    const ShiftCase shift(Grid::of_elements(12, 12, 0.1, 0.1), 1.7, 0, 0);
    const std::size_t n = shift.bound.size();
    const bool estimate = GENERATE(false, true);
    const auto solution = estimate ? shift.solve(random_values(n, 1), random_values(n, 2)) : shift.solve();
    CHECK(solution.evidence.converged);
    CHECK_THAT(largest(solution.traction_x), WithinAbs(0, 1e-9));
    CHECK_THAT(largest(solution.traction_y), WithinAbs(0, 1e-9));
    for (std::size_t i = 0; i < n; ++i)
        CHECK(solution.element_division[i] == (shift.bound[i] > 0 ? ElementState::adhesion : ElementState::exterior));
}

TEST_CASE("no bound, no traction", "[tangential]") {
    const ShiftCase shift(Grid::of_elements(6, 6, 0.1, 0.1), 0, 0.01, 0.01);
    const auto solution = shift.solve();
    CHECK(solution.evidence.converged);
    CHECK(largest(solution.traction_x) == 0);
    CHECK(largest(solution.traction_y) == 0);
}

TEST_CASE("the estimate does not change the tractions", "[tangential]") {
    const ShiftCase shift(Grid::of_elements(20, 20, 0.1, 0.1), 1.7, 0.004, 0.003);
    const std::size_t n = shift.bound.size();
    const auto reference = shift.solve({}, {}, {1e-11, 1000});
    const auto same = [&](const Values& x, const Values& y) {
        const auto solution = shift.solve(x, y);
        check_friction_law(shift, solution, law_accuracy);
        CHECK_THAT(total(solution.traction_x), WithinRel(total(reference.traction_x), 1e-5));
        CHECK_THAT(total(solution.traction_y), WithinRel(total(reference.traction_y), 1e-5));
        CHECK(solution.element_division == reference.element_division);
        return solution.evidence.iterations;
    };
    SECTION("none") {
        same({}, {});
    }
    SECTION("along the slip instead of against it") {
        same(shift.bound, Values(n));
    }
    SECTION("far beyond the bound") {
        same(random_values(n, 1, -1e6, 1e6), random_values(n, 2, -1e6, 1e6));
    }
    SECTION("one component only") {
        same({}, random_values(n, 2));
    }
    SECTION("exact") {
        CHECK(same(reference.traction_x, reference.traction_y) <= 1);
    }
}

TEST_CASE("an opposite shift gives opposite tractions", "[tangential]") {
    const Grid grid = Grid::of_elements(15, 12, 0.1, 0.1);
    const auto one = ShiftCase(grid, 1.7, 0.004, 0.001).solve(), other = ShiftCase(grid, 1.7, -0.004, -0.001).solve();
    CHECK(total(one.traction_x) < 0);
    CHECK(one.element_division == other.element_division);
    for (std::size_t i = 0; i < grid.size(); ++i) CHECK_THAT(one.traction_x[i], WithinAbs(-other.traction_x[i], 1e-10));
}

TEST_CASE("tractions that missed the tolerance say so and keep the bound", "[tangential]") {
    const ShiftCase shift(Grid::of_elements(16, 16, 0.125, 0.125), 1.7, 0.006, 0.002);
    const auto solution = shift.solve({}, {}, {1e-6, 3});
    CHECK_FALSE(solution.evidence.converged);
    CHECK(solution.evidence.iterations == 3);
    for (std::size_t i = 0; i < shift.bound.size(); ++i)
        CHECK(std::hypot(solution.traction_x[i], solution.traction_y[i]) <= shift.bound[i] * (1 + 1e-12));
}

TEST_CASE("tangential contact can be cancelled", "[tangential]") {
    struct : Observer {
        bool cancelled() const override { return true; }
    } observer;
    const ShiftCase shift(Grid::of_elements(24, 24, 0.1, 0.1), 1.7, 0.004, 0.001);
    CHECK_THROWS_AS(solve_tangential(shift.influence, shift.bound, shift.rigid_x, shift.rigid_y, {}, {}, {}, observer),
                    Cancelled);
}

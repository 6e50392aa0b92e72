#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>

#include "rolling_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const Material material{1000, 0.28};
constexpr double pi = std::numbers::pi;
constexpr double law_accuracy = 2e-5;  // in the maximum norm, for a root mean square to 1e-6

Grid window(int nx, int ny, double aspect = 1) {
    return Grid::of_elements(nx, ny, 2.0 / nx, 2.0 * aspect / ny);
}

double total(const Values& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum;
}

class Cancels final : public Observer {
   public:
    bool cancelled() const override { return true; }
};

}  // namespace

TEST_CASE("friction law holds in steady rolling in any direction with any step", "[rolling]") {
    const double chi = GENERATE(0.0, 0.5 * pi, pi, 0.7, -2.1);
    const double elements_per_step = GENERATE(0.3, 1.0, 2.0);
    RollingCase rolling(window(15, 12, 0.7), material, 3, chi, elements_per_step * 2.0 / 15);
    rolling.set(0.001, -0.0005, 0.001);
    CAPTURE(chi, elements_per_step);

    const RollingSolution solution = rolling.steady();

    check_steady_law(rolling, solution, law_accuracy);
    CHECK(count(solution).adhesion > 0);
    CHECK(count(solution).slip > 0);
}

TEST_CASE("friction law holds for creepages and spin of any size", "[rolling]") {
    const double size = GENERATE(1e-6, 1e-3, 3e-3, 0.1);
    const auto [xi, eta, phi] =
        GENERATE(std::tuple{1.0, 0.0, 0.0}, std::tuple{0.0, -1.0, 0.5}, std::tuple{0.0, 0.0, 2.0});
    RollingCase rolling(window(14, 15), material, 3, 0, 2.0 / 14);
    rolling.set(size * xi, size * eta, size * phi);
    CAPTURE(size, xi, eta, phi);
    check_steady_law(rolling, rolling.steady(), law_accuracy);
}

TEST_CASE("friction law holds on grids of any shape", "[rolling]") {
    const auto [nx, ny, aspect] = GENERATE(std::tuple{1, 1, 1.0}, std::tuple{1, 20, 1.0}, std::tuple{25, 1, 0.2},
                                           std::tuple{7, 26, 4.0}, std::tuple{26, 9, 0.3});
    RollingCase rolling(window(nx, ny, aspect), material, 3, 0, 2.0 / nx);
    rolling.set(0.002, 0.001, 0.001);
    CAPTURE(nx, ny, aspect);
    check_steady_law(rolling, rolling.steady(), law_accuracy);
}

TEST_CASE("friction law holds on grids large enough to start on coarser ones", "[rolling]") {
    RollingCase rolling(window(41, 38, 0.8), material, 3, 0.2, 2.0 / 41);
    rolling.set(0.002, 0.001, 0.001);
    check_steady_law(rolling, rolling.steady(), law_accuracy);
}

TEST_CASE("friction law holds for contacts with holes and for bounds without a pattern", "[rolling]") {
    RollingCase rolling(window(20, 16), material, 3, 0.4, 0.1);
    rolling.set(0.001, -0.002, 0.003);
    SECTION("two patches, one with a hole") {
        for (int iy = 0; iy < 16; ++iy)
            for (int ix = 0; ix < 20; ++ix)
                if (ix == 8 || ix == 9 || (ix > 12 && ix < 16 && iy > 5 && iy < 10))
                    rolling.bound[at(rolling.grid, ix, iy)] = 0;
    }
    SECTION("random bounds") {
        rolling.bound = random_values(rolling.grid.size(), 5, -1, 3);
        for (double& g : rolling.bound) g = std::max(g, 0.0);
    }
    check_steady_law(rolling, rolling.steady(), law_accuracy);
}

TEST_CASE("full slip carries the whole of the friction force", "[rolling]") {
    RollingCase rolling(window(16, 16), material, 3, 0, 0.125);
    rolling.set(0.6, -0.8, 0);

    const RollingSolution solution = rolling.steady();

    const double limit = total(rolling.bound) * rolling.grid.element_area();
    const TangentialForces forces = rolling.forces(solution);
    CHECK(count(solution).adhesion == 0);
    CHECK_THAT(forces.Fx, WithinRel(-0.6 * limit, 1e-3));
    CHECK_THAT(forces.Fy, WithinRel(0.8 * limit, 1e-3));
}

TEST_CASE("spin alone pushes against the lateral slip of the leading edge", "[rolling]") {
    RollingCase rolling(window(16, 16), material, 3, 0, 0.125);
    const double phi = GENERATE(0.001, -0.003);
    rolling.set(0, 0, phi);

    const TangentialForces forces = rolling.forces(rolling.steady());

    CHECK(forces.Fy * phi < 0);
    CHECK(forces.Mz * phi < 0);
    CHECK_THAT(forces.Fx, WithinAbs(0, 1e-5 * std::abs(forces.Fy)));
}

TEST_CASE("rolling problems rotated by a right angle have the same solution, rotated", "[rolling]") {
    const Grid grid = window(15, 11, 0.6);
    RollingCase along(grid, material, 3, 0, grid.dx);
    along.set(0.002, 0.001, 0.002);
    RollingCase across(Grid::of_elements(grid.ny, grid.nx, grid.dy, grid.dx), material, 3, 0.5 * pi, grid.dx);
    across.set(-0.001, 0.002, 0.002);

    const TangentialForces a = along.forces(along.steady({1e-9, 1000}));
    const TangentialForces b = across.forces(across.steady({1e-9, 1000}));

    CHECK_THAT(b.Fy, WithinRel(a.Fx, 1e-7));
    CHECK_THAT(b.Fx, WithinRel(-a.Fy, 1e-7));
    CHECK_THAT(b.Mz, WithinRel(a.Mz, 1e-6));
}

TEST_CASE("without friction or creepage there are no tractions", "[rolling]") {
    RollingCase rolling(window(9, 8), material, 3, 0, 0.2);
    Values initial;
    SECTION("no bound") {
        rolling.set(0.001, 0, 0);
        rolling.bound.assign(rolling.grid.size(), 0);
    }
    SECTION("no creepage") {}
    SECTION("no creepage any more") {
        initial.assign(rolling.grid.size(), 0.5);
    }
    const RollingSolution solution = rolling.steady({}, initial, initial);
    CHECK(solution.evidence.converged);
    CHECK(largest(solution.traction_x) == 0);
    CHECK(largest(solution.traction_y) == 0);
    CHECK(count(solution).slip == 0);
}

TEST_CASE("steady rolling starts from an estimate and repeats itself bit by bit", "[rolling]") {
    RollingCase rolling(window(20, 18), material, 3, 0, 0.1);
    rolling.set(0.002, 0.001, 0.001);
    const RollingSolution cold = rolling.steady();
    const RollingSolution again = rolling.steady();
    CHECK(again.traction_x == cold.traction_x);
    CHECK(again.traction_y == cold.traction_y);

    const RollingSolution same = rolling.steady({}, cold.traction_x, cold.traction_y);
    rolling.set(0.0021, 0.00095, 0.00105);
    const RollingSolution warm = rolling.steady({}, cold.traction_x, cold.traction_y);

    CHECK(same.evidence.iterations <= 1);
    CHECK(warm.evidence.iterations < cold.evidence.iterations);
    check_steady_law(rolling, warm, law_accuracy);
}

TEST_CASE("steady rolling does not depend on the window around the contact", "[rolling]") {
    RollingCase narrow(window(16, 15), material, 3, 0, 0.1);
    narrow.set(0.002, 0.001, 0.001);
    Grid broad = narrow.grid;
    broad.nx += 24;
    broad.ny += 10;
    broad.x0 -= 20 * broad.dx;
    broad.y0 -= 3 * broad.dy;
    RollingCase in_window(broad, material, 3, 0, 0.1);
    in_window.set(0.002, 0.001, 0.001);
    in_window.bound.assign(broad.size(), 0);
    const auto in_broad = [&](std::size_t i) {
        return (i / 16 + 3) * static_cast<std::size_t>(broad.nx) + i % 16 + 20;
    };
    for (std::size_t i = 0; i < narrow.bound.size(); ++i) in_window.bound[in_broad(i)] = narrow.bound[i];

    const RollingSolution expected = narrow.steady({1e-9, 200}), solution = in_window.steady({1e-9, 200});

    REQUIRE(solution.evidence.converged);
    for (std::size_t i = 0; i < narrow.bound.size(); ++i) {
        CHECK_THAT(solution.traction_x[in_broad(i)], WithinAbs(expected.traction_x[i], 1e-7));
        CHECK_THAT(solution.slip_y[in_broad(i)], WithinAbs(expected.slip_y[i], 1e-9));
        CHECK(solution.element_division[in_broad(i)] == expected.element_division[i]);
    }
    CHECK(count(solution).slip == count(expected).slip);
}

TEST_CASE("steady rolling that runs out of iterations says so", "[rolling]") {
    RollingCase rolling(window(20, 18), material, 3, 0, 0.1);
    rolling.set(0.002, 0.001, 0.001);
    const RollingSolution solution = rolling.steady({1e-6, 3});
    CHECK_FALSE(solution.evidence.converged);
    CHECK(solution.evidence.iterations == 3);
    CHECK(solution.evidence.residual > 1e-6);
}

TEST_CASE("steady rolling can be cancelled", "[rolling]") {
    RollingCase rolling(window(9, 8), material, 3, 0, 0.2);
    rolling.set(0.002, 0, 0);
    const RigidSlip w = rigid_slip(rolling.grid, rolling.rolling, rolling.dq);
    Cancels observer;
    CHECK_THROWS_AS(solve_steady_rolling(rolling.bodies, rolling.bound, w.x, w.y, {}, {}, {}, observer), Cancelled);
}

TEST_CASE("rolling refuses what does not fit", "[rolling]") {
    RollingCase rolling(window(9, 8), material, 3, 0, 0.2);
    const RigidSlip w = rigid_slip(rolling.grid, rolling.rolling, rolling.dq);
    Observer observer;
    const Values too_short(3);
    const RollingBodies at_rest{rolling.influence, rolling.increment, rolling.grid, 0, 0};
    CHECK_THROWS_AS(solve_steady_rolling(at_rest, rolling.bound, w.x, w.y, {}, {}, {}, observer), InvalidArgument);
    CHECK_THROWS_AS(solve_steady_rolling(rolling.bodies, too_short, w.x, w.y, {}, {}, {}, observer), InvalidArgument);
    CHECK_THROWS_AS(rolling.steady({}, too_short, too_short), InvalidArgument);
    CHECK_THROWS_AS(change_over_step(half_space_pair(window(5, 8), material), rolling.increment_table),
                    InvalidArgument);
}

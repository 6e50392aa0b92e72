// Solves the Cattaneo problem of verification.md with prescribed forces: the forces of the half-space code reproduce
// its shift.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contact/random_friction.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

struct Row {
    int n;
    double Fx;
    int adhesion, slip, elements_off;
};

}  // namespace

TEST_CASE("forces of the Cattaneo problem give back its shift", "[verification]") {
    const Row row = GENERATE(Row{10, 3.22153276, 16, 36, 0}, Row{40, 3.22211266, 216, 664, 0},
                             Row{160, 3.22162302, 3464, 10556, 8});
    const bool both = GENERATE(true, false);
    CAPTURE(row.n, both);
    const Grid grid = Grid::of_elements(row.n, row.n, 2.4 / row.n, 2.4 / row.n);
    RandomFriction problem{grid, half_space_pair(grid, {200, 0.42}), {}, {}, {}, {}};
    const ConvolutionOperator influence(problem.table, row.n, row.n);
    Values gap;
    for (int iy = 0; iy < row.n; ++iy)
        for (int ix = 0; ix < row.n; ++ix)
            gap.push_back((std::pow(grid.x(ix), 2) + std::pow(grid.y(iy), 2)) / 100 - 0.02);
    Observer observer;
    problem.bound = solve_normal(influence, gap, {}, {}, observer).pressure;
    for (double& g : problem.bound) g *= 0.4;
    problem.motion.Fx = -row.Fx / problem.largest_force();
    if (both) problem.motion.Fy = 0;

    const FrictionAnswer answer = solve(problem);

    REQUIRE(answer.converged());
    CHECK_THAT(answer.rigid_x[0], WithinRel(0.00817, 1e-5));
    CHECK_THAT(answer.rigid_y[0], WithinAbs(0, 1e-5 * 0.00817));
    int adhesion = 0, slip = 0;
    for (const ElementState state : answer.tangential.element_division) {
        adhesion += state == ElementState::adhesion;
        slip += state == ElementState::slip;
    }
    CHECK(std::abs(adhesion - row.adhesion) <= row.elements_off);
    CHECK(std::abs(slip - row.slip) <= row.elements_off);
}

// Tests Hertzian ellipses with prescribed approach and prescribed force: the required bounds hold on coarser grids, and
// errors decrease with refinement.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "closed_forms/hertz.hpp"
#include "contact/contact_cases.hpp"
#include "contact/normal/normal.hpp"
#include "operators/convolution.hpp"

using namespace contactd;
using namespace contactd::test;

namespace {

struct Errors {
    double load, pmax, area;  // relative error of the computed force or approach
};

// Uses a window of 1.2 times the ellipse's box, with n x n elements.
Errors errors_of(const SemiAxes& axes, int n, bool force_prescribed) {
    const Material steel{82000, 0.28};
    const double compliance = (1 - steel.nu) / steel.G, Fn = 1000;
    const HertzContact exact = hertz_of_semi_axes_and_force(axes, compliance, Fn);
    const Grid grid = Grid::of_elements(n, n, 2.4 * axes.a / n, 2.4 * axes.b / n);
    const ConvolutionOperator influence(half_space_pair(grid, steel), n, n);
    Values distance = sampled(radii_of_force(axes, compliance, Fn), grid);
    Observer observer;
    NormalSolution solution;
    if (force_prescribed) {
        solution = solve_normal_force(influence, distance, Fn / grid.element_area(), {}, {}, observer);
    } else {
        for (double& h : distance) h -= exact.approach;
        solution = solve_normal(influence, distance, {}, {}, observer);
    }
    REQUIRE(solution.evidence.converged);
    double sum = 0;
    int elements = 0;
    for (const double p : solution.pressure) {
        sum += p;
        elements += p > 0;
    }
    const double load = force_prescribed ? solution.approach / exact.approach : sum * grid.element_area() / Fn;
    return {std::abs(load - 1), std::abs(largest(solution.pressure) / exact.pmax - 1),
            std::abs(elements * grid.element_area() / (std::numbers::pi * axes.a * axes.b) - 1)};
}

}  // namespace

TEST_CASE("Hertzian ellipses under either control", "[verification]") {
    const double ratio = GENERATE(0.1, 0.3, 1.0, 1.7, 10.0);
    const bool force_prescribed = GENERATE(false, true);
    CAPTURE(ratio, force_prescribed);
    const SemiAxes axes{ratio, 1};
    const Errors coarse = errors_of(axes, 40, force_prescribed), fine = errors_of(axes, 80, force_prescribed);
    CHECK(fine.load < 1e-3);
    CHECK(fine.pmax < 1e-3);
    CHECK(fine.area < 1.5e-2);
    CHECK(fine.load < 0.5 * coarse.load);
    CHECK(fine.pmax < 0.5 * coarse.pmax);
    CHECK(fine.area < coarse.area);
}

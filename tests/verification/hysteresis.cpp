// A sphere under a constant normal load whose tangential force goes to +Q, back to -Q and to +Q again, step by step
// (Mindlin and Deresiewicz 1953; Johnson, section 7.4). With nu = 0 x and y do not couple, so that theory and
// discretisation solve the same problem.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contact/contact_cases.hpp"
#include "contactd/convolution.hpp"
#include "contactd/normal.hpp"
#include "contactd/prescribed_force.hpp"
#include "contactd/reference.hpp"
#include "contactd/slip.hpp"
#include "contactd/tangential.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr int n = 60;
constexpr double mu = 0.4, approach = 0.02, radius = 50;
const BodyPair bodies{{200, 0}, {200, 0}};

// The contact on its way: every step starts where the last one ended.
struct Path {
    Grid grid = Grid::centred(n, n, 2.4 / n, 2.4 / n);
    ConvolutionOperator influence{half_space_pair(grid, bodies.upper), n, n};
    Values bound, traction_x = Values(grid.size()), traction_y = Values(grid.size());
    double largest = 0;          // force in full slip
    double shift = 0, work = 0;  // since the beginning: displacement of the force, and what friction dissipated
    Observer observer;

    Path() {
        Values gap;
        for (int iy = 0; iy < n; ++iy)
            for (int ix = 0; ix < n; ++ix)
                gap.push_back((std::pow(grid.x(ix), 2) + std::pow(grid.y(iy), 2)) / (2 * radius) - approach);
        bound = solve_normal(influence, gap, {}, {}, observer).pressure;
        for (double& g : bound) {
            g *= mu;
            largest += g * grid.element_area();
        }
    }

    // Fx as a part of the largest force.
    void step(double Fx) {
        Values history_x(bound.size()), history_y(bound.size());
        influence.tangential(traction_x, traction_y, history_x, history_y);
        for (double& value : history_y) value = -value;
        TangentialSolution solution;
        solution.traction_x = traction_x;
        solution.traction_y = traction_y;
        Values rigid_x;
        const auto solve = [&](double wx, double wy, double tolerance) {
            rigid_x = Values(bound.size(), wx);
            for (std::size_t i = 0; i < bound.size(); ++i) rigid_x[i] -= history_x[i];
            Values rigid_y = history_y;
            for (double& value : rigid_y) value += wy;
            solution = solve_tangential(influence, bound, rigid_x, rigid_y, {tolerance, 1000}, solution.traction_x,
                                        solution.traction_y, observer);
            ForcesAtSlip forces{0, 0, solution.evidence.converged};
            for (std::size_t i = 0; i < bound.size(); ++i) {
                forces.Fx += solution.traction_x[i] * grid.element_area();
                forces.Fy += solution.traction_y[i] * grid.element_area();
            }
            return forces;
        };
        PrescribedForces prescribed;
        prescribed.Fx = Fx * largest;
        prescribed.largest = largest;
        prescribed.scale = slip_scale(influence, bound);
        const auto found = find_rigid_slip(prescribed, {}, solve, observer);
        REQUIRE(found.evidence.converged);
        shift += found.wx;
        traction_x = solution.traction_x;
        traction_y = solution.traction_y;
        const auto slip = slip_distance(influence, bound, rigid_x, history_y, traction_x, traction_y);
        const double dissipated = friction_work(traction_x, traction_y, slip, grid.element_area());
        CHECK(dissipated >= -1e-9 * largest * prescribed.scale);
        work += dissipated;
    }
};

}  // namespace

TEST_CASE("a force that goes to and fro closes its hysteresis loop", "[verification]") {
    constexpr double highest = 0.8;  // of mu Fn
    constexpr int steps = 40;        // from +Q to -Q
    const auto hertz = reference::hertz(bodies, radius, approach);
    const double largest = mu * hertz.Fn;
    const double full = reference::cattaneo(bodies, hertz, mu, largest).rigid_shift;
    constexpr double discretisation = 2e-3;  // of the shift of full slip, at 50 elements across the contact
    Path path;
    // The force on the upper body opposes its shift: a push +Q on the upper body is a traction -Q.
    path.step(-highest);
    const double loaded = path.shift;
    CHECK_THAT(loaded,
               WithinAbs(reference::cattaneo(bodies, hertz, mu, highest * largest).rigid_shift, discretisation * full));
    const double before = path.work;
    double area = 0, last_shift = path.shift, last_push = highest;
    const auto go_to = [&](double push) {
        path.step(-push);
        area += 0.5 * (push + last_push) * path.largest * (path.shift - last_shift);
        last_shift = path.shift;
        last_push = push;
    };
    for (int k = 1; k <= steps; ++k) {
        const double push = highest * (1 - 2.0 * k / steps);
        go_to(push);
        CHECK_THAT(path.shift,
                   WithinAbs(reference::unloading_shift(bodies, hertz, mu, highest * largest, push * largest),
                             discretisation * full));
    }
    CHECK_THAT(path.shift, WithinAbs(-loaded, 1e-5 * full));
    for (int k = 1; k <= steps; ++k) {
        const double push = highest * (2.0 * k / steps - 1);
        go_to(push);
        CHECK_THAT(path.shift,
                   WithinAbs(-reference::unloading_shift(bodies, hertz, mu, highest * largest, -push * largest),
                             discretisation * full));
    }
    CHECK_THAT(path.shift, WithinAbs(loaded, 1e-5 * full));
    // Elements slip at their final traction: what friction dissipates is the area of the loop, for any number of steps
    // more than the trapezoids.
    const double dissipated = path.work - before;
    CHECK_THAT(dissipated, WithinRel(reference::dissipated_work(bodies, hertz, mu, highest * largest), 0.03));
    CHECK_THAT(area, WithinRel(dissipated, 0.03));
}

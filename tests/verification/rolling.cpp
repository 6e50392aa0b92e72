// Compares steady rolling with an established code, Kalker's linear theory and Carter's solution.
#include <catch2/generators/catch_generators.hpp>
#include <numbers>

#include "closed_forms/hertz.hpp"
#include "contact/normal/normal.hpp"
#include "contact/rolling_cases.hpp"
#include "support/closed_forms.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double at_centres = 0, ahead = 1.0 / 6;  // where spin is evaluated

// Semi-axes 6 x 4 mm, 25 x 25 elements over 1.1 times the ellipse's box, Fn = 50 kN, mu = 0.3, dq = dx.
struct EllipticCase : RollingCase {
    NormalSolution normal;

    explicit EllipticCase(double spin_offset)
        : RollingCase(Grid::of_elements(25, 25, 13.2 / 25, 8.8 / 25), {82000, 0.28}, 1, 0, 13.2 / 25) {
        const Paraboloid gap = radii_of_force({6, 4}, (1 - 0.28) / 82000, 50000);
        Observer observer;
        normal =
            solve_normal_force(influence, sampled(gap, grid), 50000 / grid.element_area(), {1e-10, 1000}, {}, observer);
        bound = normal.pressure;
        for (double& g : bound) g *= 0.3;
        set(0.002, 0.001, 1e-4);
        rolling.spin_offset = spin_offset;
    }
};

}  // namespace

TEST_CASE("steady rolling agrees with the same discretisation marched until it stands", "[verification]") {
    const EllipticCase rolling(at_centres);

    const RollingSolution solution = rolling.steady();

    CHECK_THAT(rolling.normal.approach, WithinRel(0.0665015273, 1e-7));
    CHECK_THAT(largest(rolling.normal.pressure), WithinRel(994.992217, 1e-7));
    const TangentialForces forces = rolling.forces(solution);
    CHECK_THAT(forces.Fx, WithinAbs(-11613.934, 0.02));
    CHECK_THAT(forces.Fy, WithinAbs(-6903.784, 0.02));
    CHECK_THAT(forces.Mz, WithinAbs(-307.506, 0.05));
    CHECK_THAT(count(solution).adhesion, WithinAbs(122, 2));
    CHECK_THAT(count(solution).slip, WithinAbs(299, 2));
    check_steady_law(rolling, solution, 2e-5);
}

TEST_CASE("steady rolling agrees with an established code, which evaluates spin ahead", "[verification]") {
    const EllipticCase rolling(ahead);
    const RollingSolution solution = rolling.steady();
    const TangentialForces forces = rolling.forces(solution);
    CHECK_THAT(forces.Fx, WithinAbs(-11602.4363, 0.02));
    CHECK_THAT(forces.Fy, WithinAbs(-6944.5750, 0.02));
    CHECK_THAT(forces.Mz, WithinAbs(-298.8978, 0.05));
    CHECK(count(solution).adhesion == 121);
    CHECK(count(solution).slip == 300);
}

TEST_CASE("the transient marches to the steady state", "[verification]") {
    const EllipticCase rolling(GENERATE(at_centres, ahead));
    const TangentialForces direct = rolling.forces(rolling.steady({1e-8, 1000}));
    ContactProblem problem;
    problem.grid = rolling.grid;
    problem.bodies = {{82000, 0.28}, {82000, 0.28}};
    problem.gap = radii_of_force({6, 4}, (1 - 0.28) / 82000, 50000);
    problem.Fn = 50000;
    problem.settings.normal.tolerance = 1e-10;
    problem.settings.tangential.tolerance = 1e-7;
    problem.friction = FrictionLaw{{0.3}};
    Rolling transient = rolling.rolling;
    transient.dq = rolling.dq;
    transient.kind = RollingKind::transient;
    transient.steps = 250;
    problem.motion = transient;

    const ContactSolution marched = solve_half_spaces(problem);

    REQUIRE(marched.converged());
    CHECK_THAT(marched.forces.Fx, WithinAbs(direct.Fx, 0.02));
    CHECK_THAT(marched.forces.Fy, WithinAbs(direct.Fy, 0.02));
    CHECK_THAT(marched.forces.Mz, WithinAbs(direct.Mz, 0.05));
}

TEST_CASE("small creepages give Kalker's coefficients, the better the finer the grid", "[verification]") {
    // a/b = 1, nu = 0.25; radius and G are 1. The elements' edges approximate the circle, so the error falls with the
    // element size, but not smoothly.
    constexpr double creepage = 1e-9;
    struct Coefficients {
        double C11, C22, C23, C32, C33;
    };
    const auto coefficients = [&](int n) {
        RollingCase rolling(Grid::of_elements(n, n, 2.0 / n, 2.0 / n), {1, 0.25}, 1, 0, 2.0 / n);
        const auto forces = [&](double xi, double eta, double phi) {
            rolling.set(xi, eta, phi);
            const RollingSolution solution = rolling.steady();
            REQUIRE(solution.evidence.converged);
            CHECK(count(solution).slip == 0);
            return rolling.forces(solution);
        };
        const TangentialForces along = forces(creepage, 0, 0), across = forces(0, creepage, 0);
        const TangentialForces spin = forces(0, 0, creepage);
        return Coefficients{-along.Fx / creepage, -across.Fy / creepage, -spin.Fy / creepage, across.Mz / creepage,
                            -spin.Mz / creepage};
    };

    const Coefficients coarse = coefficients(20), fine = coefficients(80), finest = coefficients(160);

    CHECK_THAT(finest.C11, WithinRel(4.12, 0.005));
    CHECK_THAT(finest.C22, WithinRel(3.67, 0.005));
    CHECK_THAT(finest.C23, WithinRel(1.47, 0.01));
    CHECK_THAT(finest.C32, WithinRel(1.47, 0.01));
    CHECK_THAT(finest.C33, WithinRel(1.19, 0.01));
    CHECK_THAT(fine.C11, WithinRel(4.12, 0.02));
    CHECK_THAT(fine.C22, WithinRel(3.67, 0.02));
    CHECK_THAT(fine.C23, WithinRel(1.47, 0.02));
    CHECK_THAT(fine.C33, WithinRel(1.19, 0.02));
    CHECK(std::abs(coarse.C11 - 4.12) > 4 * std::abs(finest.C11 - 4.12));
    CHECK(std::abs(coarse.C22 - 3.67) > 4 * std::abs(finest.C22 - 3.67));
    CHECK(std::abs(coarse.C33 - 1.19) > 4 * std::abs(finest.C33 - 1.19));
}

TEST_CASE("a long line contact rolls as Carter describes", "[verification]") {
    const Material material{1000, 0.25};
    const MaterialPair pair{material, material};
    constexpr double mu = 0.3, R = 60;
    const auto contact = reference::line_contact(pair, R, 10);
    const double force_over_limit = GENERATE(0.25, 0.5, 0.75, 0.9);
    const auto carter = reference::carter_of_force(pair, contact, mu, -force_over_limit * mu * contact.force);
    double last_error = 1;
    for (const int n : {50, 100, 200}) {
        const double dx = 2 * contact.half_width / n;
        // Elements may not be longer than this; three of them are long enough for the middle one.
        const double dy = 999 * dx;
        const int ny = 2 * static_cast<int>(std::ceil(20 * contact.half_width / dy)) + 1;
        RollingCase rolling(Grid::of_elements(n, ny, dx, dy), material, 1, 0, dx);
        for (std::size_t i = 0; i < rolling.bound.size(); ++i) {
            const double x = rolling.grid.x(static_cast<int>(i) % n) / contact.half_width;
            rolling.bound[i] = mu * contact.pmax * std::sqrt(1 - x * x);
        }
        rolling.set(carter.creepage, 0, 0);

        const RollingSolution solution = rolling.steady();

        REQUIRE(solution.evidence.converged);
        double force = 0, adhesion = 0;
        for (int ix = 0; ix < n; ++ix) {
            const std::size_t i = at(rolling.grid, ix, ny / 2);
            force += solution.traction_x[i] * dx;
            adhesion += solution.element_division[i] == ElementState::adhesion ? dx : 0;
        }
        CAPTURE(n, force, carter.force, adhesion, carter.adhesion_half);
        const double error = std::abs(force / carter.force - 1);
        CHECK(error < 0.6 * last_error);  // first order: that of the leading edge
        last_error = error;
        CHECK(error < 0.01);
        CHECK_THAT(adhesion, WithinAbs(2 * carter.adhesion_half, std::max(0.02 * carter.adhesion_half, 1.5 * dx)));
    }
    CHECK(last_error < 0.002);
}

// Tests contact problems at the limits of valid input: no or little friction in parts of the contact, failing steps,
// and numbers whose squares exceed the range of a double.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <string>

#include "contact_cases.hpp"
#include "contactd/error.hpp"
#include "contactd/solve_contact.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

/// Returns the field for which the problem is refused; empty if it is solved.
std::string refused(const ContactProblem& problem) {
    try {
        validate(problem);
    } catch (const InvalidArgument& error) {
        return error.field();
    }
    return {};
}

}  // namespace

TEST_CASE("a step that fails on the way is not forgotten at the end", "[limits]") {
    ContactProblem problem = cattaneo_problem(12);
    problem.settings.tangential.max_iterations = 6;
    problem.motion = Rolling{.xi = 4e-3, .phi = 1e-3, .kind = RollingKind::transient};
    REQUIRE_FALSE(solve_half_spaces(problem).converged());
    problem.motion = Rolling{.xi = 4e-3, .phi = 1e-3, .kind = RollingKind::transient, .steps = 40};
    const auto marched = solve_half_spaces(problem);
    CHECK_FALSE(marched.converged());
    CHECK(marched.evidence.tangential->residual > problem.settings.tangential.tolerance);
    problem.motion = Rolling{.xi = 4e-3, .phi = 1e-3, .kind = RollingKind::transient};
    problem.previous = {marched.pressure, marched.traction_x, marched.traction_y};
    problem.initial.traction_x = marched.traction_x;
    problem.initial.traction_y = marched.traction_y;
    CHECK(solve_half_spaces(problem).converged());  // only the last step is easy
}

TEST_CASE("elements without friction slip as far as their neighbours and the motion take them", "[limits]") {
    ContactProblem problem = cattaneo_problem(12);
    const Grid& grid = problem.grid;
    Values mu(grid.size(), 0.4);
    for (int iy = 4; iy < 8; ++iy) mu[at(grid, 5, iy)] = 0;
    problem.friction->mu = mu;
    const auto solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    const IcTable pair = pair_table(problem);
    const auto u = sum(dense_product(pair, Axis::x, Axis::x, grid.nx, grid.ny, solution.traction_x),
                       dense_product(pair, Axis::x, Axis::y, grid.nx, grid.ny, solution.traction_y));
    for (int iy = 4; iy < 8; ++iy) {
        const std::size_t i = at(grid, 5, iy);
        REQUIRE(solution.pressure[i] > 0);
        CHECK(solution.element_division[i] == ElementState::slip);
        CHECK(solution.traction_x[i] == 0);
        CHECK_THAT(solution.slip_x[i], WithinAbs(0.00817 + u[i], 1e-8));
    }
}

TEST_CASE("where nothing rubs the slip is that of the motion", "[limits]") {
    ContactProblem problem = cattaneo_problem(10);
    problem.friction->mu = {0};
    problem.motion =
        GENERATE(Motion{Rolling{.xi = 1e-3, .phi = 2e-3, .spin_offset = 0}},
                 Motion{Rolling{.xi = 1e-3, .phi = 2e-3, .spin_offset = 0, .kind = RollingKind::transient, .steps = 2}},
                 Motion{Shift{.rigid_shift = {.x = 1e-3}, .rotation = 2e-3}});
    const auto solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    for (int iy = 0; iy < 10; ++iy)
        for (int ix = 0; ix < 10; ++ix) {
            const std::size_t i = at(problem.grid, ix, iy);
            const double factor = solution.pressure[i] > 0 ? 1 : 0;
            CHECK_THAT(solution.slip_x[i], WithinAbs(factor * (1e-3 - 2e-3 * problem.grid.y(iy)), 1e-12));
            CHECK_THAT(solution.slip_y[i], WithinAbs(factor * 2e-3 * problem.grid.x(ix), 1e-12));
        }
}

TEST_CASE("falling friction that ends at nothing lets go", "[limits]") {
    ContactProblem problem = cattaneo_problem(12);
    // The whole contact slides a hundred times faster than the end of friction.
    problem.motion = GENERATE(Motion{Shift{.rigid_shift = {.x = 0.1}}}, Motion{Rolling{.xi = 0.1}});
    problem.friction->kinetic = KineticFriction{GENERATE(SlipLaw::linear, SlipLaw::exponential), 0, 1e-3};
    const auto solution = solve_half_spaces(problem);
    CHECK(solution.converged());
    CHECK(solution.elements.slip == solution.elements.contact);
    CHECK_THAT(solution.forces.Fx, WithinAbs(0, 1e-6 * solution.forces.Fn));
}

TEST_CASE("a coefficient of friction whose squares underflow is none", "[limits]") {
    ContactProblem problem = cattaneo_problem(10);
    problem.motion = GENERATE(Motion{Shift{.rigid_shift = {.x = 1e-3}}}, Motion{Rolling{.xi = 1e-3}});
    Values mu(problem.grid.size(), 1e-170);
    mu[at(problem.grid, 4, 5)] = 0.4;
    problem.friction->mu = GENERATE_COPY(Values{1e-170}, mu);
    const auto solution = solve_half_spaces(problem);
    CHECK(solution.converged());
    CHECK(std::isfinite(solution.forces.Fx));
    CHECK((solution.forces.Fx < 0) == (problem.friction->mu.size() > 1));
}

TEST_CASE("numbers whose squares leave the range of a double are refused by name", "[limits]") {
    ContactProblem problem = cattaneo_problem(10);
    Values values(problem.grid.size());
    values[7] = -1e200;
    std::string field;
    SECTION("gap") {
        problem.gap = values;
        field = "gap.array";
    }
    SECTION("radius") {
        problem.gap = Paraboloid{1, -1e-160};
        field = "gap.paraboloid.Ry";
    }
    SECTION("semi-axis") {
        problem.gap = SemiAxes{1e-60, 1};
        field = "gap.semi_axes.a";
    }
    SECTION("element") {
        problem.grid.dy = 1e-160;
        field = "grid.dy";
    }
    SECTION("modulus") {
        problem.bodies.lower.material.G = 1e-160;
        field = "bodies.lower.G";
    }
    SECTION("step before") {
        problem.previous.traction_x = values;
        field = "previous.traction_x";
    }
    SECTION("estimate") {
        problem.initial.pressure = values;
        field = "initial.pressure";
    }
    SECTION("coefficients") {
        problem.bodies.pair = GivenIcs{pair_table(problem), problem.grid.dx, problem.grid.dy};
        REQUIRE(refused(problem).empty());
        auto& table = problem.bodies.pair->table;
        SECTION("large") {
            table(Axis::x, Axis::z, 1, 0) = 1e200;
        }
        SECTION("small") {
            for (const Axis i : {Axis::x, Axis::y, Axis::z})
                for (int l = 0; l < 10; ++l)
                    for (int k = 0; k < 10; ++k) table(i, i, k, l) *= 1e-250;
        }
        field = "ics.table";
    }
    CHECK(refused(problem) == field);
}

TEST_CASE("the most slender ellipse that can be asked for has finite forces", "[limits]") {
    ContactProblem problem = cattaneo_problem(3);
    problem.model = Model::hertz;
    problem.gap = GENERATE(SemiAxes{1e-12, 1e12}, SemiAxes{1e12, 1e-12});
    problem.approach.reset();
    problem.Fn = 10;
    problem.motion = GENERATE(Motion{Shift{.rigid_shift = {.x = 1e-9}}}, Motion{Rolling{.xi = 1e-9}});
    Observer observer;
    const double Fx = solve_contact(problem, {}, observer).forces.Fx;
    CHECK(Fx < 0);
    CHECK(Fx >= -0.4 * 10 * (1 + 1e-12));
}

TEST_CASE("adhesion dissipates nothing", "[limits]") {
    ContactProblem problem = cattaneo_problem(12);
    problem.friction->mu = {1000};
    const auto shifted = solve_half_spaces(problem);
    REQUIRE(shifted.elements.slip == 0);
    CHECK(*shifted.frictional_work == 0);
    problem.motion = Rolling{.xi = 1e-3, .kind = RollingKind::transient};
    const auto rolled = solve_half_spaces(problem);
    REQUIRE(rolled.elements.slip == 0);
    CHECK(*rolled.frictional_power == 0);
}

TEST_CASE("a simplified model says that its arrays miss the contact", "[limits]") {
    ContactProblem problem = cattaneo_problem(10);
    problem.model = Model::hertz;
    Observer observer;
    CHECK(solve_contact(problem, {}, observer).warnings.empty());
    SECTION("too narrow for the elements") {
        problem.gap = Paraboloid{1e-3, 50};
    }
    SECTION("beyond the potential contact area") {
        problem.grid.x0 = 20;
    }
    const auto solution = solve_contact(problem, {}, observer);
    REQUIRE(solution.forces.Fn > 0);
    REQUIRE(solution.elements.contact == 0);
    REQUIRE_FALSE(solution.warnings.empty());
    CHECK(solution.warnings.back().find("whole contact") != std::string::npos);
}

TEST_CASE("a force that falling friction cannot hold is not found, and only one beyond static friction refused",
          "[limits]") {
    ContactProblem problem = cattaneo_problem(12);
    problem.approach.reset();
    problem.Fn = 10;
    problem.friction->kinetic = KineticFriction{GENERATE(SlipLaw::linear, SlipLaw::exponential), 0.2, 1e-4};
    const bool rolls = GENERATE(true, false);
    const auto pull = [&](double force) {
        if (rolls)
            problem.motion = Rolling{.force = {.Fx = -force}};
        else
            problem.motion = Shift{.force = {.Fx = -force}};
        return solve_half_spaces(problem);
    };
    CHECK(pull(0.3 * 0.4 * 10).converged());
    const auto most = pull(0.999 * 0.4 * 10);
    CHECK_FALSE(most.converged());
    CHECK(std::isfinite(most.evidence.force->residual));
    CHECK_THROWS_AS(pull(0.4 * 10), InvalidArgument);
    CHECK_THROWS_AS(pull(1.01 * 0.4 * 10), InvalidArgument);
}

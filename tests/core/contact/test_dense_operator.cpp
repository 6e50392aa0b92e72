// Tests the solvers on an operator of another kind, because they depend on InfluenceOperator and StepOperator only.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <string>

#include "contact/normal/normal.hpp"
#include "contact/tangential/tangential.hpp"
#include "dense_operator.hpp"
#include "random_derivatives.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Returns the operators of the problem, as matrices.
ContactInfluence dense_influence(const ContactProblem& problem) {
    const IcTable pair = pair_table(problem);
    const std::size_t n = problem.grid.size();
    ContactInfluence influence;
    influence.current = std::make_shared<const DenseOperator>(DenseMatrices(n, 3, entries_of(pair, problem.grid)));
    const auto [x, y] = step_of(problem);
    if (x == 0 && y == 0) return influence;
    const ShiftedTable change =
        change_over_step(pair, shifted_half_spaces({problem.bodies.materials()}, problem.grid, x, y));
    influence.increment = std::make_shared<const DenseStep>(DenseMatrices(n, 2, entries_of(change, problem.grid)));
    return influence;
}

/// Adds one body as a matrix and the other as a convolution.
ContactInfluence sum_of_kinds(const ContactProblem& problem) {
    ContactProblem upper = problem, lower = problem;  // with one deformable body, as the lower one
    upper.bodies = {{Material::rigid()}, problem.bodies.upper};
    lower.bodies = {{Material::rigid()}, problem.bodies.lower};
    return sum_of(dense_influence(upper), make_influence(lower, pair_table(lower)));
}

/// Creates an ellipse of nine by seven elements.
ContactProblem ellipse() {
    ContactProblem problem;
    problem.grid = Grid::of_elements(11, 9, 0.2, 0.25);
    problem.bodies = {{1000, 0.28}, {1000, 0.28}};
    problem.gap = Paraboloid{60, 45};
    problem.Fn = 50;
    problem.settings.normal.tolerance = 1e-10;
    problem.settings.tangential.tolerance = 1e-9;
    problem.settings.outer.tolerance = 1e-8;
    return problem;
}

}  // namespace

TEST_CASE("every solver runs on a dense operator and gives the convolution's answers", "[contact][dense]") {
    const bool dissimilar = GENERATE(false, true);
    const bool summed = GENERATE(false, true);  // two bodies of different kinds
    ContactProblem problem = ellipse();
    std::string name;
    const auto with = [&](const char* what, const Motion& motion) {
        name = what;
        problem.friction = FrictionLaw{{0.3}};
        problem.motion = motion;
    };
    SECTION("force prescribed") {
        name = "force";
    }
    SECTION("approach prescribed") {
        problem.Fn.reset();
        problem.approach = 0.02;
    }
    SECTION("shift") {
        with("shift", Shift{.rigid_shift = {0.001, -0.0005}, .rotation = 0.0003});
    }
    SECTION("shift by a force") {
        with("shift by a force", Shift{.force = {-9, 3}});
    }
    SECTION("steady rolling") {
        with("steady", Rolling{.xi = 0.002, .eta = -0.001, .phi = 0.001, .chi = 0.2});
    }
    SECTION("rolling by forces") {
        with("rolling by forces", Rolling{.phi = 0.001, .force = {-8, 2}});
    }
    SECTION("transient rolling") {
        with("transient", Rolling{.xi = 0.002, .phi = 0.001, .dq = 0.15, .kind = RollingKind::transient, .steps = 4});
    }
    if (dissimilar) problem.bodies = {{1000, 0.28}, {400, 0.4}};
    CAPTURE(name, dissimilar, summed);
    Observer observer;

    const ContactSolution dense =
        solve_contact(problem, summed ? sum_of_kinds(problem) : dense_influence(problem), observer);
    const ContactSolution convolved = solve_contact(problem, make_influence(problem, pair_table(problem)), observer);

    REQUIRE(dense.converged());
    REQUIRE(convolved.converged());
    CHECK_THAT(dense.forces.Fn, WithinRel(convolved.forces.Fn, 1e-8));
    CHECK_THAT(dense.approach, WithinRel(convolved.approach, 1e-8));
    const double unit = convolved.pmax;
    for (std::size_t i = 0; i < dense.pressure.size(); ++i) {
        CHECK_THAT(dense.pressure[i], WithinAbs(convolved.pressure[i], 1e-6 * unit));
        CHECK_THAT(dense.traction_x[i], WithinAbs(convolved.traction_x[i], 1e-5 * unit));
        CHECK_THAT(dense.traction_y[i], WithinAbs(convolved.traction_y[i], 1e-5 * unit));
    }
    CHECK(dense.element_division == convolved.element_division);
}

TEST_CASE("derivatives on a dense operator are those on the convolution", "[contact][dense][derivatives]") {
    const bool dissimilar = GENERATE(false, true);
    const bool summed = GENERATE(false, true);
    const Motion motion = GENERATE(Motion(Shift{.rigid_shift = {0.001, -0.0005}, .rotation = 0.0003}),
                                   Motion(Rolling{.xi = 0.002, .eta = -0.001, .phi = 0.001, .chi = 0.2}));
    ContactProblem problem = ellipse();
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = motion;
    problem.derivatives = true;
    if (dissimilar) problem.bodies = {{1000, 0.28}, {400, 0.4}};
    CAPTURE(motion.index(), dissimilar, summed);
    Observer observer;

    const ContactSolution dense =
        solve_contact(problem, summed ? sum_of_kinds(problem) : dense_influence(problem), observer);
    const ContactSolution convolved = solve_contact(problem, make_influence(problem, pair_table(problem)), observer);

    REQUIRE(dense.derivatives);
    REQUIRE(convolved.derivatives);
    for (int input = 0; input < derivative_inputs; ++input) {
        CAPTURE(input);
        const DerivativeRows one = rows_of(*dense.derivatives, input, 1),
                             other = rows_of(*convolved.derivatives, input, 1);
        double largest = 0;
        for (std::size_t row = 0; row < 3; ++row) largest = std::max(largest, std::abs(other[row]));
        for (std::size_t row = 0; row < 3; ++row) CHECK_THAT(one[row], WithinAbs(other[row], 1e-4 * largest));
    }
    CHECK_THAT(*dense.derivatives->approach->Fn, WithinRel(*convolved.derivatives->approach->Fn, 1e-4));
}

// The elements of a non-uniform body have different self-influences: A_ij s_i s_j is symmetric and positive.
TEST_CASE("solvers take operators whose elements are unlike each other", "[contact][dense]") {
    const ContactProblem problem = ellipse();
    const Grid& grid = problem.grid;
    const std::size_t n = grid.size();
    const auto even = entries_of(pair_table(problem), grid);
    const auto softness = [&](std::size_t at) {
        return 1 + 0.08 * static_cast<double>(at) / static_cast<double>(n) * 9;
    };
    const DenseOperator influence(DenseMatrices(n, 3, [&](Axis i, Axis j, std::size_t at, std::size_t from) {
        return softness(at) * softness(from) * even(i, j, at, from);
    }));
    Values gap = sampled(Paraboloid{60, 45}, grid);
    for (double& h : gap) h -= 0.02;
    Observer observer;

    const NormalSolution normal = solve_normal(influence, gap, {1e-10, 1000}, {}, observer);

    REQUIRE(normal.evidence.converged);
    Values u(n);
    influence.normal(normal.pressure, u);
    int in_contact = 0;
    for (std::size_t i = 0; i < n; ++i) {
        CHECK(normal.pressure[i] >= 0);
        in_contact += normal.pressure[i] > 0;
        if (normal.pressure[i] > 0)
            CHECK_THAT(u[i] + gap[i], WithinAbs(0, 1e-8 * 0.02));
        else
            CHECK(u[i] + gap[i] >= -1e-8 * 0.02);
    }
    CHECK(in_contact > 20);

    Values bound = normal.pressure;
    for (double& g : bound) g *= 0.3;
    const Values shift(n, 0.0005), none(n);
    const TangentialSolution tangential =
        solve_tangential(influence, bound, shift, none, {1e-9, 1000}, {}, {}, observer);

    REQUIRE(tangential.evidence.converged);
    Values sx(n), sy(n);
    influence.tangential(tangential.traction_x, tangential.traction_y, sx, sy);
    int adhering = 0, slipping = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double px = tangential.traction_x[i], py = tangential.traction_y[i], p = std::hypot(px, py);
        const double slip_x = sx[i] + shift[i], slip_y = sy[i];
        if (tangential.element_division[i] == ElementState::adhesion) {
            ++adhering;
            CHECK(p <= bound[i]);
            CHECK_THAT(std::hypot(slip_x, slip_y), WithinAbs(0, 1e-7 * 0.0005));
        } else if (tangential.element_division[i] == ElementState::slip) {
            ++slipping;
            CHECK_THAT(p, WithinRel(bound[i], 1e-9));
            CHECK(slip_x * px + slip_y * py <= 0);
            CHECK_THAT((slip_x * py - slip_y * px) / p, WithinAbs(0, 1e-6 * 0.0005));
        }
    }
    CHECK(adhering > 0);
    CHECK(slipping > 0);
}

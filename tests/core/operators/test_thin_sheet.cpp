// Tests a thin sheet between the bodies: its displacements, and contacts in which its effect is small or dominant.
#include "operators/sheets/thin_sheet.hpp"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "contact/contact_cases.hpp"
#include "contactd/error.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

constexpr Material steel{82000, 0.28};

/// Creates a ball of 100 mm on a plane.
ContactProblem ball(int n, double size, const Material& material = steel) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, size / n, size / n);
    problem.bodies = Bodies::of({material, material});
    problem.gap = Paraboloid{100, 100};
    return problem;
}

ContactInfluence influence_of(const ContactProblem& problem) {
    return operators_of(problem, pair_table(problem));
}

double dot(const Values& a, const Values& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace

TEST_CASE("a thin sheet adds its flexibility to each element, on boxes and coarser grids, too", "[thin_sheet]") {
    const ContactProblem problem = ball(24, 6);
    const auto bodies = influence_of(problem).current;
    constexpr double flexibility = 3e-5;
    const ThinSheet sheet(bodies, {flexibility, 0});
    const auto adds = [&](const InfluenceOperator& with, const InfluenceOperator& without) {
        Values p(with.size(), 0.0), u(p.size()), plain(p.size());
        for (std::size_t i = 0; i < p.size(); ++i) p[i] = std::sin(1.0 + static_cast<double>(i));
        with.normal(p, u);
        without.normal(p, plain);
        for (std::size_t i = 0; i < p.size(); ++i) CHECK_THAT(u[i] - plain[i], WithinAbs(flexibility * p[i], 1e-15));
        CHECK_THAT(with.diagonal(Axis::z)[3], WithinRel(without.diagonal(Axis::z)[3] + flexibility, 1e-12));
        CHECK(with.diagonal(Axis::x) == without.diagonal(Axis::x));
    };
    adds(sheet, *bodies);
    REQUIRE(sheet.boxes() != nullptr);
    const ElementBox box{4, 5, 9, 7};
    adds(*sheet.boxes()->influence(box), *bodies->boxes()->influence(box));
    if (bodies->coarser() != nullptr) adds(sheet.coarser()->influence(), bodies->coarser()->influence());
}

TEST_CASE("the preconditioner of a thin sheet is symmetric and positive definite", "[thin_sheet]") {
    const double flexibility = GENERATE(1e-8, 1e-5, 1e-1);
    const ThinSheet sheet(influence_of(ball(16, 4)).current, {flexibility, 0});
    std::mt19937 dice(5);
    std::normal_distribution<double> normal;
    Values a(sheet.size()), b(sheet.size()), za(sheet.size()), zb(sheet.size());
    for (auto* values : {&a, &b}) std::generate(values->begin(), values->end(), [&] { return normal(dice); });
    sheet.precondition(Axis::z, a, za);
    sheet.precondition(Axis::z, b, zb);
    CHECK_THAT(dot(a, zb), WithinRel(dot(b, za), 1e-9));
    CHECK(dot(a, za) > 0);
}

TEST_CASE("between bodies that hardly yield a thin sheet is Winkler's foundation", "[thin_sheet]") {
    ContactProblem problem = ball(100, 6, {1e12, 0.28});
    problem.sheet_flexibility = 1e-4;
    problem.approach = 0.02;
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fn, WithinRel(pi * 100 * 0.02 * 0.02 / 1e-4, 2e-3));  // pi R approach^2/flexibility
    CHECK_THAT(solution.pmax, WithinRel(0.02 / 1e-4, 1e-3));
    CHECK_THAT(solution.area.contact, WithinRel(2 * pi * 100 * 0.02, 0.01));
}

TEST_CASE("pressures through a thin sheet close the gap that is left, whatever its flexibility", "[thin_sheet]") {
    const double flexibility = GENERATE(1e-9, 1e-6, 1e-5, 1e-4, 1e-2);
    ContactProblem problem = ball(60, 8);
    problem.sheet_flexibility = flexibility;
    problem.Fn = 2000;
    problem.displacements = true;
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fn, WithinRel(2000.0, 1e-6));
    Values plain(problem.grid.size());
    influence_of(problem).current->normal(solution.pressure, plain);
    for (int iy = 0; iy < problem.grid.ny; ++iy)
        for (int ix = 0; ix < problem.grid.nx; ++ix) {
            const std::size_t i = static_cast<std::size_t>(iy) * 60 + static_cast<std::size_t>(ix);
            const double x = problem.grid.x(ix), y = problem.grid.y(iy);
            const double gap =
                (x * x + y * y) / 200 + plain[i] + flexibility * solution.pressure[i] - solution.approach;
            if (solution.pressure[i] > 0)
                CHECK(std::abs(gap) < 1e-6 * solution.approach);
            else
                CHECK(gap > -1e-6 * solution.approach);
            CHECK_THAT(solution.displacement_z[i], WithinRel(plain[i] + flexibility * solution.pressure[i], 1e-9));
        }
}

TEST_CASE("a thin sheet makes steady rolling no harder, and simplified models refuse it", "[thin_sheet]") {
    ContactProblem problem = ball(40, 6);
    problem.Fn = 2000;
    problem.friction = FrictionLaw{{0.3}, {}};
    Rolling rolling;
    rolling.xi = 1e-3;
    problem.motion = rolling;
    const double none = solve_half_spaces(problem).forces.Fx;
    problem.sheet_flexibility = 1e-12;
    CHECK_THAT(solve_half_spaces(problem).forces.Fx, WithinRel(none, 1e-6));
    problem.sheet_flexibility = 1e-5;
    const ContactSolution soft = solve_half_spaces(problem);
    CHECK(soft.converged());
    CHECK(soft.pmax < 0.9 * 2000);
    problem.model = Model::hertz;
    CHECK_THROWS_AS(solve_half_spaces(problem), InvalidArgument);
}

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contact_cases.hpp"
#include "contactd/convolution.hpp"
#include "contactd/error.hpp"
#include "contactd/reference.hpp"
#include "contactd/tangential.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinRel;

namespace {

ContactSolution solve(const ContactProblem& problem) {
    const Grid& grid = problem.grid;
    IcSpec spec;
    spec.dx = grid.dx;
    spec.dy = grid.dy;
    spec.nx = grid.nx;
    spec.ny = grid.ny;
    spec.material = problem.bodies.upper;
    const IcTable upper = half_space_table(spec);
    spec.material = problem.bodies.lower;
    const ConvolutionOperator influence(pair_of(upper, half_space_table(spec)), grid.nx, grid.ny);
    Observer observer;
    return solve_contact(problem, influence, observer);
}

}  // namespace

TEST_CASE("sums of a solution are those of its arrays", "[contact]") {
    const ContactProblem problem = cattaneo_problem(12);
    const auto solution = solve(problem);
    REQUIRE(solution.converged());
    double Fn = 0, Fx = 0;
    int contact = 0, adhesion = 0;
    for (std::size_t i = 0; i < problem.grid.size(); ++i) {
        Fn += solution.pressure[i] * problem.grid.element_area();
        Fx += solution.traction_x[i] * problem.grid.element_area();
        contact += solution.pressure[i] > 0;
        adhesion += solution.element_division[i] == ElementState::adhesion;
    }
    CHECK_THAT(solution.Fn, WithinRel(Fn, 1e-12));
    CHECK_THAT(solution.Fx, WithinRel(Fx, 1e-12));
    CHECK(solution.contact_elements == contact);
    CHECK(solution.adhesion_elements == adhesion);
    CHECK(solution.slip_elements == contact - adhesion);
    CHECK_THAT(solution.contact_area, WithinRel(contact * problem.grid.element_area(), 1e-12));
    CHECK_THAT(solution.adhesion_area + solution.slip_area, WithinRel(solution.contact_area, 1e-12));
    CHECK(solution.normal.seconds > 0);
    CHECK(solution.tangential->seconds > 0);
}

TEST_CASE("the force on the upper body opposes its shift", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    CHECK(solve(problem).Fx < 0);
    problem.friction = Friction{0.4, 0, -0.00817};
    CHECK(solve(problem).Fy > 0);
}

TEST_CASE("without friction every contact element slips freely", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    SECTION("no friction given") {
        problem.friction.reset();
    }
    SECTION("coefficient of friction zero") {
        problem.friction->mu = 0;
    }
    const auto solution = solve(problem);
    CHECK(solution.converged());
    CHECK(solution.tangential.has_value() == problem.friction.has_value());
    CHECK(solution.contact_elements == 52);
    CHECK(solution.slip_elements == 52);
    CHECK(solution.Fx == 0);
    CHECK(solution.traction_y.size() == problem.grid.size());
}

TEST_CASE("without a shift every contact element adheres", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    problem.friction->rigid_shift_x = 0;
    const auto solution = solve(problem);
    CHECK(solution.converged());
    CHECK(solution.adhesion_elements == 52);
    CHECK(solution.Fx == 0);
}

TEST_CASE("bodies that do not touch carry nothing", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    problem.approach = -0.001;
    const auto solution = solve(problem);
    CHECK(solution.converged());
    CHECK(solution.Fn == 0);
    CHECK(solution.Fx == 0);
    CHECK(solution.contact_elements == 0);
}

TEST_CASE("a shift along y is a shift along x turned", "[contact]") {
    ContactProblem problem = cattaneo_problem(21);
    problem.grid = Grid::centred(21, 33, 0.11, 0.08);
    problem.undeformed_distance = paraboloid(problem.grid, 40, 60);
    problem.tangential_settings.tolerance = 1e-8;
    const auto along_x = solve(problem);
    problem.grid = Grid::centred(33, 21, 0.08, 0.11);
    problem.undeformed_distance = paraboloid(problem.grid, 60, 40);
    problem.friction = Friction{0.4, 0, 0.00817};
    const auto along_y = solve(problem);
    CHECK_THAT(along_y.Fn, WithinRel(along_x.Fn, 1e-6));
    CHECK_THAT(along_y.Fy, WithinRel(along_x.Fx, 1e-6));
    CHECK(along_y.adhesion_elements == along_x.adhesion_elements);
    CHECK(along_y.slip_elements == along_x.slip_elements);
}

TEST_CASE("a solution is a good estimate for the same problem", "[contact]") {
    ContactProblem problem = cattaneo_problem(40);
    const auto first = solve(problem);
    problem.initial_pressure = first.pressure;
    problem.initial_traction_x = first.traction_x;
    problem.initial_traction_y = first.traction_y;
    const auto again = solve(problem);
    CHECK(again.normal.iterations == 0);
    CHECK(again.tangential->iterations < first.tangential->iterations / 2);
    CHECK_THAT(again.Fx, WithinRel(first.Fx, 1e-6));
}

TEST_CASE("different bodies are solved without friction only", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    problem.bodies.lower = {400, 0.3};
    try {
        solve(problem);
        FAIL("friction between bodies that are not quasi-identical was accepted");
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "bodies.lower");
    }
    problem.friction.reset();
    CHECK(solve(problem).converged());
    problem.friction = Friction{0.4, 0.00817, 0};
    problem.bodies = {{200, 0.3}, {400, 0.1}};  // (1-2nu)/G equal
    CHECK(solve(problem).converged());
}

TEST_CASE("invalid problems and operators of another size are refused", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    const ConvolutionOperator influence(half_space_pair(Grid::centred(9, 10, 1, 1), {200, 0.42}), 9, 10);
    Observer observer;
    CHECK_THROWS_AS(solve_contact(problem, influence, observer), InvalidArgument);
    problem.friction->mu = -1;
    CHECK_THROWS_AS(solve(problem), InvalidArgument);
}

TEST_CASE("progress of the whole computation grows from normal to tangential", "[contact]") {
    struct : Observer {
        double last_normal = -1, first_tangential = -1;
        void on_progress(const Progress& progress) override {
            if (progress.stage == "normal") last_normal = progress.fraction;
            if (progress.stage == "tangential" && first_tangential < 0) first_tangential = progress.fraction;
        }
    } observer;
    const ContactProblem problem = cattaneo_problem(16);
    const ConvolutionOperator influence(half_space_pair(problem.grid, problem.bodies.upper), 16, 16);
    solve_contact(problem, influence, observer);
    CHECK(observer.last_normal >= 0);
    CHECK(observer.first_tangential >= observer.last_normal);
}

TEST_CASE("the Cattaneo problem is solved with bilinear tractions", "[contact]") {
    ContactProblem problem = cattaneo_problem(40);
    problem.ics.load_shape = LoadShape::bilinear;
    const IcTable pair = half_space_pair(problem.grid, problem.bodies.upper, LoadShape::bilinear);
    const ConvolutionOperator influence(pair, 40, 40);
    Observer observer;

    const ContactSolution solution = solve_contact(problem, influence, observer);

    const reference::Hertz hertz = reference::hertz(problem.bodies, 50, problem.approach);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.Fn, WithinRel(hertz.Fn, 2e-3));
    CHECK_THAT(solution.pmax, WithinRel(hertz.pmax, 5e-3));
    CHECK_THAT(solution.Fx, WithinRel(-3.2216, 3e-3));  // the limit h -> 0 with constant elements
}

// Tests bodies of different materials, including rigid ones, in which normal and tangential contact interact.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contact_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Creates a sphere that is pressed on a plane and held against shifting.
ContactProblem sphere(const MaterialPair& bodies, double mu, int n = 24) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, 2.4 / n, 2.4 / n);
    problem.bodies = Bodies::of(bodies);
    problem.gap = Paraboloid{50, 50};
    problem.approach = 0.02;
    problem.friction = FrictionLaw{{mu}};
    problem.motion = Shift{};
    return problem;
}

/// Returns all three components of the displacements due to tractions, by one dense sum.
struct Displacements {
    Values x, y, z;
};
Displacements displacements(const ContactProblem& problem, const ContactSolution& solution) {
    const IcTable table = pair_table(problem);
    const auto along = [&](Axis i) {
        const auto by = [&](Axis j, const Values& p) {
            return dense_product(table, i, j, problem.grid.nx, problem.grid.ny, p);
        };
        return sum(sum(by(Axis::x, solution.traction_x), by(Axis::y, solution.traction_y)),
                   by(Axis::z, solution.pressure));
    };
    return {along(Axis::x), along(Axis::y), along(Axis::z)};
}

/// Creates a rigid cylinder of radius 1 on a plane; the gap is far larger outside its face.
ContactProblem punch(const Material& plane, double mu) {
    ContactProblem problem = sphere({Material::rigid(), plane}, mu, 40);
    Values gap(problem.grid.size(), 1.0);
    for (int iy = 0; iy < problem.grid.ny; ++iy)
        for (int ix = 0; ix < problem.grid.nx; ++ix)
            if (std::hypot(problem.grid.x(ix), problem.grid.y(iy)) < 1) gap[at(problem.grid, ix, iy)] = 0;
    problem.gap = gap;
    return problem;
}

const MaterialPair rigid_on_soft{Material::rigid(), {200, 0.1}};
const MaterialPair soft_on_rigid{{200, 0.1}, Material::rigid()};
const MaterialPair extreme{{200, 0.0}, {200, 0.5}};
const MaterialPair stiff_on_soft{{82000, 0.28}, {10, 0.2}};

}  // namespace

TEST_CASE("dissimilar bodies satisfy all contact conditions at once", "[dissimilar]") {
    const MaterialPair bodies = GENERATE(rigid_on_soft, soft_on_rigid, extreme, stiff_on_soft);
    const double mu = GENERATE(0.05, 0.4);
    ContactProblem problem = sphere(bodies, mu, 16);
    problem.motion = Shift{{0.003, -0.001}};
    problem.settings.outer.tolerance = 1e-9;
    problem.settings.normal.tolerance = problem.settings.tangential.tolerance = 1e-10;

    const ContactSolution solution = solve_half_spaces(problem);

    REQUIRE(solution.converged());
    CHECK(solution.evidence.outer->iterations > 1);
    const Displacements u = displacements(problem, solution);
    const Values h = undeformed_distance(problem);
    const double length = *problem.approach;
    for (std::size_t i = 0; i < problem.grid.size(); ++i) {
        const double gap = h[i] - *problem.approach + u.z[i], p = solution.pressure[i];
        const double sx = u.x[i] + 0.003, sy = u.y[i] - 0.001;
        const double px = solution.traction_x[i], py = solution.traction_y[i];
        if (solution.element_division[i] == ElementState::exterior) {
            CHECK(gap >= -1e-6 * length);
            continue;
        }
        CHECK_THAT(gap, WithinAbs(0, 1e-6 * length));
        CHECK(std::hypot(px, py) <= mu * p * (1 + 1e-7));
        if (solution.element_division[i] == ElementState::adhesion)
            CHECK_THAT(std::hypot(sx, sy), WithinAbs(0, 1e-5 * length));
        else
            CHECK_THAT(sx * px + sy * py, WithinRel(-std::hypot(sx, sy) * mu * p, 1e-4));
    }
}

TEST_CASE("without friction's force, friction between dissimilar bodies is as none", "[dissimilar]") {
    const ContactProblem with = sphere(rigid_on_soft, 1e-7);
    ContactProblem without = with;
    without.friction.reset();
    const ContactSolution a = solve_half_spaces(with), b = solve_half_spaces(without);
    REQUIRE(a.converged());
    CHECK_THAT(a.forces.Fn, WithinRel(b.forces.Fn, 1e-6));
    CHECK_THAT(a.pmax, WithinRel(b.pmax, 1e-6));
}

// Mossakovskii and Spence (Johnson, Contact Mechanics, section 3.7): a flat circular punch that adheres completely
// carries a force of (1-nu) ln(3-4nu)/(1-2nu) times that without friction.
TEST_CASE("a rigid punch that adheres carries the force of Mossakovskii's solution", "[dissimilar]") {
    const double nu = GENERATE(0.0, 0.3);
    ContactProblem bonded = punch({200, nu}, 20);
    ContactProblem smooth = bonded;
    smooth.friction.reset();
    const ContactSolution held = solve_half_spaces(bonded), free = solve_half_spaces(smooth);
    REQUIRE(held.converged());
    CHECK_THAT(held.forces.Fn / free.forces.Fn, WithinRel((1 - nu) * std::log(3 - 4 * nu) / (1 - 2 * nu), 5e-3));
}

TEST_CASE("friction between dissimilar bodies leaves the forces in balance", "[dissimilar]") {
    const ContactSolution solution = solve_half_spaces(sphere(rigid_on_soft, 0.3));
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fx, WithinAbs(0, 1e-5 * solution.forces.Fn));
    CHECK_THAT(solution.forces.Fy, WithinAbs(0, 1e-5 * solution.forces.Fn));
    CHECK_THAT(solution.forces.Mz, WithinAbs(0, 1e-5 * solution.forces.Fn));
    CHECK(*solution.frictional_work >= 0);
}

TEST_CASE("swapping the bodies reverses the tangential tractions", "[dissimilar]") {
    const ContactSolution a = solve_half_spaces(sphere(rigid_on_soft, 0.3, 12)),
                          b = solve_half_spaces(sphere(soft_on_rigid, 0.3, 12));
    CHECK_THAT(a.forces.Fn, WithinRel(b.forces.Fn, 1e-6));
    for (std::size_t i = 0; i < a.traction_x.size(); ++i)
        CHECK_THAT(a.traction_x[i], WithinAbs(-b.traction_x[i], 1e-4 * a.pmax));
}

TEST_CASE("dissimilar bodies roll steadily", "[dissimilar]") {
    ContactProblem problem = sphere(GENERATE(rigid_on_soft, extreme), 0.3);
    problem.approach.reset();
    problem.Fn = 5;
    problem.motion = Rolling{.xi = 0.02, .eta = 0.01, .phi = 1e-3};
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fn, WithinRel(5, 1e-6));
    CHECK(solution.forces.Fx < 0);
    CHECK(*solution.frictional_power > 0);
}

// If each outer iteration solved the normal problem completely, it would take as many iterations as in the first one.
TEST_CASE("outer iterations are not solved better than the next one changes them", "[dissimilar]") {
    ContactProblem problem = sphere(rigid_on_soft, 0.3);
    problem.approach.reset();
    problem.Fn = 8;
    problem.motion = GENERATE(Motion{Shift{.rigid_shift = {0.003, -0.001}}}, Motion{Rolling{.xi = 0.02, .phi = 1e-3}},
                              Motion{Shift{.force = {-1, {}}}}, Motion{Rolling{.phi = 1e-3, .force = {-1, 0.5}}});
    ContactProblem without = problem;
    without.friction.reset();
    const ContactSolution solution = solve_half_spaces(problem), normal = solve_half_spaces(without);
    REQUIRE(solution.converged());
    REQUIRE(solution.evidence.outer->iterations >= 4);
    CHECK(solution.evidence.normal.iterations <
          solution.evidence.outer->iterations * normal.evidence.normal.iterations / 2);
    CHECK(solution.evidence.tangential->iterations < 8 * solution.evidence.outer->iterations);
}

TEST_CASE("outer iterations that begin at one of two contact locations find the other", "[dissimilar]") {
    ContactProblem problem = sphere(extreme, 0.4, 40);
    problem.motion = Shift{{0.003, -0.001}};
    const auto place = [&](double x0) {
        Values gap(problem.grid.size());
        for (int iy = 0; iy < problem.grid.ny; ++iy)
            for (int ix = 0; ix < problem.grid.nx; ++ix)
                gap[at(problem.grid, ix, iy)] =
                    (std::pow(problem.grid.x(ix) - x0, 2) + std::pow(problem.grid.y(iy), 2)) / 10;
        return gap;
    };
    const Values left = place(-0.7), right = place(0.7);
    problem.gap = left;
    const ContactSolution of_left = solve_half_spaces(problem);
    Values both = left;
    for (std::size_t i = 0; i < both.size(); ++i) both[i] = std::min(both[i], right[i]);
    problem.gap = both;
    ContactSolution expected = solve_half_spaces(problem);
    if (GENERATE(false, true)) {  // a force that one of the regions alone cannot carry
        Shift motion;
        motion.force.Fx = -0.75 * 0.4 * expected.forces.Fn;
        problem.motion = motion;
        expected = solve_half_spaces(problem);
    }
    problem.initial.pressure = of_left.pressure;
    const ContactSolution found = solve_half_spaces(problem);

    REQUIRE(found.converged());
    REQUIRE(expected.elements.contact > of_left.elements.contact * 3 / 2);
    for (std::size_t i = 0; i < both.size(); ++i) {
        CHECK_THAT(found.pressure[i], WithinAbs(expected.pressure[i], 1e-5 * expected.pmax));
        CHECK_THAT(found.traction_x[i], WithinAbs(expected.traction_x[i], 1e-5 * expected.pmax));
    }
}

TEST_CASE("dissimilar bodies meet the forces that are given, steadily, by shifts and in transients", "[dissimilar]") {
    ContactProblem problem = sphere(GENERATE(rigid_on_soft, extreme), 0.3);
    problem.approach.reset();
    problem.Fn = 5;
    problem.motion =
        GENERATE(Motion{Shift{.force = {-1, 0.4}}}, Motion{Rolling{.phi = 1e-3, .force = {-1, 0.4}}},
                 Motion{Rolling{.phi = 1e-3, .kind = RollingKind::transient, .steps = 2, .force = {-1, 0.4}}});
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fx, WithinAbs(-1, 1e-5));
    CHECK_THAT(solution.forces.Fy, WithinAbs(0.4, 1e-5));
    CHECK(solution.evidence.force->iterations >= solution.evidence.outer->iterations);
}

TEST_CASE("an outer loop that is cut short says so", "[dissimilar]") {
    ContactProblem problem = sphere(rigid_on_soft, 0.4);
    problem.settings.outer.max_iterations = 1;
    const ContactSolution solution = solve_half_spaces(problem);
    CHECK_FALSE(solution.converged());
    CHECK(std::ranges::any_of(solution.warnings, [](const std::string& warning) {
        return warning.find("stopped after 1 without convergence. Bodies of different materials") != std::string::npos;
    }));
    problem.settings.outer.max_iterations = 100;
    CHECK(solve_half_spaces(problem).warnings.empty());
}

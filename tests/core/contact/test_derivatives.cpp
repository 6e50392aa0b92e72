#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

#include "closed_forms/hertz.hpp"
#include "contactd/error.hpp"
#include "random_derivatives.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Creates a contact in which half of the elements slip; the lower body may differ.
ContactProblem ellipse(const Motion& motion, const Material& lower = {82000, 0.28}) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(21, 21, 13.2 / 21, 8.8 / 21);
    problem.bodies = {{82000, 0.28}, lower};
    problem.gap = Paraboloid{500, 300};
    problem.Fn = 50000;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = motion;
    problem.derivatives = true;
    return problem;
}

Rolling rolling() {
    Rolling motion;
    motion.xi = 8e-4;
    motion.eta = 5e-4;
    motion.phi = 5e-5;
    return motion;
}

std::string warnings_of(const ContactSolution& solution) {
    std::string all;
    for (const std::string& warning : solution.warnings) all += warning + " ";
    return all;
}

}  // namespace

TEST_CASE("derivatives of random problems are central differences", "[derivatives][random]") {
    int problems = 0, compared = 0, skipped = 0;
    for (std::uint64_t seed = 1; problems < 200; ++seed) {
        CAPTURE(seed);
        const ContactProblem problem = differentiable(seed, 20);
        const ContactSolution solution = solve_half_spaces(problem);
        if (!solution.converged() || solution.elements.contact == 0) continue;
        ++problems;
        REQUIRE(solution.derivatives);
        CHECK(solution.evidence.derivatives->converged);
        const DerivativeCheck check = check_derivatives(problem, solution);
        CAPTURE(check.worst, check.error);
        CHECK(check.error <= 1e-4);
        compared += check.compared;
        skipped += check.skipped;
    }
    CHECK(compared > 3 * problems);
    CHECK(skipped < compared / 10);
}

TEST_CASE("derivatives at the tolerances of a request are central differences", "[derivatives]") {
    const Motion motion = GENERATE(Motion(rolling()), Motion(Shift{{0.004, 0.003}, 1e-4}));
    const Material lower = GENERATE(Material{82000, 0.28}, Material{20000, 0.1});
    ContactProblem problem = ellipse(motion, lower);
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.derivatives);
    problem.settings = {{1e-12, 3000}, {1e-11, 3000}, {1e-11, 300}};
    const ContactSolution exact = solve_half_spaces(problem);
    REQUIRE(exact.element_division == solution.element_division);
    ContactSolution same = exact;
    same.derivatives = solution.derivatives;
    const DerivativeCheck check = check_derivatives(problem, same);
    CAPTURE(motion.index(), lower.G, check.worst);
    CHECK(check.compared >= 3);
    CHECK(check.error <= 1e-4);
}

TEST_CASE("derivatives do not change the solution", "[derivatives]") {
    ContactProblem problem = ellipse(rolling());
    const ContactSolution with = solve_half_spaces(problem);
    problem.derivatives = false;
    const ContactSolution without = solve_half_spaces(problem);
    CHECK(!without.derivatives);
    CHECK(!without.evidence.derivatives);
    CHECK(without.traction_x == with.traction_x);
    CHECK(without.slip_y == with.slip_y);
}

TEST_CASE("a sphere stiffens as Hertz has it", "[derivatives]") {
    ContactProblem problem = cattaneo_problem(60);
    problem.friction.reset();
    problem.derivatives = true;
    const ContactSolution pressed = solve_half_spaces(problem);
    REQUIRE(pressed.derivatives);
    CHECK_THAT(*pressed.derivatives->Fn->approach, WithinRel(1.5 * pressed.forces.Fn / 0.02, 0.02));
    CHECK(!pressed.derivatives->Fn->mu);
    CHECK(!pressed.derivatives->Fx);
    CHECK(!pressed.derivatives->approach);

    problem.Fn = pressed.forces.Fn;
    problem.approach.reset();
    const ContactSolution by_force = solve_half_spaces(problem);
    CHECK(!by_force.derivatives->Fn);
    CHECK_THAT(*by_force.derivatives->approach->Fn * *pressed.derivatives->Fn->approach, WithinRel(1, 1e-6));
}

TEST_CASE("forces oppose more motion and follow more friction", "[derivatives]") {
    Rolling motion;
    motion.xi = 8e-4;
    const ContactSolution solution = solve_half_spaces(ellipse(motion));
    const Derivatives& by = *solution.derivatives;
    CHECK(*by.Fx->xi < 0);
    CHECK(*by.Fy->eta < 0);
    CHECK(*by.Fy->phi < 0);
    CHECK(*by.Fx->mu < 0);  // increases the magnitude of the negative force
    CHECK(*by.Fx->Fn < 0);
    const double unit = std::abs(*by.Fx->xi);
    CHECK_THAT(*by.Fx->eta, WithinAbs(0, 1e-4 * unit));  // by symmetry
    CHECK_THAT(*by.Fy->xi, WithinAbs(0, 1e-4 * unit));
    CHECK_THAT(*by.Fy->mu, WithinAbs(0, 1e-4 * std::abs(*by.Fx->mu)));
    CHECK_THAT(*by.approach->xi, WithinAbs(0, 1e-12));  // bodies alike
}

TEST_CASE("a shift that does not slip is an elastic spring", "[derivatives]") {
    ContactProblem problem = ellipse(Shift{{1e-6, 2e-6}, 1e-8});
    problem.friction->mu = {10};
    problem.grid.x0 += 0.3;  // so that a rotation causes a shift, too
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.elements.slip == 0);
    const Derivatives& by = *solution.derivatives;
    const double unit = 1e-5 * std::abs(*by.Mz->rotation);
    CHECK_THAT(by.Fx->rigid_shift->y, WithinRel(by.Fy->rigid_shift->x, 1e-4) ||
                                          WithinAbs(by.Fy->rigid_shift->x, 1e-5 * std::abs(by.Fx->rigid_shift->x)));
    CHECK_THAT(*by.Fx->rotation, WithinAbs(by.Mz->rigid_shift->x, unit));
    CHECK_THAT(*by.Fy->rotation, WithinAbs(by.Mz->rigid_shift->y, unit));
    CHECK(by.Fx->rigid_shift->x < 0);
    CHECK(by.Fy->rigid_shift->y < 0);
    CHECK(*by.Mz->rotation < 0);
    const Shift& shift = std::get<Shift>(problem.motion);
    CHECK_THAT(by.Fx->rigid_shift->x * shift.rigid_shift.x + by.Fx->rigid_shift->y * shift.rigid_shift.y +
                   *by.Fx->rotation * shift.rotation,
               WithinRel(solution.forces.Fx, 1e-4));
    CHECK_THAT(*by.Fx->mu, WithinAbs(0, 1e-6 * std::abs(solution.forces.Fx)));
}

TEST_CASE("friction that begins opposes the slip", "[derivatives]") {
    ContactProblem problem = ellipse(rolling(), GENERATE(Material{82000, 0.28}, Material{20000, 0.1}));
    problem.friction->mu = {0};
    const ContactSolution none = solve_half_spaces(problem);
    REQUIRE(none.derivatives);
    problem.derivatives = false;
    problem.friction->mu = {1e-7};
    const ContactSolution little = solve_half_spaces(problem);
    CHECK_THAT(*none.derivatives->Fx->mu, WithinRel(little.forces.Fx / 1e-7, 1e-3));
    CHECK_THAT(*none.derivatives->Mz->mu, WithinRel(little.forces.Mz / 1e-7, 1e-3));
    CHECK(*none.derivatives->Fx->xi == 0);
}

TEST_CASE("Newton's method on forces converges quadratically with them", "[derivatives]") {
    ContactProblem problem = ellipse(rolling(), GENERATE(Material{82000, 0.28}, Material{20000, 0.1}));
    problem.settings = {{1e-12, 3000}, {1e-12, 3000}, {1e-11, 300}};
    const double Fx = -9000, Fy = -4000;
    std::vector<double> missing;
    for (int iteration = 0; iteration < 8; ++iteration) {
        const ContactSolution solution = solve_half_spaces(problem);
        REQUIRE(solution.derivatives);
        const double rx = Fx - solution.forces.Fx, ry = Fy - solution.forces.Fy;
        missing.push_back(std::hypot(rx, ry) / (0.3 * 50000));
        if (missing.back() < 1e-9) break;
        const DerivativesOfAnswer &x = *solution.derivatives->Fx, &y = *solution.derivatives->Fy;
        const double determinant = *x.xi * *y.eta - *x.eta * *y.xi;
        auto& motion = std::get<Rolling>(problem.motion);
        motion.xi += (rx * *y.eta - ry * *x.eta) / determinant;
        motion.eta += (ry * *x.xi - rx * *y.xi) / determinant;
    }
    CAPTURE(missing);
    REQUIRE(missing.size() >= 3);
    CHECK(missing.back() < 1e-8);
    CHECK(missing.size() <= 7);
    // The number of correct digits doubles as long as derivatives have more digits.
    for (std::size_t i = 1; i + 1 < missing.size(); ++i) {
        if (missing[i] < 0.1) CHECK(missing[i + 1] < std::max(5 * missing[i] * missing[i], 1e-4 * missing[i]));
    }
}

TEST_CASE("where forces are prescribed the derivatives are those at the motion found", "[derivatives]") {
    Motion asked = rolling();
    std::get<Rolling>(asked).force = {-8000, -3000};
    ContactProblem problem = ellipse(asked);
    problem.settings = {{1e-12, 3000}, {1e-11, 3000}, {1e-11, 300}};
    const ContactSolution by_force = solve_half_spaces(problem);
    REQUIRE(by_force.derivatives);
    problem.motion = *by_force.motion;
    std::get<Rolling>(problem.motion).force = {};
    const ContactSolution by_motion = solve_half_spaces(problem);
    REQUIRE(by_motion.element_division == by_force.element_division);
    CHECK_THAT(*by_force.derivatives->Fx->xi, WithinRel(*by_motion.derivatives->Fx->xi, 1e-4));
    CHECK_THAT(*by_force.derivatives->Mz->Fn, WithinRel(*by_motion.derivatives->Mz->Fn, 1e-3));
}

TEST_CASE("semi-axes stand for the gap that they make, which is frozen", "[derivatives]") {
    const Model model = GENERATE(Model::full, Model::fastsim);
    ContactProblem problem = ellipse(rolling());
    problem.model = model;
    problem.gap = SemiAxes{6, 4};
    const ContactSolution by_axes = solve_half_spaces(problem);
    problem.gap = radii_of_force({6, 4}, problem.bodies.materials().normal_compliance(), *problem.Fn);
    const ContactSolution by_radii = solve_half_spaces(problem);
    CHECK_THAT(*by_axes.derivatives->Fx->Fn, WithinRel(*by_radii.derivatives->Fx->Fn, 1e-6));
    CHECK_THAT(*by_axes.derivatives->approach->Fn, WithinRel(*by_radii.derivatives->approach->Fn, 1e-6));
}

TEST_CASE("a line contact has no derivatives by rotation and spin", "[derivatives]") {
    ContactProblem problem;
    problem.grid = Grid::of_elements(60, 1, 0.04, 1);
    Ics ics;
    ics.line_contact = LineContactSpec{1000};
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}}, ics);
    problem.gap = Paraboloid{.Rx = 100};
    problem.Fn = 1000;
    problem.friction = FrictionLaw{{0.3}};
    Rolling motion;
    motion.xi = 1e-3;
    problem.motion = motion;
    problem.derivatives = true;
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.derivatives);
    REQUIRE(solution.elements.adhesion > 5);
    CHECK(*solution.derivatives->Fx->xi < 0);
    CHECK(!solution.derivatives->Fx->phi);
}

TEST_CASE("derivatives that are not known are refused", "[derivatives]") {
    Motion motion = rolling();
    ContactProblem problem = ellipse(motion);
    const auto refused = [&](const char* why) {
        try {
            solve_half_spaces(problem);
        } catch (const InvalidArgument& error) {
            CHECK(error.field() == "derivatives");
            CHECK_THAT(error.what(), ContainsSubstring(why));
            return true;
        }
        return false;
    };
    SECTION("of several steps") {
        auto& transient = std::get<Rolling>(problem.motion);
        transient.kind = RollingKind::transient;
        transient.steps = 3;
        CHECK(refused("step by step"));
        transient.steps = 1;
        CHECK(solve_half_spaces(problem).derivatives);
    }
    SECTION("with a slip law") {
        problem.friction->kinetic = KineticFriction{SlipLaw::exponential, 0.2, 1};
        CHECK(refused("slip law"));
    }
}

TEST_CASE("a solution that has none says why", "[derivatives]") {
    ContactProblem problem = ellipse(rolling());
    problem.model = GENERATE(Model::full, Model::fastsim);
    SECTION("nothing touches") {
        problem.Fn.reset();
        problem.approach = -0.1;
        const ContactSolution solution = solve_half_spaces(problem);
        CHECK(!solution.derivatives);
        CHECK_THAT(warnings_of(solution), ContainsSubstring("no contact"));
    }
    SECTION("a solver missed its tolerance") {
        if (problem.model != Model::full) return;
        problem.settings.tangential.max_iterations = 1;
        const ContactSolution solution = solve_half_spaces(problem);
        REQUIRE(!solution.converged());
        CHECK(!solution.derivatives);
        CHECK_THAT(warnings_of(solution), ContainsSubstring("did not converge"));
    }
}

TEST_CASE("a cancelled solve ends among its derivatives, too", "[derivatives]") {
    struct Late : Observer {
        bool cancelled() const override { return ++asked > allowed; }
        mutable int asked = 0;
        int allowed = 1 << 30;
    } observer;
    const ContactProblem problem = ellipse(rolling());
    const ContactInfluence influence = operators_of(problem, pair_table(problem));
    solve_contact(problem, influence, observer);
    observer.allowed = observer.asked - 1;
    observer.asked = 0;
    CHECK_THROWS_AS(solve_contact(problem, influence, observer), Cancelled);
}

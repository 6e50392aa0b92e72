// Compares the model hertz of line contacts with boundary elements and with central differences.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <limits>

#include "closed_forms/hertz.hpp"
#include "contact/random_derivatives.hpp"
#include "contactd/error.hpp"
#include "support/closed_forms.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double mu = 0.3, P = 1000, length = 7, radius = 100, datum = 400;
const MaterialPair bodies{{82000, 0.28}, {82000, 0.28}};
const reference::LineContact cylinder = reference::line_contact(bodies, radius, P);

ContactProblem pressed(Model model, const MaterialPair& pair = bodies) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(800, 1, 2.2 * cylinder.half_width / 800, length);
    Ics ics;
    ics.line_contact = LineContactSpec{datum};
    problem.bodies = Bodies::of(pair, ics);
    problem.gap = Paraboloid{radius, std::numeric_limits<double>::infinity()};
    problem.Fn = P * length;
    problem.model = model;
    return problem;
}

ContactProblem moved(Model model, const Motion& motion) {
    ContactProblem problem = pressed(model);
    problem.friction = FrictionLaw{{mu}};
    problem.motion = motion;
    return problem;
}

/// By both models.
std::pair<ContactSolution, ContactSolution> both(const Motion& motion) {
    const ContactSolution simplified = solve_half_spaces(moved(Model::hertz, motion));
    CHECK(simplified.converged());
    CHECK(simplified.warnings.empty());
    return {simplified, solve_half_spaces(moved(Model::full, motion))};
}

void check_forces(const ContactSolution& simplified, const ContactSolution& full) {
    const double bound = mu * P * length;
    CHECK_THAT(simplified.forces.Fx, WithinAbs(full.forces.Fx, 1e-3 * bound));
    CHECK_THAT(simplified.forces.Fy, WithinAbs(full.forces.Fy, 1e-3 * bound));
    CHECK_THAT(simplified.forces.Mz, WithinAbs(full.forces.Mz, 1e-3 * bound * cylinder.half_width));
    CHECK_THAT(simplified.area.adhesion, WithinAbs(full.area.adhesion, 0.01 * full.area.contact));
    CHECK_THAT(simplified.area.contact, WithinRel(full.area.contact, 0.005));
}

std::string field_refused(const ContactProblem& problem) {
    try {
        solve_half_spaces(problem);
    } catch (const InvalidArgument& error) {
        return error.field();
    }
    return {};
}

}  // namespace

TEST_CASE("model hertz presses cylinders as boundary elements do", "[simplified][line]") {
    const MaterialPair pair = GENERATE(bodies, MaterialPair{{82000, 0.28}, Material::rigid()});
    const ContactSolution simplified = solve_half_spaces(pressed(Model::hertz, pair));
    const ContactSolution full = solve_half_spaces(pressed(Model::full, pair));
    CHECK(simplified.forces.Fn == P * length);
    CHECK_THAT(simplified.pmax, WithinRel(full.pmax, 1e-4));
    CHECK_THAT(simplified.approach, WithinRel(full.approach, 1e-4));
    CHECK_THAT(simplified.area.contact, WithinRel(full.area.contact, 0.005));
    CHECK(simplified.elements.border == 0);
    ContactProblem by_approach = pressed(Model::hertz, pair);
    by_approach.Fn.reset();
    by_approach.approach = simplified.approach;
    CHECK_THAT(solve_half_spaces(by_approach).forces.Fn, WithinRel(P * length, 1e-12));
}

TEST_CASE("model hertz rolls cylinders as Carter does, and sideways the same", "[simplified][line]") {
    const double chi = GENERATE(0.0, 3.141592653589793), share = GENERATE(0.1, 0.5, 0.9, 1.4);
    const bool along = GENERATE(true, false);
    Rolling rolling{.chi = chi, .velocity = 5};
    const double full_slip = mu * cylinder.pmax * 2 / 82000 * (along ? 0.72 : 1);
    (along ? rolling.xi : rolling.eta) = share * full_slip;
    const auto [simplified, full] = both(rolling);
    check_forces(simplified, full);
    const double part = std::max(0.0, 1 - share);
    CHECK_THAT(along ? simplified.forces.Fx : simplified.forces.Fy,
               WithinRel(-mu * P * length * (1 - part * part), 1e-12));
    CHECK_THAT(*simplified.frictional_power, WithinRel(*full.frictional_power, 0.02));  // for elements with little slip
    std::size_t compared = 0;
    for (std::size_t e = 0; e < simplified.pressure.size(); ++e)
        if (full.element_division[e] == simplified.element_division[e] && ++compared)
            CHECK_THAT(simplified.traction_x[e], WithinAbs(full.traction_x[e], 0.02 * mu * cylinder.pmax));
    CHECK(compared > 780);
}

TEST_CASE("model hertz finds the creepage of a line contact's force", "[simplified][line]") {
    const double share = GENERATE(-0.9, 0.3);
    Rolling rolling;
    rolling.force = {share * mu * P * length, {}};
    const ContactSolution simplified = solve_half_spaces(moved(Model::hertz, rolling));
    CHECK_THAT(simplified.forces.Fx, WithinRel(share * mu * P * length, 1e-8));
    const auto carter = reference::carter_of_force(bodies, cylinder, mu, share * mu * P);
    CHECK_THAT(std::get<Rolling>(*simplified.motion).xi, WithinRel(carter.creepage, 1e-8));
}

TEST_CASE("model hertz shifts cylinders as boundary elements do", "[simplified][line]") {
    const double share = GENERATE(0.05, 0.6, 0.98, 1.3), angle = GENERATE(0.0, 1.5707963267948966, 3.0);
    const double full_shift =
        2 * mu * P / (3.141592653589793 * 82000) * (std::log(2 * datum / cylinder.half_width) + 0.5);
    const auto [simplified, full] =
        both(Shift{{0.72 * share * full_shift * std::cos(angle), share * full_shift * std::sin(angle)}});
    if (angle != 3.0) return check_forces(simplified, full);
    const double bound = mu * P * length;  // only the theory assumes parallel oblique tractions
    CHECK_THAT(simplified.forces.Fx, WithinAbs(full.forces.Fx, 0.02 * bound));
    CHECK_THAT(simplified.forces.Fy, WithinAbs(full.forces.Fy, 0.02 * bound));
}

TEST_CASE("model hertz finds the shift of a line contact's force", "[simplified][line]") {
    Shift shift;
    shift.force = {-0.7 * mu * P * length, -0.2 * mu * P * length};
    const auto [simplified, full] = both(shift);
    const auto w = std::get<Shift>(*simplified.motion).rigid_shift, exact = std::get<Shift>(*full.motion).rigid_shift;
    CHECK_THAT(simplified.forces.Fx, WithinRel(*shift.force.Fx, 1e-8));
    CHECK_THAT(w.x, WithinRel(exact.x, 0.01));
    CHECK_THAT(w.y, WithinRel(exact.y, 0.01));
}

TEST_CASE("derivatives of model hertz on line contacts are central differences", "[simplified][line][derivatives]") {
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        Dice dice(seed + 7'000'000);
        ContactProblem problem = pressed(Model::hertz);
        problem.grid = Grid::of_elements(60, 1, 2.2 * cylinder.half_width / 60, length);
        problem.Fn = *problem.Fn * dice.log_uniform(0.1, 1);
        const ContactSolution normal = solve_half_spaces(problem);
        if (dice.chance(0.5)) problem.approach = normal.approach, problem.Fn.reset();
        problem.derivatives = true;
        problem.friction = FrictionLaw{{dice.uniform(0.05, 0.6)}};
        const double p0 = normal.pmax, size = problem.friction->mu[0] * p0 * 2 / 82000 * dice.log_uniform(0.05, 2);
        const double angle = dice.uniform(0, 6.3);
        if (dice.chance(0.5))
            problem.motion = Rolling{.xi = size * std::cos(angle), .eta = size * std::sin(angle)};
        else
            problem.motion = Shift{{3 * size * std::cos(angle), 3 * size * std::sin(angle)}};
        const ContactSolution solution = solve_half_spaces(problem);
        REQUIRE(solution.derivatives);
        CHECK((!solution.derivatives->Fx->phi && !solution.derivatives->Fx->rotation));
        const DerivativeCheck check = check_derivatives(problem, solution);
        CAPTURE(check.worst, check.error);
        CHECK(check.error <= 1e-4);
        compared += check.compared;
    }
    CHECK(compared > 200);
}

TEST_CASE("what a line contact's closed form does not know is refused by name", "[simplified][line]") {
    ContactProblem fastsim = moved(Model::fastsim, Rolling{.xi = 1e-4});
    CHECK(field_refused(fastsim) == "model");
    ContactProblem spins = moved(Model::hertz, Rolling{.phi = 1e-4});
    CHECK(field_refused(spins) == "friction.rolling.phi");
    ContactProblem rotates = moved(Model::hertz, Shift{{}, 1e-4});
    CHECK(field_refused(rotates) == "friction.rotation");
    ContactProblem broad = pressed(Model::hertz);
    broad.grid = Grid::of_elements(8, 3, 1, 1);
    CHECK(field_refused(broad) == "grid.ny");
    ContactProblem ellipse = pressed(Model::hertz);
    ellipse.gap = Paraboloid{radius, radius};
    CHECK(field_refused(ellipse) == "gap.paraboloid.Ry");
    ContactProblem flat = pressed(Model::hertz);
    flat.gap = Paraboloid{-radius, std::numeric_limits<double>::infinity()};
    CHECK(field_refused(flat) == "gap.paraboloid.Rx");
    ContactProblem heavy = pressed(Model::hertz);
    heavy.Fn = 1e15;
    CHECK(field_refused(heavy) == "ics.line_contact.datum");
    heavy.Fn.reset();
    heavy.approach = 1e6;
    CHECK(field_refused(heavy) == "ics.line_contact.datum");
    ContactProblem apart = pressed(Model::hertz);
    apart.Fn.reset();
    apart.approach = -1;
    CHECK(solve_half_spaces(apart).forces.Fn == 0);
}

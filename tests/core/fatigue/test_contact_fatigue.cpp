// Tests fatigue of contacts against known values: line, circle and ellipse under Hertz's pressure, in full slip and
// solved.
#include <cmath>
#include <numbers>
#include <string>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "contact/contact_cases.hpp"
#include "contactd/error.hpp"
#include "fatigue/contact_fatigue.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double p0 = 1000;  // N/mm^2

FatigueStrength strength_of(double a_DV) {
    return {.name = "steel", .source = "a test", .shear_yield = 300, .a_DV = a_DV, .tau_e = {}};
}

FatigueRequest request_of(double a_DV) {
    return {.body = WornBody::lower, .strength = strength_of(a_DV), .damages = {}, .passage = Passage{}};
}

/// Creates Hertz's contact of half-axes a and b (infinite for a line) in full slip against +x.
ContactFatigue hertz_fatigue(double a, double b, double mu, FatigueRequest request) {
    constexpr int n = 60;
    const bool is_line = std::isinf(b);
    ContactProblem problem;
    problem.grid = is_line ? Grid::of_elements(n, 1, 2 * a / n, 1) : Grid::of_elements(n, n, 2 * a / n, 2 * b / n);
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    if (is_line) {
        Ics ics;
        ics.line_contact = LineContactSpec{1};
        problem.bodies.upper.ics = problem.bodies.lower.ics = ics;
    }
    problem.fatigue = std::move(request);
    Rolling rolling;
    rolling.xi = 1e-3;
    ContactSolution solution;
    solution.motion = rolling;
    for (int iy = 0; iy < problem.grid.ny; ++iy)
        for (int ix = 0; ix < n; ++ix) {
            const double x = problem.grid.x(ix) / a, y = is_line ? 0 : problem.grid.y(iy) / b;
            const double p = p0 * std::sqrt(std::max(1 - x * x - y * y, 0.0));
            solution.pressure.push_back(p);
            solution.traction_x.push_back(0 - mu * p);
            solution.traction_y.push_back(0);
            solution.forces.Fn += p * problem.grid.element_area();
            solution.forces.Fx -= mu * p * problem.grid.element_area();
            solution.area.contact += p > 0 ? problem.grid.element_area() : 0;
        }
    solution.pmax = p0;
    Observer observer;
    return contact_fatigue(problem, fatigue_place(problem, rolling), solution, observer);
}

constexpr double infinite = std::numeric_limits<double>::infinity();

ContactProblem rolling_problem() {
    ContactProblem problem;
    problem.grid = Grid::of_elements(40, 40, 0.2, 0.2);
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    problem.gap = SemiAxes{3, 3};
    problem.Fn = 20000;
    problem.friction = FrictionLaw{{0.3}};
    Rolling rolling;
    rolling.xi = 0.02;
    rolling.velocity = 1e4;
    problem.motion = rolling;
    problem.fatigue = FatigueRequest{};
    return problem;
}

}  // namespace

TEST_CASE("Shakedown of a line contact ends where the shear of full slip says") {
    struct Known {
        double mu, shear, depth;
    };
    const auto [mu, shear, depth] = GENERATE(Known{0, .2500, .50}, Known{.1, .2805, -1}, Known{.2, .3122, -1},
                                             Known{.3, .3449, -1}, Known{.4, .4, 0}, Known{.5, .5, 0});
    const ContactFatigue fatigue = hertz_fatigue(5, infinite, mu, request_of(0));
    CAPTURE(mu);
    CHECK_THAT(fatigue.shear->value / p0, WithinAbs(shear, 1e-3));
    CHECK_THAT(*fatigue.limit, WithinRel(1 / shear, 4e-3));
    if (depth >= 0) CHECK_THAT(fatigue.shear->depth / 5, WithinAbs(depth, 0.02));
}

TEST_CASE("Shear and Dang Van's stress of frictionless rolling are those known of line, circle and ellipse") {
    struct Known {
        double b, a_DV, shear, dang_van, depth;
    };
    const auto [b, a_DV, shear, dang_van, depth] =
        GENERATE(Known{infinite, 0, .2500, .2500, .50}, Known{infinite, 1 / 3.0, .2500, .1648, .61},
                 Known{5, 0, .2137, .2141, -1}, Known{5, 1 / 3.0, .2137, .1602, .55}, Known{50, 0, .2499, .2499, -1},
                 Known{50, 1 / 3.0, .2499, .1658, .607});
    const ContactFatigue fatigue = hertz_fatigue(5, b, 0, request_of(a_DV));
    CAPTURE(b, a_DV);
    CHECK_THAT(fatigue.shear->value / p0, WithinAbs(shear, 1e-3));
    CHECK_THAT(fatigue.dang_van->value / p0, WithinAbs(dang_van, 1e-3));
    if (depth >= 0) CHECK_THAT(fatigue.dang_van->depth / 5, WithinAbs(depth, 0.04));
}

TEST_CASE("First yield of a circle and of a slender ellipse is where von Mises says") {
    CHECK_THAT(hertz_fatigue(5, 5, 0, request_of(0)).von_mises->value / p0, WithinAbs(.6292, 1e-3));
    CHECK_THAT(hertz_fatigue(5, 50, 0, request_of(0)).von_mises->value / p0, WithinAbs(.5797, 1e-3));
}

TEST_CASE("A circle in full slip ends shakedown on its surface from 0.3 on") {
    CHECK_THAT(*hertz_fatigue(5, 5, 0.3, request_of(0)).limit, WithinRel(1 / 0.3, 6e-3));
    const ContactFatigue fatigue = hertz_fatigue(5, 5, 0.32, request_of(0));
    CHECK_THAT(*fatigue.limit, WithinRel(1 / 0.32, 1e-3));
    CHECK(fatigue.shear->depth == 0);
}

TEST_CASE("Surface and subsurface indices are those of Hertz's contact") {
    const ContactFatigue fatigue = hertz_fatigue(5, 5, 0.3, request_of(0));
    CHECK_THAT(fatigue.traction_coefficient, WithinRel(0.3, 1e-12));
    CHECK_THAT(*fatigue.FI_surf, WithinAbs(0.3 - 300 / p0, 2e-3));
    CHECK_THAT(fatigue.FI_sub, WithinRel(p0 / 6 * (1 + 0.09), 1e-2));
    CHECK_THAT(*fatigue.load, WithinRel(p0 / 300, 1e-12));
}

TEST_CASE("Residual compression takes its share of the hydrostatic stress off, and shear knows nothing of it") {
    FatigueRequest request = request_of(1 / 3.0);
    const ContactFatigue without = hertz_fatigue(5, 5, 0.1, request);
    request.passage->residual = {{0, -300, -150}};
    const ContactFatigue with = hertz_fatigue(5, 5, 0.1, request);
    CHECK_THAT(with.dang_van->value, WithinAbs(without.dang_van->value - 50, 1e-9));
    CHECK_THAT(with.FI_sub, WithinAbs(without.FI_sub - 50, 1e-9));
    CHECK(with.shear == without.shear);
}

TEST_CASE("Residual stresses lie on straight lines between their depths") {
    const std::vector<ResidualStress> table{{1, -100, -50}, {3, 100, 50}};
    CHECK(residual_at(table, 0).xx == -100);
    CHECK(residual_at(table, 2.5).xx == 50);
    CHECK(residual_at(table, 2.5).yy == 25);
    CHECK(residual_at(table, 9).yy == 50);
    CHECK(residual_at({}, 2).xx == 0);
}

TEST_CASE("The force on a body tells whether the other one drives it") {
    ContactProblem problem = rolling_problem();
    const auto fatigue = [&](WornBody body, double chi) {
        problem.fatigue->body = body;
        std::get<Rolling>(problem.motion).chi = chi;
        return *solve_half_spaces(problem).fatigue;
    };
    const ContactFatigue upper = fatigue(WornBody::upper, 0), lower = fatigue(WornBody::lower, 0);
    CHECK(upper.driven);  // the upper body slips along +x, with the traction against it
    CHECK(!lower.driven);
    CHECK_THAT(std::abs(upper.force_angle), WithinAbs(std::numbers::pi, 1e-6));
    CHECK_THAT(lower.force_angle, WithinAbs(0, 1e-6));
    CHECK(!fatigue(WornBody::upper, std::numbers::pi).driven);
    CHECK_THAT(upper.rows[upper.rows.size() / 2].force_x, WithinRel(-lower.rows[lower.rows.size() / 2].force_x, 1e-9));
}

TEST_CASE("Bodies of one steel in full slip have nearly one shear, each in its own frame") {
    ContactProblem problem = rolling_problem();
    problem.fatigue->passage = Passage{};
    const ContactFatigue upper = *solve_half_spaces(problem).fatigue;
    problem.fatigue->body = WornBody::lower;
    const ContactFatigue lower = *solve_half_spaces(problem).fatigue;
    CHECK_THAT(upper.shear->value, WithinRel(lower.shear->value, 5e-3));
    CHECK_THAT(upper.von_mises->value, WithinRel(lower.von_mises->value, 5e-3));
}

TEST_CASE("Damage follows its pieces, and a contact beyond their range has a warning") {
    ContactProblem problem = rolling_problem();
    problem.fatigue->damages = {{"ours", "a test", {0, 10}, {{0, 0, 0}, {15, 0, 2e-7}}}};
    const ContactSolution solution = solve_half_spaces(problem);
    CHECK_THAT(solution.fatigue->T_gamma, WithinRel(0.02 * 0.3 * 20000, 1e-3));
    CHECK_THAT(solution.fatigue->damages.at(0).value, WithinRel((solution.fatigue->T_gamma - 15) * 2e-7, 1e-12));
    REQUIRE_FALSE(solution.warnings.empty());
    CHECK_THAT(solution.warnings.front(), ContainsSubstring("damage function ours was fitted from 0 to 10 N"));
}

TEST_CASE("Requests of fatigue that make no sense are refused by name") {
    ContactProblem problem = rolling_problem();
    const auto refused = [&](const std::string& sentence) {
        CHECK_THROWS_MATCHES(validate(problem), InvalidArgument, MessageMatches(ContainsSubstring(sentence)));
    };
    problem.fatigue->damages = {{"ours", "", {0, 10}, {{0, 0, 0}}}};
    refused("fatigue.damages[0].source");
    problem.fatigue->damages = {{"ours", "a test", {0, 10}, {{1, 0, 0}}}};
    refused("fatigue.damages[0].pieces[0].from");
    problem.fatigue->damages = {{"ours", "a test", {0, 10}, {{0, 0, 0}}}, {"ours", "a test", {0, 10}, {{0, 0, 0}}}};
    refused("fatigue.damages[1].name");
    problem.fatigue->damages = {};
    problem.fatigue->passage = Passage{{1, 1}, {}};
    refused("fatigue.passage.depths[1]");
    problem.fatigue->passage = Passage{{}, {{1, 0, 0}, {0, 0, 0}}};
    refused("fatigue.passage.residual[1].depth");
    problem.fatigue->passage = Passage{};
    problem.bodies.upper = Body{Material::rigid()};
    refused("fatigue.body");
    problem = rolling_problem();
    problem.model = Model::hertz;
    refused("model");
    problem = rolling_problem();
    problem.motion = Shift{};
    refused("fatigue");
    problem = rolling_problem();
    problem.fatigue->strength = FatigueStrength{"rail", "a test", 300, {}, 200};
    refused("fatigue.strength.tau_e");
}

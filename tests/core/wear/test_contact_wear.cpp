// Tests wear of contacts against closed forms: gross sliding, rows of an ellipse, Carter's line contact.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contact/contact_cases.hpp"
#include "contactd/error.hpp"
#include "wear/wear_laws.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Creates two half-spaces of steel in an ellipse of 6 x 4 mm under 80 kN, on elements dx x 2/3 dx.
ContactProblem ellipse_problem(double dx, const Rolling& rolling) {
    ContactProblem problem;
    const double dy = dx * 2 / 3;
    const auto count = [](double length, double size) { return 2 * static_cast<int>(std::ceil(length / size / 2)); };
    problem.grid = Grid::of_elements(count(12.8, dx), count(8.6, dy), dx, dy);
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    problem.gap = SemiAxes{6, 4};
    problem.Fn = 80000;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = rolling;
    problem.wear = WearRequest{};
    return problem;
}

Rolling rolling_of(double xi, double eta = 0, double phi = 0) {
    Rolling rolling;
    rolling.xi = xi;
    rolling.eta = eta;
    rolling.phi = phi;
    rolling.velocity = 2e4;
    return rolling;
}

/// Creates a cylinder of radius 300 mm on a plane under 800 N/mm, n elements in 2.4 half-widths, at half the creepage
/// of full slip.
ContactProblem carter_problem(int n, double half_width, double xi) {
    constexpr double length = 10;
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, 1, 2.4 * half_width / n, length);
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    Ics ics;
    ics.line_contact = LineContactSpec{length};
    problem.bodies.upper.ics = problem.bodies.lower.ics = ics;
    problem.gap = Paraboloid{300, Paraboloid{}.Ry};
    problem.Fn = 800 * length;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = rolling_of(xi);
    problem.wear = WearRequest{};
    return problem;
}

double area_of(const ContactWear& wear, const std::string& law) {
    const auto found = std::ranges::find(wear.laws, law, &LawWear::name);
    REQUIRE(found != wear.laws.end());
    return found->area;
}

}  // namespace

TEST_CASE("An ellipse that slides as a whole wears by the work of its friction") {
    constexpr double k = 3e-4, hardness = 3000, xi = 0.02, Fn = 80000;
    ContactProblem problem = ellipse_problem(0.4, rolling_of(xi));
    problem.wear->laws = {archard_law(k, hardness), energy_law(6.75e-4)};
    const ContactWear wear = *solve_half_spaces(problem).wear;
    CHECK_THAT(wear.T_gamma, WithinRel(479.97, 1e-4));
    CHECK_THAT(wear.T_gamma_with_spin, WithinRel(wear.T_gamma, 1e-12));
    CHECK_THAT(area_of(wear, "archard"), WithinRel(k / hardness * xi * Fn, 2e-4));
    CHECK_THAT(area_of(wear, "energy"), WithinRel(6.75e-4 / 1000 * 480, 2e-4));
}

TEST_CASE("Scaled slip dissipates T gamma, plain slip what the elements have") {
    const auto [dx, sum] = GENERATE(table<double, double>({{0.4, 474.83}, {0.2, 477.37}}));
    ContactProblem problem = ellipse_problem(dx, rolling_of(0.02));
    const auto of_rows = [&] {
        const ContactWear wear = *solve_half_spaces(problem).wear;
        double total = 0;
        for (const WearRow& row : wear.rows) total += row.dissipation * problem.grid.dy;
        return std::pair(wear, total);
    };
    const auto [scaled, of_scaled] = of_rows();
    problem.wear->energy = WearEnergy::plain;
    const auto [plain, of_plain] = of_rows();
    CHECK_THAT(of_scaled, WithinRel(scaled.T_gamma_with_spin, 1e-12));
    CHECK_THAT(of_plain, WithinRel(plain.dissipation, 1e-12));
    CHECK_THAT(plain.dissipation, WithinAbs(sum, 0.03));
    CHECK(plain.factor == 1);
    CHECK_THAT(scaled.factor * scaled.dissipation, WithinRel(scaled.T_gamma_with_spin, 1e-12));
}

TEST_CASE("Rows of an ellipse in gross sliding wear as the square of their length") {
    constexpr double k = 3e-4, hardness = 3000, xi = 0.1, a = 6, b = 4;
    ContactProblem problem = ellipse_problem(0.2, rolling_of(xi));
    problem.wear->laws = {archard_law(k, hardness)};
    const ContactSolution solution = solve_half_spaces(problem);
    const double p0 = 1.5 * 80000 / (std::numbers::pi * a * b);
    REQUIRE(solution.wear->rows.size() > 50);
    for (const WearRow& row : solution.wear->rows) {
        const double share = 1 - row.y * row.y / (b * b);
        if (share < 0.1) continue;
        CAPTURE(row.y);
        CHECK_THAT(row.depths[0], WithinRel(k / hardness * xi * p0 * a * std::numbers::pi / 2 * share, 6e-3));
        CHECK(row.z == 0);
        CHECK(row.angle == 0);
    }
}

TEST_CASE("A line contact at half the creepage of full slip dissipates as Carter's") {
    constexpr double load = 800, radius = 300, mu = 0.3, length = 10;
    const double modulus = 82000 * 2 * 1.28 / (2 * (1 - 0.28 * 0.28));
    const double half_width = std::sqrt(4 * load * radius / (std::numbers::pi * modulus));
    const double full = mu * half_width / radius, xi = full / 2;
    const double exact = mu * load * xi * (1 - (1 - xi / full) * (1 - xi / full));
    CHECK_THAT(half_width, WithinAbs(1.6380, 5e-5));
    CHECK_THAT(exact, WithinAbs(0.147422, 5e-7));
    const auto [n, sum] = GENERATE(table<int, double>({{50, 0.14240}, {100, 0.14520}, {200, 0.14568}, {800, 0.14699}}));
    ContactProblem problem = carter_problem(n, half_width, xi);
    problem.wear->energy = WearEnergy::plain;
    problem.wear->laws = {archard_law(3e-4, 3000)};
    const ContactWear wear = *solve_half_spaces(problem).wear;
    CHECK_THAT(wear.dissipation / length, WithinAbs(sum, 2e-5));
    CHECK_THAT(wear.T_gamma / length, WithinRel(exact, 0.9 / n));
    CHECK_THAT(area_of(wear, "archard") / length, WithinRel(3e-4 / (mu * 3000) * wear.dissipation / length, 1e-4));
}

TEST_CASE("A law that is linear in the energy wears off the same volume for all elements of a patch as for each") {
    ContactProblem problem = ellipse_problem(0.4, rolling_of(0.0008, 0.0003, 0));
    problem.wear->laws = {energy_law(6.75e-4), usfd_mild_law(), br_mild_law(), zobory_mild_law()};
    const ContactWear wear = *solve_half_spaces(problem).wear;
    CHECK_THAT(area_of(wear, "energy"), WithinRel(6.75e-4 / 1000 * wear.T_gamma_with_spin, 1e-12));
    // Wear of 1 ug/(m mm^2) over 1 mm of path removes 1.274e-7 mm of steel.
    CHECK_THAT(area_of(wear, "usfd"), WithinRel(5.3 * 1.2739e-7 * wear.T_gamma_with_spin, 1e-4));
    // Wear of .25 mm^2/km per newton of a wheel of 1 mm removes pi/4 1e-6 mm^2 per revolution.
    CHECK_THAT(area_of(wear, "br"), WithinRel(0.25 * std::numbers::pi * 1e-6 * wear.T_gamma, 1e-12));
    CHECK_THAT(area_of(wear, "zobory"), WithinRel(7e-10 * 1e-3 / 7.85e-6 * wear.T_gamma_with_spin, 1e-12));
    for (const WearRow& row : wear.rows)
        CHECK_THAT(row.depths[2] * wear.T_gamma_with_spin, WithinRel(area_of(wear, "br") * row.dissipation, 1e-9));
}

TEST_CASE("Without slip nothing wears") {
    ContactProblem problem = ellipse_problem(0.4, rolling_of(0));
    problem.wear->laws = {archard_law(3e-4, 3000), energy_law(6.75e-4), usfd_mild_law(), br_mild_law(),
                          zobory_mild_law()};
    const ContactWear wear = *solve_half_spaces(problem).wear;
    CHECK(wear.T_gamma == 0);
    CHECK(wear.dissipation == 0);
    CHECK(wear.factor == 1);
    CHECK_FALSE(wear.rows.empty());
    for (const LawWear& law : wear.laws) CHECK(law.area == 0);
}

TEST_CASE("Spin dissipates beside creepages, and T gamma without spin has nothing of it") {
    const ContactProblem problem = ellipse_problem(0.3, rolling_of(0.0004, 0, 0.0008));
    const ContactSolution solution = solve_half_spaces(problem);
    const Forces& forces = solution.forces;
    CHECK_THAT(solution.wear->T_gamma, WithinRel(std::abs(forces.Fx * 0.0004), 1e-12));
    CHECK_THAT(solution.wear->T_gamma_with_spin, WithinRel(-(forces.Fx * 0.0004 + forces.Mz * 0.0008), 1e-12));
    CHECK(solution.wear->T_gamma_with_spin > 1.05 * solution.wear->T_gamma);
    CHECK_THAT(solution.wear->dissipation, WithinRel(*solution.frictional_power / 2e4, 1e-6));
}

TEST_CASE("Creepages that a force found are those of T gamma") {
    ContactProblem problem = ellipse_problem(0.4, rolling_of(0));
    std::get<Rolling>(problem.motion).force.Fx = -12000;
    const ContactSolution solution = solve_half_spaces(problem);
    const double xi = std::get<Rolling>(*solution.motion).xi;
    REQUIRE(std::abs(xi) > 1e-4);
    CHECK_THAT(solution.wear->T_gamma, WithinRel(12000 * std::abs(xi), 1e-4));
}

TEST_CASE("FASTSIM wears as its elements slip") {
    ContactProblem problem = ellipse_problem(0.4, rolling_of(0.02));
    problem.model = Model::fastsim;
    problem.wear->laws = {energy_law(6.75e-4)};
    Observer observer;
    const ContactSolution solution = solve_contact(problem, {}, observer);
    CHECK_THAT(solution.wear->T_gamma, WithinRel(480, 1e-2));
    CHECK_THAT(area_of(*solution.wear, "energy"), WithinRel(6.75e-7 * solution.wear->T_gamma_with_spin, 1e-9));
}

TEST_CASE("A map of k is mild, severe and seized by sliding velocity and pressure") {
    ContactProblem problem = ellipse_problem(0.4, rolling_of(0.02));  // slides at about 400 mm/s, 1592 N/mm^2 at most
    problem.wear->energy = WearEnergy::plain;
    const auto area = [&](const WearLaw& law) {
        problem.wear->laws = {law};
        return solve_half_spaces(problem).wear->laws[0].area;
    };
    const double mild = area(archard_law(1e-4, 3000));
    WearLaw law = archard_law(1e-4, 3000);
    law.archard->severe = SevereWear{40e-4, {200, 700}};
    CHECK_THAT(area(law), WithinRel(40 * mild, 1e-2));
    law.archard->severe->velocity = {700, 900};
    CHECK_THAT(area(law), WithinRel(mild, 1e-12));
    law.archard->severe.reset();
    law.archard->seizure = SeizureWear{300e-4, 0.5};  // above 1500 N/mm^2 on 1 - (15/15.92)^2 of the area
    const double part = std::pow(1500 / (1.5 * 80000 / (std::numbers::pi * 24)), 3);
    CHECK_THAT(area(law), WithinRel(mild * (part + 300 * (1 - part)), 0.05));
}

TEST_CASE("Zones weigh rows by their angle, with straight lines between") {
    const std::vector<WearZone> zones{{-1, 0.1}, {-0.5, 1}, {0.5, 2}};
    CHECK(factor_at({}, 0.3) == 1);
    CHECK(factor_at(zones, -2) == 0.1);
    CHECK_THAT(factor_at(zones, -0.75), WithinRel(0.55, 1e-12));
    CHECK_THAT(factor_at(zones, 0), WithinRel(1.5, 1e-12));
    CHECK(factor_at(zones, 3) == 2);
}

TEST_CASE("Pieces of a function hold from their beginning on") {
    const std::vector<WearPiece> pieces = usfd_law().usfd->pieces;
    CHECK_THAT(value_at(pieces, 10), WithinRel(53.0, 1e-12));
    CHECK(value_at(pieces, 10.4) == 55);
    CHECK(value_at(pieces, 77) == 55);
    CHECK_THAT(value_at(pieces, 87.2), WithinRel(674.0, 1e-12));
}

TEST_CASE("A law beyond its range is told, and none within") {
    ContactProblem problem = ellipse_problem(0.4, rolling_of(0.02));
    const auto warned = [&](WearRange range) {
        problem.wear->laws = {energy_law(6.75e-4)};
        problem.wear->laws[0].range = range;
        const auto warnings = solve_half_spaces(problem).warnings;
        return std::ranges::any_of(warnings,
                                   [](const std::string& text) { return text.starts_with("The wear law energy"); });
    };
    CHECK_FALSE(warned({0, 100}));
    CHECK(warned({0, 5}));
    CHECK(warned({50, 100}));
}

TEST_CASE("Elements that are too large for single rows are told of, with the cure, and none that are small") {
    // Near adhesion a thin edge slips, which large elements do not resolve.
    const auto sentence = [](double dx) {
        for (const std::string& text : solve_half_spaces(ellipse_problem(dx, rolling_of(5e-4))).warnings)
            if (text.starts_with("The energy of the slip is ")) return text;
        return std::string();
    };
    CHECK(
        sentence(1.2).ends_with("N summed over the elements. The elements are too large for the depths of single rows; "
                                "use smaller ones."));
    CHECK(sentence(0.2).empty());
}

TEST_CASE("Laws without a source, a kind or a range are refused") {
    const auto refused = [](const WearLaw& law) -> std::string {
        ContactProblem problem = ellipse_problem(0.4, rolling_of(0.01));
        problem.wear->laws = {law};
        try {
            validate(problem);
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return "";
    };
    WearLaw law = usfd_law();
    CHECK(refused(law).empty());
    law.source.clear();
    CHECK(refused(law) == "wear.laws[0].source");
    law = usfd_law();
    law.energy = EnergyWear{1};
    CHECK(refused(law) == "wear.laws[0]");
    law.energy.reset();
    law.usfd.reset();
    CHECK(refused(law) == "wear.laws[0]");
    law = usfd_law();
    law.range = {2, 2};
    CHECK(refused(law) == "wear.laws[0].range");
    law = usfd_law();
    law.usfd->pieces[0].from = 1;
    CHECK(refused(law) == "wear.laws[0].usfd.pieces[0].from");
    law = usfd_law();
    law.usfd->pieces[1].slope = -1;
    CHECK(refused(law) == "wear.laws[0].usfd.pieces[1].slope");
    law = usfd_law();
    law.usfd->density = 0;
    CHECK(refused(law) == "wear.laws[0].usfd.density");
}

TEST_CASE("Wear is that of steady rolling along x with friction") {
    const auto refused = [](const auto& change) -> std::string {
        ContactProblem problem = ellipse_problem(0.4, rolling_of(0.01));
        change(problem);
        try {
            validate(problem);
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return "";
    };
    CHECK(refused([](ContactProblem& problem) { problem.friction.reset(); }) == "wear");
    CHECK(refused([](ContactProblem& problem) { problem.motion = Shift{}; }) == "wear");
    CHECK(refused([](ContactProblem& problem) { std::get<Rolling>(problem.motion).kind = RollingKind::transient; }) ==
          "friction.rolling.kind");
    CHECK(refused([](ContactProblem& problem) { std::get<Rolling>(problem.motion).chi = 1; }) ==
          "friction.rolling.chi");
    CHECK(refused([](ContactProblem& problem) { problem.model = Model::polach; }) == "model");
    CHECK(refused([](ContactProblem& problem) {
              std::get<Rolling>(problem.motion).velocity = 1;
              problem.wear->laws = {archard_law(1e-4, 3000)};
          }) == "friction.rolling.velocity");
}

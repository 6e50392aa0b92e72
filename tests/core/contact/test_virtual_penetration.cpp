#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>

#include "closed_forms/hertz.hpp"
#include "contact_cases.hpp"
#include "contactd/solve_contact.hpp"
#include "support/closed_forms.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr Material steel{82000, 0.28};

ContactProblem pressed(NormalModel normal, int nx, int ny, double dx, double dy) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(nx, ny, dx, dy);
    problem.bodies = Bodies::of({steel, steel});
    problem.model = Model::fastsim;
    problem.normal_model = normal;
    return problem;
}

template <class Height>
std::vector<double> heights(const Grid& grid, Height height) {
    std::vector<double> h;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) h.push_back(height(grid.x(ix), grid.y(iy)));
    return h;
}

ContactProblem given_case(NormalModel normal) {
    ContactProblem problem = pressed(normal, 41, 61, 0.3, 0.3);
    problem.gap =
        heights(problem.grid, [](double x, double y) { return 0.001 * x * x + 2e-4 * y * y + 6e-6 * y * y * y * y; });
    problem.approach = 0.03;
    return problem;
}

ContactSolution solved(const ContactProblem& problem) {
    Observer observer;
    return solve_contact(problem, {}, observer);
}

}  // namespace

TEST_CASE("Models of virtual penetration have given forces and patches", "[penetration]") {
    const auto [normal, Fn, pmax, elements] = GENERATE(std::tuple(NormalModel::kpec, 23434.7088, 438.756764, 839),
                                                       std::tuple(NormalModel::analyn, 23558.0144, 451.178133, 801),
                                                       std::tuple(NormalModel::kp, 24266.9697, 416.049994, 931));
    const ContactSolution solution = solved(given_case(normal));
    CHECK_THAT(solution.forces.Fn, WithinRel(Fn, 1e-8));
    CHECK_THAT(solution.pmax, WithinRel(pmax, 1e-8));
    CHECK(solution.elements.contact == elements);
    CHECK(solution.warnings.empty());
}

TEST_CASE("A force that is prescribed has the approach that brings it", "[penetration]") {
    const NormalModel normal = GENERATE(NormalModel::kp, NormalModel::kpec, NormalModel::analyn);
    ContactProblem problem = given_case(normal);
    problem.Fn = solved(problem).forces.Fn;
    problem.approach.reset();
    const ContactSolution found = solved(problem);
    CHECK(found.converged());
    CHECK_THAT(found.approach, WithinRel(0.03, 1e-6));
    CHECK_THAT(found.forces.Fn, WithinRel(*problem.Fn, 1e-8));
}

TEST_CASE("Every force has an approach, also where other rows and elements make it jump", "[penetration]") {
    const NormalModel normal = GENERATE(NormalModel::kp, NormalModel::kpec, NormalModel::analyn);
    ContactProblem problem = pressed(normal, 15, 13, 1, 1);
    problem.gap = heights(problem.grid, [](double x, double y) {
        return 0.002 * x * x + (y < 0.7 ? 0.0004 : 0.002) * (y - 0.7) * (y - 0.7) + (y > 2 ? 0.004 * (y - 2) : 0);
    });
    for (double Fn = 100; Fn < 60000; Fn *= 1.02) {
        problem.Fn = Fn;
        problem.approach.reset();
        const ContactSolution found = solved(problem);
        CAPTURE(static_cast<int>(normal), Fn);
        CHECK(found.converged());
        CHECK_THAT(found.forces.Fn, WithinRel(Fn, 1e-8));
        double sum = 0, least = 0;
        for (const double p : found.pressure) {
            sum += p;
            least = std::min(least, p);
        }
        CHECK_THAT(sum, WithinRel(Fn, 1e-8));
        CHECK(least == 0);
    }
}

TEST_CASE("KPEC and ANALYN give Hertz's contact of paraboloids", "[penetration]") {
    const NormalModel normal = GENERATE(NormalModel::kpec, NormalModel::analyn);
    const double Ry = GENERATE(250.0, 500.0, 1000.0);
    ContactProblem problem = pressed(normal, 81, 81, 0.25, 0.25);
    const Paraboloid gap{500, Ry};
    problem.gap = gap;
    problem.approach = 0.05;
    const auto hertz = hertz_of_approach(gap, problem.bodies.materials().normal_compliance(), 0.05);
    const ContactSolution solution = solved(problem);
    CHECK_THAT(solution.forces.Fn, WithinRel(hertz.Fn, 3e-3));
    CHECK_THAT(solution.pmax, WithinRel(hertz.pmax, 3e-3));
}

TEST_CASE("KP is as near to Hertz as it is known to be", "[penetration]") {
    ContactProblem problem = pressed(NormalModel::kp, 81, 81, 0.25, 0.25);
    const Paraboloid gap{500, 300};
    problem.gap = gap;
    problem.approach = 0.05;
    const auto hertz = hertz_of_approach(gap, problem.bodies.materials().normal_compliance(), 0.05);
    const ContactSolution solution = solved(problem);
    CHECK_THAT(solution.forces.Fn, WithinRel(hertz.Fn, 0.05));
    CHECK_THAT(solution.pmax, WithinRel(hertz.pmax, 0.1));
    CHECK(solution.pmax < hertz.pmax);
}

TEST_CASE("Bodies that do not overlap have no pressures", "[penetration]") {
    const NormalModel normal = GENERATE(NormalModel::kp, NormalModel::kpec, NormalModel::analyn);
    ContactProblem problem = given_case(normal);
    problem.approach = GENERATE(0.0, -0.01);
    const ContactSolution solution = solved(problem);
    CHECK(solution.forces.Fn == 0);
    CHECK(solution.elements.contact == 0);
}

TEST_CASE("Distances from another level have the same pressures at as much more approach", "[penetration]") {
    const NormalModel normal = GENERATE(NormalModel::kp, NormalModel::kpec, NormalModel::analyn);
    ContactProblem problem = given_case(normal);
    const auto before = solved(problem).pressure;
    for (double& h : std::get<std::vector<double>>(*problem.gap)) h += 0.25;
    problem.approach = 0.28;
    const auto after = solved(problem).pressure;
    for (std::size_t i = 0; i < before.size(); ++i) CHECK_THAT(after[i], WithinAbs(before[i], 1e-7));
}

TEST_CASE("Tractions on pressures of virtual penetration carry their share", "[penetration]") {
    const NormalModel normal = GENERATE(NormalModel::kp, NormalModel::kpec, NormalModel::analyn);
    const Model model = GENERATE(Model::fastsim, Model::fastrip, Model::polach);
    ContactProblem problem = given_case(normal);
    problem.model = model;
    problem.friction = FrictionLaw{{0.3}, {}};
    Rolling rolling;
    rolling.xi = 5;
    problem.motion = rolling;
    const ContactSolution solution = solved(problem);
    CHECK_THAT(solution.forces.Fx, WithinRel(-0.3 * solution.forces.Fn, 2e-3));
    CHECK(solution.elements.slip == solution.elements.contact);
}

TEST_CASE("The exact tractions on pressures of virtual penetration are those of the full theory", "[penetration]") {
    ContactProblem problem = given_case(NormalModel::kpec);
    problem.model = Model::full;
    problem.friction = FrictionLaw{{0.3}, {}};
    Rolling rolling;
    rolling.xi = 0.001;
    problem.motion = rolling;
    const ContactSolution full = test::solve_half_spaces(problem);
    CHECK(full.converged());
    CHECK_THAT(full.forces.Fn, WithinRel(23434.7088, 1e-8));
    problem.model = Model::fastsim;
    CHECK_THAT(solved(problem).forces.Fx, WithinRel(full.forces.Fx, 0.06));
}

TEST_CASE("Models of virtual penetration tell where they leave what they are made for", "[penetration]") {
    ContactProblem problem = given_case(NormalModel::analyn);
    auto& gap = std::get<std::vector<double>>(*problem.gap);
    gap = heights(problem.grid, [](double x, double y) { return 0.001 * x * x + 1e-5 * std::pow(y * y - 16, 2); });
    CHECK(std::ranges::any_of(solved(problem).warnings,
                              [](const std::string& w) { return w.find("concave across") != w.npos; }));
    problem.normal_model = NormalModel::kpec;
    gap = heights(problem.grid, [](double x, double y) { return 2e-4 * x * x + 5e-3 * std::pow(std::abs(y), 1.2); });
    problem.grid.dx = 1;
    CHECK_NOTHROW(solved(problem));
}

TEST_CASE("What goes against pressures of virtual penetration is refused", "[penetration]") {
    ContactProblem problem = given_case(NormalModel::kpec);
    problem.model = Model::hertz;
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("model hertz, which has its own pressures"));
    problem = given_case(NormalModel::kpec);
    problem.derivatives = true;
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("derivatives"));
    problem = given_case(NormalModel::kpec);
    problem.sheet_flexibility = 1e-4;
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("sheet"));
}

TEST_CASE("Pressures over an ellipse are those prescribed, with tractions of the full theory", "[penetration]") {
    const NormalModel normal = GENERATE(NormalModel::elliptic, NormalModel::parabolic);
    const double q = GENERATE(0.0, 0.4, -0.4), a = 4, b = 2, Fn = 10000;
    ContactProblem problem = pressed(normal, 81, 81, 0.1125, 0.0575);
    problem.model = Model::full;
    problem.gap = q == 0 ? Gap(SemiAxes{a, b}) : Gap(HalfEllipses{a, b * (1 - q), b * (1 + q)});
    problem.Fn = Fn;
    problem.friction.emplace();
    problem.friction->mu = {0.3};
    Rolling rolling;
    rolling.xi = 1;  // full slip
    problem.motion = rolling;
    const ContactSolution solution = test::solve_half_spaces(problem);
    CHECK(solution.converged());
    const bool parabolic = normal == NormalModel::parabolic;
    const double p0 = (parabolic ? 2 : 1.5) * Fn / (std::numbers::pi * a * b);
    CHECK_THAT(solution.forces.Fn, WithinRel(Fn, parabolic ? 1e-3 : 3e-3));
    CHECK_THAT(solution.pmax, WithinRel(p0, 3e-3));
    CHECK_THAT(solution.forces.Fx, WithinRel(-0.3 * solution.forces.Fn, 1e-7));
    const Grid& grid = problem.grid;
    for (int iy = 0; iy < grid.ny; ++iy) {
        const double y = grid.y(iy) + b * q, width = y > 0 ? b * (1 + q) : b * (1 - q);
        const double e = 1 - y * y / (width * width), expected = parabolic ? p0 * e : p0 * std::sqrt(std::max(e, 0.0));
        const double p = solution.pressure[static_cast<std::size_t>(iy * grid.nx + grid.nx / 2)];
        CHECK_THAT(p, WithinAbs(std::max(expected, 0.0), 1e-9 * p0));
    }
}

TEST_CASE("Pressures of Hertz's ellipse lead to the forces of the full theory", "[penetration]") {
    ContactProblem problem = pressed(NormalModel::of_model, 61, 61, 0.15, 0.077);
    problem.model = Model::full;
    problem.gap = SemiAxes{4, 2};
    problem.Fn = 10000;
    problem.friction.emplace();
    problem.friction->mu = {0.3};
    Rolling rolling;
    rolling.xi = 5e-4;
    problem.motion = rolling;
    const double full = test::solve_half_spaces(problem).forces.Fx;
    problem.normal_model = NormalModel::elliptic;
    CHECK_THAT(test::solve_half_spaces(problem).forces.Fx, WithinRel(full, 5e-3));
}

TEST_CASE("Two half ellipses that no pressures are prescribed over are refused", "[penetration]") {
    ContactProblem problem = pressed(NormalModel::of_model, 21, 21, 0.5, 0.25);
    problem.gap = HalfEllipses{4, 2, 3};
    problem.Fn = 1000;
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("gap.half_ellipses"));
    problem.normal_model = NormalModel::elliptic;
    CHECK_NOTHROW(solved(problem));
    problem.Fn.reset();
    problem.approach = 0.01;
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("give Fn"));
    problem.approach.reset();
    problem.Fn = 1000;
    problem.gap = HalfEllipses{4, 2, 0};
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("gap.half_ellipses.b_positive"));
    problem.gap = std::vector<double>(problem.grid.size(), 0.0);
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("has no contact ellipse"));
    problem.gap = Paraboloid{300, -300};
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("flat or concave"));
}

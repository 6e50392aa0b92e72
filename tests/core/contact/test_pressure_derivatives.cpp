// Tests the derivative of the pressures by the approach.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

#include "closed_forms/hertz.hpp"
#include "contact_cases.hpp"
#include "contactd/error.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const Material steel{82000, 0.28}, soft{20000, 0.1};

/// Creates a contact of about 4 x 3 mm on 35 x 35 elements under a prescribed approach, without friction.
ContactProblem pressed(const Material& lower = steel) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(35, 35, 0.3, 0.22);
    problem.bodies = Bodies::of({steel, lower});
    problem.gap = Paraboloid{460, 200};
    problem.approach = 0.04;
    problem.derivatives = true;
    return problem;
}

/// Adds steady rolling in which a part of the contact slips.
ContactProblem rolling(ContactProblem problem) {
    problem.friction = FrictionLaw{{0.3}};
    Rolling motion;
    motion.xi = 8e-4;
    motion.eta = 5e-4;
    motion.phi = 5e-5;
    problem.motion = motion;
    return problem;
}

ContactSolution solved(const ContactProblem& problem) {
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    REQUIRE(solution.pressure_by_approach.size() == problem.grid.size());
    return solution;
}

double sum_of(const Values& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

Values weights_of(Values values) {
    const double sum = sum_of(values);
    for (double& value : values) value /= sum;
    return values;
}

void check_close(const Values& a, const Values& b, double tolerance) {
    REQUIRE(a.size() == b.size());
    double error = 0;
    for (std::size_t i = 0; i < a.size(); ++i) error = std::max(error, std::abs(a[i] - b[i]));
    CHECK(error <= tolerance * largest(b));
}

/// Creates a flat punch with the outline of the contact.
ContactProblem punch(ContactProblem problem, const ContactSolution& solution) {
    constexpr double far = 1e3;
    Values gap(problem.grid.size(), far);
    for (std::size_t i = 0; i < gap.size(); ++i)
        if (solution.pressure[i] > 0) gap[i] = 0;
    problem.gap = gap;
    problem.approach.reset();
    problem.Fn = 100;
    return problem;
}

/// Returns the central difference of the pressures by the approach, between whose ends no element changes its state.
Values difference(ContactProblem problem, const ContactSolution& solution) {
    const double step = 1e-5 * solution.approach;
    problem.Fn.reset();
    problem.derivatives = false;
    problem.settings = {{1e-12, 3000}, {1e-12, 3000}, {1e-11, 300}};
    problem.approach = solution.approach + step;
    const ContactSolution more = solve_half_spaces(problem);
    problem.approach = solution.approach - step;
    const ContactSolution less = solve_half_spaces(problem);
    REQUIRE(more.element_division == solution.element_division);
    REQUIRE(less.element_division == solution.element_division);
    Values values;
    for (std::size_t i = 0; i < problem.grid.size(); ++i)
        values.push_back((more.pressure[i] - less.pressure[i]) / (2 * step));
    return values;
}

}  // namespace

TEST_CASE("pressures change with the approach as under a flat punch", "[derivatives]") {
    ContactProblem problem = pressed(GENERATE(steel, soft));
    SECTION("of half-spaces") {}
    SECTION("with a sheet between them") {
        problem.sheet_flexibility = 1e-5;
    }
    const ContactSolution solution = solved(problem);
    const ContactSolution flat = solve_half_spaces(punch(problem, solution));
    check_close(weights_of(solution.pressure_by_approach), weights_of(flat.pressure), 1e-5);
    CHECK_THAT(*solution.derivatives->Fn->approach, WithinRel(flat.forces.Fn / flat.approach, 1e-6));
}

TEST_CASE("the derivatives of the pressures add up to that of the force", "[derivatives]") {
    ContactProblem problem = pressed(GENERATE(steel, soft));
    if (GENERATE(false, true)) problem = rolling(problem);
    const ContactSolution by_approach = solved(problem);
    const double area = problem.grid.element_area();
    CHECK_THAT(area * sum_of(by_approach.pressure_by_approach),
               WithinRel(*by_approach.derivatives->Fn->approach, 1e-9));
    problem.approach.reset();
    problem.Fn = by_approach.forces.Fn;
    const ContactSolution by_force = solved(problem);
    CHECK_THAT(area * sum_of(by_force.pressure_by_approach) * *by_force.derivatives->approach->Fn, WithinRel(1, 1e-9));
    check_close(by_force.pressure_by_approach, by_approach.pressure_by_approach, 1e-5);
}

TEST_CASE("derivatives of the pressures are central differences of two solves", "[derivatives]") {
    ContactProblem problem = pressed(GENERATE(steel, soft));
    SECTION("without friction") {}
    SECTION("in rolling") {
        problem = rolling(problem);
    }
    SECTION("in a shift") {
        problem = rolling(problem);
        problem.motion = Shift{{0.004, 0.003}, 1e-4};
    }
    const ContactSolution solution = solved(problem);
    check_close(solution.pressure_by_approach, difference(problem, solution), 1e-4);
}

TEST_CASE("tractions matter to the pressures of dissimilar bodies only", "[derivatives]") {
    const ContactProblem alike = pressed(), differs = pressed(soft);
    check_close(solved(rolling(alike)).pressure_by_approach, solved(alike).pressure_by_approach, 1e-12);
    const ContactSolution rolled = solved(rolling(differs)), plain = solved(differs);
    CHECK(std::abs(sum_of(rolled.pressure_by_approach) / sum_of(plain.pressure_by_approach) - 1) > 1e-3);
}

TEST_CASE("Hertz's weights have the moments of a flat elliptic punch", "[derivatives]") {
    const ContactProblem problem = pressed();
    const ContactSolution solution = solved(problem);
    const HertzContact hertz = hertz_of_approach(std::get<Paraboloid>(*problem.gap),
                                                 problem.bodies.materials().normal_compliance(), *problem.approach);
    const Values weights = weights_of(solution.pressure_by_approach);
    double xx = 0, yy = 0;
    for (int iy = 0; iy < problem.grid.ny; ++iy)
        for (int ix = 0; ix < problem.grid.nx; ++ix) {
            const double x = problem.grid.x(ix), y = problem.grid.y(iy), w = weights[at(problem.grid, ix, iy)];
            xx += w * x * x;
            yy += w * y * y;
            const double from_edge = 1 - std::pow(x / hertz.a, 2) - std::pow(y / hertz.b, 2);
            if (from_edge < 0.5) continue;
            // w = 1/(2 pi a b sqrt(1 - x^2/a^2 - y^2/b^2))
            const double closed = 1 / (2 * std::numbers::pi * hertz.a * hertz.b * std::sqrt(from_edge));
            CHECK_THAT(w / problem.grid.element_area(), WithinRel(closed, 0.02));
        }
    CHECK_THAT(xx, WithinRel(hertz.a * hertz.a / 3, 0.02));
    CHECK_THAT(yy, WithinRel(hertz.b * hertz.b / 3, 0.02));
    CHECK_THAT(*solution.derivatives->Fn->approach, WithinRel(1.5 * hertz.Fn / hertz.approach, 0.01));
}

TEST_CASE("derivatives of the pressures scale with the units", "[derivatives]") {
    const ContactProblem in_mm = pressed();
    ContactProblem in_m = in_mm;
    in_m.grid = Grid::of_elements(35, 35, 0.3e-3, 0.22e-3);
    in_m.bodies = Bodies::of({{82000e6, 0.28}, {82000e6, 0.28}});
    in_m.gap = Paraboloid{0.460, 0.200};
    in_m.approach = 0.04e-3;
    Values scaled = solved(in_m).pressure_by_approach;
    for (double& value : scaled) value *= 1e-9;  // N/m^3
    check_close(scaled, solved(in_mm).pressure_by_approach, 1e-9);
}

TEST_CASE("derivatives of the pressures are symmetric, and zero outside the contact", "[derivatives]") {
    const ContactProblem problem = pressed();
    const ContactSolution solution = solved(problem);
    const Grid& grid = problem.grid;
    Values rotated = solution.pressure_by_approach, mirrored;
    std::ranges::reverse(rotated);
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = grid.nx - 1; ix >= 0; --ix) mirrored.push_back(solution.pressure_by_approach[at(grid, ix, iy)]);
    check_close(rotated, solution.pressure_by_approach, 1e-10);
    check_close(mirrored, solution.pressure_by_approach, 1e-10);
    for (std::size_t i = 0; i < grid.size(); ++i)
        CHECK((solution.pressure_by_approach[i] > 0) == (solution.pressure[i] > 0));
}

TEST_CASE("regions without interaction have the weights of each", "[derivatives]") {
    ContactProblem both = pressed();
    both.grid = Grid::of_elements(70, 35, 0.3, 0.22);
    Values gap;
    for (int iy = 0; iy < both.grid.ny; ++iy)
        for (int ix = 0; ix < both.grid.nx; ++ix) {
            const double x = std::abs(both.grid.x(ix)) - 35 * 0.15, y = both.grid.y(iy);
            gap.push_back(x * x / 920 + y * y / 400);
        }
    both.gap = gap;
    both.regions = {{{{-12, 0}, {-5, 5}}, {{0, 12}, {-5, 5}}}, {1, 0, 0, 1}};
    const ContactProblem one = pressed();
    CHECK_THAT(sum_of(solved(both).pressure_by_approach),
               WithinRel(2 * sum_of(solved(one).pressure_by_approach), 1e-5));
}

TEST_CASE("solutions without derivatives by the approach of each element have an empty array", "[derivatives]") {
    ContactProblem problem = pressed();
    SECTION("not requested") {
        problem.derivatives = false;
    }
    SECTION("nothing touches") {
        problem.approach = -0.1;
    }
    SECTION("a simplified model") {
        problem.model = Model::hertz;
    }
    CHECK(solve_half_spaces(problem).pressure_by_approach.empty());
}

TEST_CASE("derivatives of pressures that are not available are refused by name", "[derivatives]") {
    ContactProblem problem = pressed();
    const auto refused_field = [&] {
        try {
            validate(problem);
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return std::string();
    };
    SECTION("virtual penetration") {
        problem.normal_model = NormalModel::kp;
        CHECK(refused_field() == "derivatives");
    }
    SECTION("viscoelastic bodies") {
        problem = rolling(problem);
        std::get<Rolling>(problem.motion) = {};
        std::get<Rolling>(problem.motion).velocity = 1000;
        problem.bodies.upper.viscoelastic = Viscoelasticity{1, 0.005};
        CHECK(refused_field() == "derivatives");
    }
    SECTION("curved columns") {
        problem.gap = Values(problem.grid.size());
        ContactColumns columns;
        for (int iy = 0; iy < problem.grid.ny; ++iy) columns.frames.push_back({problem.grid.y(iy), 0, 0});
        problem.columns = columns;
        CHECK(refused_field() == "derivatives");
    }
}

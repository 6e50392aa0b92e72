#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "contactd/error.hpp"
#include "random_viscoelastic.hpp"
#include "viscoelastic_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

ContactSolution solved(const ContactProblem& problem) {
    ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    return solution;
}

double creepage(const ContactSolution& solution) {
    return std::get<Rolling>(*solution.motion).xi;
}

bool warns(const ContactSolution& solution, const char* text) {
    for (const std::string& warning : solution.warnings)
        if (warning.find(text) != std::string::npos) return true;
    return false;
}

Bodies elastic_of(double G) {
    return Bodies::of({{G, 0.4}, {G, 0.4}});
}

}  // namespace

TEST_CASE("cylinders that creep have the values of a given prototype", "[viscoelastic]") {
    struct Given {
        ContactProblem problem;
        double approach, pmax, creepage, power;
        int contact, slip;
    };
    const Given given =
        GENERATE(Given{nylon_cylinders(0), 2.508454, 60.3150, 0.0137840, 1437.885, 80, 29},
                 Given{nylon_cylinders(0.009), 2.367354, 78.7385, 0.0136524, 913.725, 62, 25},
                 Given{cylinders({900, 0.45}, 2.5, 0.012), 4.44998112, 68.6499951, 0.0204646968, 971.34354, 72, 32});
    const ContactSolution solution = solved(given.problem);
    CHECK_THAT(solution.approach, WithinRel(given.approach, 4e-7));
    CHECK_THAT(solution.pmax, WithinRel(given.pmax, 1e-6));
    CHECK_THAT(creepage(solution), WithinRel(given.creepage, 5e-6));
    CHECK_THAT(*solution.frictional_power / 1000, WithinRel(given.power, 1e-5));
    CHECK(solution.elements.contact == given.contact);
    CHECK(solution.elements.slip == given.slip);
}

TEST_CASE("creep moves the pressures ahead, and what that costs is what the bodies lose", "[viscoelastic]") {
    struct Given {
        double tau, centre, rise, fall;
    };
    const Given given = GENERATE(Given{0.009, 1.22212389, 14665.5, 14661.3}, Given{0.045, 0.595, 7137.0, 7137.9},
                                 Given{2, 0.028, 0, 0});
    const ContactSolution solution = solved(nylon_cylinders(given.tau));
    REQUIRE(solution.rolling_resistance);
    const RollingResistance& found = *solution.rolling_resistance;
    CHECK_THAT(found.centre_of_pressure, WithinRel(given.centre, given.tau == 0.009 ? 1e-6 : 2e-2));
    CHECK_THAT(found.moment, WithinRel(6e5 * found.centre_of_pressure, 1e-12));
    CHECK_THAT(found.power, WithinRel(1000 * found.force, 1e-12));
    CHECK(found.defect < 1e-3);
    if (given.rise == 0) return;
    CHECK_THAT(found.force, WithinRel(given.rise, 1e-5));
    double scale = 0;
    for (std::size_t i = 0; i < solution.pressure.size(); ++i)
        scale += solution.pressure[i] * std::abs(-7.92 + 0.16 * static_cast<double>(i)) / 50 * 160;
    CHECK_THAT(found.defect * scale, WithinAbs(std::abs(given.rise - given.fall), 0.1));
}

TEST_CASE("creep at once or none at all is elasticity", "[viscoelastic]") {
    const double f = 2.5;
    ContactProblem problem = spheres(20, f, 0), elastic = problem;
    elastic.bodies = elastic_of(1143 / (1 + f));
    SECTION("at once") {}
    SECTION("none") {
        problem.bodies = spheres(20, 0, 0.01).bodies;
        elastic.bodies = elastic_of(1143);
    }
    const ContactSolution creeps = solved(problem), is_elastic = solved(elastic);
    CHECK(creeps.pressure == is_elastic.pressure);
    CHECK(creeps.traction_x == is_elastic.traction_x);
    CHECK(creeps.slip_x == is_elastic.slip_x);
    CHECK(creeps.warnings == is_elastic.warnings);
    REQUIRE(creeps.rolling_resistance);
    CHECK_THAT(creeps.rolling_resistance->force, WithinAbs(0, 1e-6));
}

TEST_CASE("fast and slow creep approach elasticity", "[viscoelastic]") {
    const double f = 2.5;
    ContactProblem problem = spheres(20, f, 0);
    const double dx = problem.grid.dx;
    const auto [tau, G, accuracy] =
        GENERATE_COPY(std::tuple(1e-6 * dx / 1000, 1143 / (1 + f), 1e-5), std::tuple(1e9 / 1000, 1143.0, 1e-6));
    problem = spheres(20, f, tau);
    ContactProblem elastic = problem;
    elastic.bodies = elastic_of(G);
    const ContactSolution creeps = solved(problem), is_elastic = solved(elastic);
    CHECK_THAT(creeps.approach, WithinRel(is_elastic.approach, accuracy));
    for (std::size_t i = 0; i < creeps.pressure.size(); ++i) {
        CHECK_THAT(creeps.pressure[i], WithinAbs(is_elastic.pressure[i], 10 * accuracy * is_elastic.pmax));
        CHECK_THAT(creeps.traction_x[i], WithinAbs(is_elastic.traction_x[i], 10 * accuracy * is_elastic.pmax));
    }
}

TEST_CASE("rolling the other way mirrors the contact of bodies that creep", "[viscoelastic]") {
    ContactProblem problem = spheres(20, 1, 2e-3);
    problem.bodies.upper.viscoelastic->f = 2;
    const ContactSolution forward = solved(problem);
    auto& rolling = std::get<Rolling>(problem.motion);
    rolling.chi = std::numbers::pi;
    rolling.xi = -rolling.xi;
    const ContactSolution backward = solved(problem);
    const Grid& grid = problem.grid;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const std::size_t here = at(grid, ix, iy), there = at(grid, grid.nx - 1 - ix, iy);
            CHECK_THAT(backward.pressure[there], WithinAbs(forward.pressure[here], 1e-6 * forward.pmax));
            CHECK_THAT(backward.traction_x[there], WithinAbs(-forward.traction_x[here], 1e-4 * forward.pmax));
        }
    CHECK_THAT(backward.rolling_resistance->force, WithinRel(forward.rolling_resistance->force, 1e-5));
    CHECK_THAT(backward.rolling_resistance->centre_of_pressure,
               WithinRel(-forward.rolling_resistance->centre_of_pressure, 1e-5));
}

TEST_CASE("an approach that is given brings the force that finds it", "[viscoelastic]") {
    ContactProblem problem = spheres(24, 1, 4e-3);
    const ContactSolution by_force = solved(problem);
    problem.approach = by_force.approach;
    problem.Fn.reset();
    const ContactSolution by_approach = solved(problem);
    CHECK_THAT(by_approach.forces.Fn, WithinRel(2000, 1e-6));
    CHECK_THAT(by_approach.pmax, WithinRel(by_force.pmax, 1e-6));
    CHECK(by_approach.evidence.normal.residual <= 1e-8);
    CHECK(by_approach.evidence.normal.iterations > 0);
}

TEST_CASE("line contacts creep as long rows of elements do", "[viscoelastic]") {
    ContactProblem row = nylon_cylinders(0.009), line = row;
    for (Body* body : {&line.bodies.upper, &line.bodies.lower})
        std::get<Ics>(body->ics).line_contact = LineContactSpec{100};
    const ContactSolution of_row = solved(row), of_line = solved(line);
    CHECK_THAT(of_line.pmax, WithinRel(of_row.pmax, 1e-3));
    CHECK_THAT(creepage(of_line), WithinRel(creepage(of_row), 1e-3));
    CHECK_THAT(of_line.rolling_resistance->force, WithinRel(of_row.rolling_resistance->force, 2e-3));
}

TEST_CASE("resistance is largest where creep takes as long as the contact", "[viscoelastic]") {
    double last = 0, largest = 0, at_largest = 0;
    for (const double l : {0.5, 2.0, 4.0, 8.0, 16.0, 64.0, 500.0}) {
        last = solved(nylon_cylinders(l / 1000)).rolling_resistance->force;
        if (last > largest) {
            largest = last;
            at_largest = l;
        }
    }
    CHECK(at_largest > 2);
    CHECK(at_largest < 20);
    CHECK(last < 0.1 * largest);
}

TEST_CASE("creep that a limit says as well is warned of", "[viscoelastic]") {
    CHECK(warns(solved(spheres(20, 1, 1e-4)), "less than half an element"));
    CHECK(warns(solved(spheres(20, 1, 10)), "more than a hundred times the length"));
    const ContactSolution usual = solved(spheres(20, 1, 5e-3));
    CHECK_FALSE(warns(usual, "viscoelastic"));
}

TEST_CASE("what is not known of bodies that creep is refused by its field", "[viscoelastic]") {
    ContactProblem problem = spheres(12, 1, 1e-3);
    const auto refused = [&](const char* field, const char* text) {
        try {
            validate(problem);
            FAIL(field);
        } catch (const InvalidArgument& error) {
            CHECK(error.field() == field);
            CHECK_THAT(error.what(), ContainsSubstring(text));
        }
    };
    auto& rolling = std::get<Rolling>(problem.motion);
    SECTION("transient rolling") {
        rolling.kind = RollingKind::transient;
        refused("friction.rolling.kind", "steady");
    }
    SECTION("across the axes") {
        rolling.chi = 0.4;
        refused("friction.rolling.chi", "0 or pi");
    }
    SECTION("shifts") {
        problem.motion = Shift{};
        refused("friction.rolling", "steady");
    }
    SECTION("no friction") {
        problem.friction.reset();
        refused("friction", "mu may be 0");
    }
    SECTION("simplified models") {
        problem.model = Model::fastsim;
        refused("model", "full");
    }
    SECTION("pressures of virtual penetration") {
        problem.normal_model = NormalModel::kpec;
        refused("normal_model", "viscoelastic");
    }
    SECTION("derivatives") {
        problem.derivatives = true;
        refused("derivatives", "viscoelastic");
    }
    SECTION("semi-axes") {
        problem.gap = SemiAxes{3, 3};
        refused("gap.semi_axes", "paraboloid");
    }
    SECTION("finite elements") {
        std::get<Ics>(problem.bodies.lower.ics).source = IcSource::fem;
        refused("bodies.lower.ics.source", "analytic");
    }
    SECTION("layers beside") {
        problem.bodies.lower = Body::of(Layers{{{1, 1000, 0.3}}, {1000, 0.3}});
        refused("bodies.lower.ics.body", "the other body is viscoelastic");
    }
    SECTION("a rigid body") {
        problem.bodies.lower.material = Material::rigid();
        refused("bodies.lower.viscoelastic", "rigid");
    }
    SECTION("numbers") {
        problem.bodies.upper.viscoelastic->tau = -1;
        refused("bodies.upper.viscoelastic.tau", "is -1");
    }
    SECTION("numbers of creep") {
        problem.bodies.upper.viscoelastic->f = std::numeric_limits<double>::quiet_NaN();
        refused("bodies.upper.viscoelastic.f", "it must lie in");
    }
}

TEST_CASE("random bodies that creep keep all contact conditions", "[viscoelastic]") {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        CAPTURE(seed);
        const ContactProblem problem = random_viscoelastic(seed, 20);
        const ContactSolution solution = solve_half_spaces(problem);
        CHECK(solution.converged());
        CHECK(contact_faults(problem, solution, {}, 1e-4) == "");
    }
}

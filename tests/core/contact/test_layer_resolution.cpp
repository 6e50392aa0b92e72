// Tests layers under relatively wide elements: errors, warnings and refusals.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <string>

#include "contact/warnings/layer_resolution.hpp"
#include "contactd/error.hpp"
#include "random_layers.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;

namespace {

/// Creates a rigid sphere that would touch about `across` elements on a layer of thickness 1, divided `finer` times.
ContactProblem sphere(const Layers& body, double element, int across, int finer = 1) {
    ContactProblem problem;
    const int n = 2 * across * finer;
    problem.grid = Grid::of_elements(n, n, element / finer, element / finer);
    problem.bodies = {{Material::rigid()}, Body::of(body)};
    const double radius = across * element / 2;
    problem.approach = 1e-3;
    problem.gap = Paraboloid{radius * radius / 4e-3, radius * radius / 4e-3};
    return problem;
}

Layers film(double nu, Material base = Material::rigid()) {
    return {{{1, 1, nu}}, base};
}

/// Returns the ratio of a contact that is as long as it is wide.
double ratio_of(const ContactSolution& solution, const Layers& body, double element) {
    const double length = solution.evidence.discretisation->elements_across * element;
    return *compliance_ratio(sphere(body, element, 8), {length, length});
}

bool warns(const ContactSolution& solution) {
    for (const std::string& warning : solution.warnings)
        if (warning.find("times the thickness of the thinnest layer") != std::string::npos) return true;
    return false;
}

}  // namespace

TEST_CASE("elements wide beside a layer state what they cost", "[layers]") {
    struct Case {
        const char* name;
        Layers body;
        double element;
        int finer;
    };
    const Case given = GENERATE(Case{"on a rigid base", film(0.5), 1, 3}, Case{"on a rigid base", film(0.5), 2, 4},
                                Case{"hardly compressible", film(0.49), 2, 4},
                                Case{"on a stiff half-space", film(0.5, {1000, 0.3}), 2, 4},
                                Case{"under a stiff one", {{{0.1, 3, 0.3}, {0.9, 1, 0.5}}, Material::rigid()}, 2, 4});
    INFO(given.name << ", elements of " << given.element);
    const ContactSolution coarse = solve_layers(sphere(given.body, given.element, 12));
    const ContactSolution fine = solve_layers(sphere(given.body, given.element, 12, given.finer));
    REQUIRE((coarse.converged() && fine.converged()));
    CHECK(warns(coarse));
    CHECK(!warns(fine));
    const double found = coarse.forces.Fn / fine.forces.Fn - 1;
    CHECK_THAT(1 / ratio_of(coarse, given.body, given.element) - 1, WithinAbs(found, 0.03));
    CHECK(coarse.evidence.discretisation->force_error > 0.9 * std::abs(found));
}

TEST_CASE("the warning begins where the compliance is off by one per cent", "[layers]") {
    const double element = GENERATE(0.5, 0.7, 0.9, 1.2, 3.0, 7.0, 10.0);
    const ContactSolution solution = solve_layers(sphere(film(0.5), element, 16));
    INFO("elements of " << element);
    CHECK(warns(solution) == (element > 0.8));
}

TEST_CASE("layers that are compressed bear elements of any width", "[layers]") {
    const double nu = GENERATE(0.0, 0.3, 0.4), element = GENERATE(3.0, 10.0, 100.0);
    const ContactSolution solution = solve_layers(sphere(film(nu), element, 16));
    CHECK(!warns(solution));
    CHECK_THAT(ratio_of(solution, film(nu), element), WithinAbs(1, 0.01));
}

TEST_CASE("a soft half-space below carries what a thin layer does not", "[layers]") {
    const ContactSolution solution = solve_layers(sphere(film(0.5, {1, 0.3}), 10, 16));
    CHECK(!warns(solution));
}

TEST_CASE("elements under which nothing is left of a layer are refused", "[layers]") {
    const double element = GENERATE(15.0, 20.0, 50.0, 1000.0);
    ContactProblem problem = sphere(film(0.5), element, 12);
    SECTION("before the solve") {}
    SECTION("longer along y than along x") {
        if (element < 50) return;  // the layer still affects the contact along x
        problem.grid.dx /= 4;
    }
    SECTION("hat functions") {
        problem.bodies.lower = Body::of(film(0.5), LoadShape::bilinear);
    }
    SECTION("beneath half-spaces that hardly yield") {
        problem.bodies.upper = {{1e18, 0.3}};
    }
    std::string message;
    try {
        solve_layers(problem);
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == (problem.grid.dx < element ? "grid.dy" : "grid.dx"));
        message = error.what();
    }
    CHECK_THAT(message, ContainsSubstring(" times the thickness of the thinnest layer"));
    // The message suggests the correct size.
    const std::string before = "Use elements of at most ";
    const double advised = std::stod(message.substr(message.find(before) + before.size()));
    CAPTURE(message);
    CHECK(advised > 0.5);
    problem = sphere(film(0.5), 0.95 * advised, 12);
    CHECK(!warns(solve_layers(problem)));
}

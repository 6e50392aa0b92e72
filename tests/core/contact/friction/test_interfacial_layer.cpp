// Tests a layer between the bodies against values of another program for equations 1 of docs/friction.md, and closed
// forms.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>

#include "../contact_cases.hpp"

namespace contactd::test {
namespace {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

constexpr double infinite = std::numeric_limits<double>::infinity();

ContactProblem steel(const Grid& grid, double Rx, double Ry, double Fn, double mu, const InterfacialLayer& layer) {
    ContactProblem problem;
    problem.grid = grid;
    const Material material{82000, 0.28};
    problem.bodies = Bodies::of(MaterialPair{material, material});
    problem.gap = Paraboloid{Rx, Ry};
    problem.Fn = Fn;
    problem.friction = FrictionLaw{{mu}, {}, layer};
    problem.settings.tangential.tolerance = 1e-9;
    problem.settings.normal.tolerance = 1e-11;
    return problem;
}

ContactProblem rolling_steel(const InterfacialLayer& layer) {
    ContactProblem problem = steel(Grid::of_elements(17, 15, 0.65, 0.6), 460, 300, 30000, 0.35, layer);
    problem.motion = Rolling{.xi = 1.1e-3, .eta = -7e-4, .phi = 1.5e-4, .dq = 0.65};
    return problem;
}

ContactSolution solved(const ContactProblem& problem) {
    ContactSolution solution = solve_half_spaces(problem);
    CAPTURE(solution.evidence.tangential->residual, solution.evidence.tangential->iterations);
    REQUIRE(solution.converged());
    return solution;
}

double largest_yield_stress(const ContactSolution& solution) {
    return *std::ranges::max_element(solution.yield_stress);
}

SurfaceState state_after(const ContactSolution& solution) {
    return {solution.pressure, solution.traction_x, solution.traction_y, solution.yield_stress, {}};
}

}  // namespace

TEST_CASE("a layer lowers tractions of steady rolling as given", "[interfacial_layer]") {
    struct Given {
        InterfacialLayer layer;
        double Fx, Fy, Mz, work, plastic;
        int adhesion, flow;
        double yield_stress;
    };
    const auto given = GENERATE(
        Given{{}, -5714.85361, 1852.12453, -5784.13273, 6.82321851, 0, 87, 0, infinite},
        Given{{2e-5}, -4167.20124, 1529.73253, -4728.99591, 4.22609891, 0, 117, 0, infinite},
        Given{{2e-5, 120, 9000}, -3952.53203, 1455.92558, -4276.25497, 4.32377668, 2.42281257, 91, 38, 160.527122},
        Given{{2e-5, 120, -4000}, -3646.06414, 1332.26528, -3506.66097, 4.31878623, 3.20350997, 89, 41, 120});
    const ContactSolution solution = solved(rolling_steel(given.layer));
    CHECK_THAT(solution.approach, WithinRel(0.0470232396, 1e-8));
    CHECK_THAT(solution.forces.Fx, WithinRel(given.Fx, 2e-8));
    CHECK_THAT(solution.forces.Fy, WithinRel(given.Fy, 2e-8));
    CHECK_THAT(solution.forces.Mz, WithinRel(given.Mz, 2e-8));
    CHECK_THAT(*solution.frictional_power, WithinRel(given.work, 1e-7));
    CHECK(solution.elements.adhesion == given.adhesion);
    CHECK(solution.elements.contact == 147);
    CHECK(solution.elements.flow == given.flow);
    if (!given.layer.yields()) return;
    CHECK_THAT(*solution.plastic_power, WithinRel(given.plastic, 1e-7));
    CHECK_THAT(largest_yield_stress(solution), WithinRel(given.yield_stress, 1e-7));
}

TEST_CASE("shifts one after the other carry what the layer has hardened", "[interfacial_layer]") {
    ContactProblem problem = steel(Grid::of_elements(15, 15, 0.15, 0.15), 50, 50, 1500, 0.5, {1e-5, 150, 20000});
    struct Step {
        double x, y, Fx, Fy, work;
    };
    ContactSolution solution;
    for (const Step& step : {Step{0.004, 0.001, -296.643888, -74.1632714, 0.125497797},
                             Step{-0.006, 0, 197.589645, -73.15625, 0.0151859563},
                             Step{0.001, -0.003, 112.993968, 174.792149, 0.00620373247}}) {
        problem.motion = Shift{{step.x, step.y}};
        solution = solved(problem);
        CHECK_THAT(solution.forces.Fx, WithinRel(step.Fx, 2e-8));
        CHECK_THAT(solution.forces.Fy, WithinRel(step.Fy, 2e-8));
        CHECK_THAT(*solution.frictional_work, WithinRel(step.work, 1e-6));
        problem.previous = state_after(solution);
    }
    CHECK_THAT(largest_yield_stress(solution), WithinRel(160.901382, 1e-8));
}

TEST_CASE("transient rolling of a row with a layer that hardens goes as given", "[interfacial_layer]") {
    ContactProblem problem = steel(Grid::of_elements(40, 1, 0.1, 400), 200, infinite, 800 * 400, 0.4, {1e-5, 60, 3e4});
    Rolling rolling{.xi = 1.5e-3, .dq = 0.1, .kind = RollingKind::transient};
    SECTION("step by step") {
        for (const double Fx : {-3.59870364, -7.15435106, -10.6648305, -14.1445813, -17.5930214, -21.0095403}) {
            problem.motion = rolling;
            const ContactSolution solution = solved(problem);
            CHECK_THAT(solution.forces.Fx / 400, WithinRel(Fx, 2e-8));
            problem.previous = state_after(solution);
        }
    }
    SECTION("six steps at once") {
        rolling.steps = 6;
        problem.motion = rolling;
        CHECK_THAT(solved(problem).forces.Fx / 400, WithinRel(-21.0095403, 2e-8));
    }
    SECTION("the steady state") {
        rolling.kind = RollingKind::steady;
        problem.motion = rolling;
        CHECK_THAT(solved(problem).forces.Fx / 400, WithinRel(-162.687953, 2e-8));
    }
}

TEST_CASE("an element of a layer follows its own law", "[interfacial_layer]") {
    // Uses one element of 1 x 1 mm between steel bodies; values of published programs have four digits.
    struct Given {
        InterfacialLayer layer;
        std::vector<std::pair<double, double>> steps;
    };
    const auto given = GENERATE(
        Given{{0.02 / 176.63, 560}, {{-0.035, 280}, {-0.035, 560}}},
        Given{{0.02 / 106.25, 200, 435},
              {{-0.04, 200}, {-0.04, 216}, {-0.04, 232}, {-0.04, 248}, {-0.036, 262.4}, {0, 262.4}, {0.036, 82.43}}});
    ContactProblem problem = steel(Grid::of_elements(1, 1, 1, 1), 1e6, 1e6, 900, 0.7, given.layer);
    for (const auto& [shift, traction] : given.steps) {
        problem.motion = Shift{{shift, 0}};
        const ContactSolution solution = solved(problem);
        CHECK_THAT(solution.traction_x[0], WithinRel(traction, 5e-4));
        problem.previous = state_after(solution);
    }
}

TEST_CASE("carter's contact with a layer that only flows has the published forces", "[interfacial_layer]") {
    struct Given {
        int nx;
        double dx, first, hardening, force;
    };
    const auto given = GENERATE(Given{30, 0.08, -1.16, 4018000, 0.6562}, Given{30, 0.08, -1.16, 0, 0.5959},
                                Given{105, 0.02, -1.04, 4018000, 0.6436}, Given{105, 0.02, -1.04, -20500, 0.5430});
    ContactProblem problem = steel({given.nx, 1, given.dx, 200, given.first - given.dx / 2, -100}, 500, infinite, 35780,
                                   0.5, {0, 35, given.hardening});
    problem.motion = Rolling{.xi = -4e-4, .dq = given.dx};
    CHECK_THAT(solved(problem).forces.Fx / (0.5 * 35780), WithinAbs(given.force, 6e-5));
}

TEST_CASE("wheels on rails with a layer that only flows have the published forces", "[interfacial_layer]") {
    const auto [hardening, force] =
        GENERATE(std::pair(9111.1, 0.9705), std::pair(828.28, 0.9033), std::pair(0.0, 0.8816));
    const double a = 6.30360, b = 12.60719;
    ContactProblem problem = steel(Grid::of_elements(44, 44, 2.2 * a / 44, 2.2 * b / 44), 1 / (2 * 8e-4),
                                   1 / (2 * 2.814173e-4), 106700, 0.33, {0, 150, hardening});
    problem.motion = Rolling{.xi = 0.0028, .dq = 2.2 * a / 44};
    CHECK_THAT(-solved(problem).forces.Fx / (0.33 * 106700), WithinAbs(force, 6e-5));
}

TEST_CASE("between stiff bodies a layer is a brush", "[interfacial_layer]") {
    // Bodies of almost no compliance touch at points only, so a sheet and a gap of the same shape prescribe the
    // pressures.
    const double L = 1e-3, k = GENERATE(0.5, 1.0);
    const int n = 100;
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, 1, 2.2 / n, 100);
    const Material stiff{1e12, 0.28};
    problem.bodies = Bodies::of(MaterialPair{stiff, stiff});
    problem.sheet_flexibility = 1e-3;
    Values h(static_cast<std::size_t>(n));
    const double p0 = 100;
    for (int i = 0; i < n; ++i) {
        const double x = problem.grid.x(i);
        h[static_cast<std::size_t>(i)] = std::abs(x) < 1 ? 1e-3 * p0 * (1 - std::sqrt(1 - x * x)) : 1;
    }
    problem.gap = h;
    problem.approach = 1e-3 * p0;
    problem.friction = FrictionLaw{{0.3}, {}, InterfacialLayer{L}};
    problem.motion = Rolling{.xi = k * L * 0.3 * p0, .dq = problem.grid.dx};
    const ContactSolution solution = solved(problem);
    const double part = -solution.forces.Fx / (0.3 * solution.forces.Fn);
    CHECK_THAT(part, WithinRel(2 / std::numbers::pi * (k / (1 + k * k) + std::atan(k)), 0.02));
}

TEST_CASE("without hardening flow is friction with a smaller bound", "[interfacial_layer]") {
    ContactProblem problem = rolling_steel({0, 120, 0});
    const ContactSolution flowing = solved(problem);
    // Coefficients of the elements result in the same bound.
    problem.friction->layer.reset();
    problem.friction->mu.assign(problem.grid.size(), 0.35);
    for (std::size_t i = 0; i < problem.grid.size(); ++i)
        if (flowing.pressure[i] > 0) problem.friction->mu[i] = std::min(0.35, 120 / flowing.pressure[i]);
    const ContactSolution limited = solved(problem);
    CHECK_THAT(flowing.forces.Fx, WithinRel(limited.forces.Fx, 1e-9));
    CHECK(flowing.elements.adhesion == limited.elements.adhesion);
    CHECK(flowing.elements.flow + flowing.elements.slip == limited.elements.slip);
    CHECK_THAT(*flowing.frictional_power, WithinRel(*limited.frictional_power, 1e-8));
}

TEST_CASE("much hardening leaves friction alone", "[interfacial_layer]") {
    const ContactSolution elastic = solved(rolling_steel({2e-5}));
    const ContactSolution hard = solved(rolling_steel({2e-5, 1, 1e12}));
    CHECK_THAT(hard.forces.Fx, WithinRel(elastic.forces.Fx, 1e-5));
    const ContactSolution strong = solved(rolling_steel({2e-5, 1e9, 100}));
    CHECK_THAT(strong.forces.Fx, WithinRel(elastic.forces.Fx, 1e-9));
    CHECK(strong.elements.flow == 0);
}

TEST_CASE("a layer that hardens looks the same from both sides", "[interfacial_layer]") {
    ContactProblem problem = rolling_steel({2e-5, 120, 9000});
    const ContactSolution right = solved(problem);
    auto& rolling = std::get<Rolling>(problem.motion);
    rolling.eta *= -1;
    rolling.phi *= -1;
    const ContactSolution left = solved(problem);
    CHECK_THAT(left.forces.Fx, WithinRel(right.forces.Fx, 1e-8));
    CHECK_THAT(left.forces.Fy, WithinRel(-right.forces.Fy, 1e-8));
    rolling.xi *= -1;
    rolling.phi *= -1;
    rolling.chi = std::numbers::pi;
    const ContactSolution back = solved(problem);
    CHECK_THAT(back.forces.Fx, WithinRel(-right.forces.Fx, 1e-8));
}

// If all elements of a row flow in the end, elements in slip begin to flow together, not one per iteration.
TEST_CASE("a layer that hardens takes no more iterations on many elements than on few", "[interfacial_layer]") {
    const auto forces_of = [](int n) {
        ContactProblem problem =
            steel(Grid::of_elements(n, n, 13.2 / n, 8.8 / n), 460, 300, 50000, 0.3, InterfacialLayer{2e-5, 100, 5000});
        problem.motion = Rolling{.xi = 2e-3, .eta = 1e-3, .phi = 1e-4};
        problem.settings = {};
        const ContactSolution solution = solved(problem);
        CHECK(solution.evidence.tangential->iterations < 25);
        CHECK(solution.elements.flow > solution.elements.contact / 2);
        return solution.forces;
    };
    const Forces few = forces_of(50), many = forces_of(200);
    CHECK_THAT(many.Fx, WithinRel(few.Fx, 0.02));
    CHECK_THAT(many.Fy, WithinRel(few.Fy, 0.02));
}

TEST_CASE("prescribed forces are met through a layer that hardens", "[interfacial_layer]") {
    ContactProblem problem = rolling_steel({2e-5, 120, 9000});
    std::get<Rolling>(problem.motion).force = {-3952.53203, 1455.92558};
    const ContactSolution solution = solved(problem);
    const auto& found = std::get<Rolling>(*solution.motion);
    CHECK_THAT(found.xi, WithinRel(1.1e-3, 1e-4));
    CHECK_THAT(found.eta, WithinRel(-7e-4, 1e-4));
}

TEST_CASE("a layer is refused where it makes no sense", "[interfacial_layer]") {
    const auto refused = [](const InterfacialLayer& layer) -> std::string {
        try {
            solve_half_spaces(rolling_steel(layer));
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return {};
    };
    CHECK(refused({-1}) == "friction.layer.flexibility");
    CHECK(refused({0, 0}) == "friction.layer.yield_stress");
    CHECK(refused({0, infinite, 5}) == "friction.layer.hardening");
    CHECK(refused({1e-4, 100, -1e4}) == "friction.layer.hardening");
    CHECK(refused({0, 100, -1, 1.5}) == "friction.layer.residual");
}

}  // namespace contactd::test

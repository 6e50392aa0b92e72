#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "contactd/error.hpp"
#include "contactd/extrapolate_forces.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinRel;

namespace {

constexpr double half_pi = std::numbers::pi / 2, mu = 0.3, Fn = 50'000, G = 82'000, a = 6, b = 4;

ContactProblem rolling_contact(double chi = 0) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(20, 20, 0.7, 0.5);
    problem.bodies = Bodies::of({{G, 0.28}, {G, 0.28}});
    problem.gap = SemiAxes{a, b};
    problem.Fn = Fn;
    problem.friction = FrictionLaw{{mu}};
    Rolling rolling;
    rolling.xi = 1e-3, rolling.eta = -2e-3, rolling.phi = 3e-4, rolling.chi = chi, rolling.velocity = 2;
    problem.motion = rolling;
    problem.accuracy = 5e-3;
    return problem;
}

/// Stands for solves on grids: forces are proportional to the creepages, with an error that depends on n.
struct Solves {
    std::function<double(int n)> error;
    bool converged = true;
    int iterations = 1;
    std::vector<ContactProblem> problems{};

    SolveOnGrid on_grid() {
        return [this](const ContactProblem& problem) {
            problems.push_back(problem);
            const auto& rolling = std::get<Rolling>(problem.motion);
            const double part = 0.1 * (1 + error(std::min(problem.grid.nx, problem.grid.ny)));
            ContactSolution solution;
            solution.forces = {1, -part * rolling.xi, -part * rolling.eta, -part * rolling.phi};
            solution.evidence.normal.converged = true;
            solution.evidence.tangential = SolverEvidence{iterations, 0, converged, 0};
            return solution;
        };
    }
};

ContactSolution extrapolated(const ContactProblem& problem, Solves& solves) {
    ContactSolution solution;
    solution.forces.Fn = Fn;
    extrapolate_forces(problem, solution, solves.on_grid());
    return solution;
}

}  // namespace

TEST_CASE("forces whose error is proportional to 1/n are extrapolated to their limit, in the units of the contact") {
    Solves solves{[](int n) { return 0.2 / n; }};
    const ContactSolution solution = extrapolated(rolling_contact(), solves);
    // 0.1 mu Fn times the scaled creepage G ab/(mu Fn) xi is 0.1 G ab xi; the moment has another ab of the spin.
    CHECK_THAT(solution.forces.Fx, WithinRel(-0.1 * G * a * b * 1e-3, 1e-9));
    CHECK_THAT(solution.forces.Fy, WithinRel(0.1 * G * a * b * 2e-3, 1e-9));
    CHECK_THAT(solution.forces.Mz, WithinRel(-0.1 * G * a * b * a * b * 3e-4, 1e-9));
    const Forces& forces = solution.forces;
    CHECK_THAT(*solution.frictional_power,
               WithinRel(-2 * (forces.Fx * 1e-3 - forces.Fy * 2e-3 + forces.Mz * 3e-4), 1e-9));
    REQUIRE(solution.evidence.accuracy);
    CHECK(solution.evidence.accuracy->converged);
    CHECK(solution.warnings.empty());
}

TEST_CASE("the evidence has the forces on the last two grids, whose extrapolation is the answer") {
    Solves solves{[](int n) { return 0.2 / n + 1.0 / (n * n); }};
    const ContactSolution solution = extrapolated(rolling_contact(), solves);
    const ForceAccuracy& accuracy = *solution.evidence.accuracy;
    CHECK(accuracy.fine.nx == 2 * accuracy.coarse.nx);
    CHECK(accuracy.fine.ny == 2 * accuracy.coarse.ny);
    CHECK_THAT(solution.forces.Fx, WithinRel(2 * accuracy.fine.Fx - accuracy.coarse.Fx, 1e-12));
    CHECK_THAT(solution.forces.Fy, WithinRel(2 * accuracy.fine.Fy - accuracy.coarse.Fy, 1e-12));
    CHECK_THAT(solution.forces.Mz, WithinRel(2 * accuracy.fine.Mz - accuracy.coarse.Mz, 1e-12));
}

TEST_CASE("grids are refined until the stated error is small enough, and a warning states a larger one") {
    const auto noise = [](int n) { return n < 36 ? 30 / std::sqrt(n) : 0; };
    Solves rough{noise}, fine{[](int) { return 0; }}, hopeless{[](int n) { return std::sin(n); }};
    const std::size_t refined = (extrapolated(rolling_contact(), rough), rough.problems.size());
    CHECK(refined > (extrapolated(rolling_contact(), fine), fine.problems.size()));
    const ContactSolution solution = extrapolated(rolling_contact(), hopeless);
    CHECK_FALSE(solution.evidence.accuracy->converged);
    CHECK(solution.evidence.accuracy->force_error > 5e-3);
    REQUIRE(solution.warnings.size() == 1);
    CHECK_THAT(solution.warnings[0], ContainsSubstring("accuracy is 0.005") && ContainsSubstring("144 x 288"));
}

TEST_CASE("a solve that has not converged is refined, and warned of if the finest has not either") {
    Solves solves{[](int) { return 0; }, false};
    const ContactSolution solution = extrapolated(rolling_contact(), solves);
    CHECK_FALSE(solution.evidence.accuracy->converged);
    REQUIRE(solution.warnings.size() == 1);
    CHECK_THAT(solution.warnings[0], ContainsSubstring("did not converge"));
}

TEST_CASE("grids on which the solver needs many iterations are not refined, and a warning states their error") {
    Solves solves{[](int n) { return std::sin(n); }, true, 60};
    const ContactSolution solution = extrapolated(rolling_contact(), solves);
    CHECK(solves.problems.size() == 3);
    CHECK_FALSE(solution.evidence.accuracy->converged);
    REQUIRE(solution.warnings.size() == 1);
    CHECK_THAT(solution.warnings[0], ContainsSubstring("36 x 72"));
}

TEST_CASE("grids fit the ellipse, with twice as many elements across the rolling direction") {
    const double chi = GENERATE(0.0, half_pi, 2 * half_pi, -half_pi);
    Solves solves{[](int) { return 0; }};
    extrapolated(rolling_contact(chi), solves);
    for (const ContactProblem& problem : solves.problems) {
        const Grid& grid = problem.grid;
        const bool along_x = std::abs(std::cos(chi)) > 0.5;
        CHECK((along_x ? grid.ny == 2 * grid.nx : grid.nx == 2 * grid.ny));
        CHECK_THAT((grid.nx * grid.dx) / (grid.ny * grid.dy), WithinRel(a / b, 1e-9));
        CHECK_THAT(grid.x0, WithinRel(-0.5 * grid.nx * grid.dx, 1e-12));
    }
}

TEST_CASE("contacts of one shape have the same grids, whatever their size, load and material") {
    ContactProblem small = rolling_contact();
    small.gap = SemiAxes{a / 3, b / 3};
    small.bodies = Bodies::of({{10, 0.28}, {10, 0.28}});
    small.Fn = 0.1;
    Solves one{[](int) { return 0; }}, other = one;
    extrapolated(rolling_contact(), one);
    extrapolated(small, other);
    CHECK(one.problems[0].grid == other.problems[0].grid);
    CHECK(one.problems[0].bodies == other.problems[0].bodies);
}

TEST_CASE("a prescribed approach results in Hertz's normal force") {
    ContactProblem problem = rolling_contact();
    problem.Fn.reset();
    problem.approach = 0.05;
    Solves solves{[](int) { return 0; }};
    const ContactSolution solution = extrapolated(problem, solves);
    CHECK(solution.forces.Fn != Fn);
    CHECK(solution.forces.Fn > 0);
}

TEST_CASE("nothing is extrapolated without a request, without contact, and without friction") {
    ContactProblem problem = rolling_contact();
    SECTION("no request") {
        problem.accuracy.reset();
    }
    SECTION("no contact") {
        problem.gap = Paraboloid{500, 300}, problem.Fn = 0;
    }
    SECTION("no friction") {
        problem.friction->mu = {0};
    }
    Solves solves{[](int) { return 0; }};
    CHECK_FALSE(extrapolated(problem, solves).evidence.accuracy);
    CHECK(solves.problems.empty());
}

TEST_CASE("ellipses beyond the verified shapes are refused") {
    ContactProblem problem = rolling_contact();
    problem.gap = GENERATE(SemiAxes{21, 1}, SemiAxes{1, 21});
    Solves solves{[](int) { return 0; }};
    CHECK_THROWS_WITH(extrapolated(problem, solves), ContainsSubstring("gap") && ContainsSubstring("0.05 to 20"));
}

TEST_CASE("what an accuracy does not support is refused by its name") {
    using Change = std::pair<const char*, std::function<void(ContactProblem&)>>;
    const auto rolling = [](ContactProblem& p) -> Rolling& { return std::get<Rolling>(p.motion); };
    const auto [field, change] = GENERATE_COPY(values<Change>({
        {"accuracy", [](ContactProblem& p) { p.accuracy = 5; }},
        {"accuracy", [](ContactProblem& p) { p.accuracy = 1e-9; }},
        {"accuracy", [](ContactProblem& p) { p.accuracy = std::nan(""); }},
        {"model", [](ContactProblem& p) { p.model = Model::fastsim; }},
        {"normal_model", [](ContactProblem& p) { p.normal_model = NormalModel::elliptic; }},
        {"friction", [](ContactProblem& p) { p.friction.reset(); }},
        {"friction", [](ContactProblem& p) { p.motion = Shift{{1e-3, 0}}; }},
        {"friction.mu", [](ContactProblem& p) { p.friction->mu.assign(p.grid.size(), 0.3); }},
        {"friction.kinetic",
         [](ContactProblem& p) { p.friction->kinetic = KineticFriction{.mu = 0.1, .slip_velocity = 1}; }},
        {"friction.layer", [](ContactProblem& p) { p.friction->layer = InterfacialLayer{1e-5}; }},
        {"friction.rolling.kind", [=](ContactProblem& p) { rolling(p).kind = RollingKind::transient; }},
        {"friction.rolling.force", [=](ContactProblem& p) { rolling(p).force.Fx = 1; }},
        {"friction.rolling.chi", [=](ContactProblem& p) { rolling(p).chi = 0.3; }},
        {"friction.rigid_slip",
         [](ContactProblem& p) { p.rigid_slip.x = p.rigid_slip.y = std::vector<double>(p.grid.size()); }},
        {"sheet_flexibility", [](ContactProblem& p) { p.sheet_flexibility = 1e-6; }},
        {"gap.array", [](ContactProblem& p) { p.gap = std::vector<double>(p.grid.size()); }},
        {"regions", [](ContactProblem& p) { p.regions = ContactRegions{{{{-9, 9}, {-9, 9}}}, {1}}; }},
        {"bodies", [](ContactProblem& p) { p.bodies.lower.material.G = 1000; }},
        {"ics", [](ContactProblem& p) { p.bodies.lower = Body::of(Layers{{Layer{1, G, 0.28}}, Material{G, 0.28}}); }},
    }));
    ContactProblem problem = rolling_contact();
    CHECK_NOTHROW(validate(problem));
    change(problem);
    if (std::string_view(field) == "ics") problem.gap = Paraboloid{500, 300};
    try {
        validate(problem);
        FAIL("accepted " << field);
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == field);
        CHECK_THAT(error.what(), ContainsSubstring("accuracy"));
    }
}

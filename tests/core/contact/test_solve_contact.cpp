#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include "contact/tangential/friction_law.hpp"
#include "contact_cases.hpp"
#include "contactd/error.hpp"
#include "contactd/solve_contact.hpp"
#include "operators/convolution.hpp"
#include "random_contact.hpp"
#include "support/closed_forms.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

bool has_warning(const ContactSolution& solution, const std::string& begin) {
    return std::ranges::any_of(solution.warnings, [&](const std::string& text) { return text.starts_with(begin); });
}

}  // namespace

TEST_CASE("sums of a solution are those of its arrays", "[contact]") {
    const ContactProblem problem = cattaneo_problem(12);
    const auto solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    double Fn = 0, Fx = 0;
    int contact = 0, adhesion = 0;
    for (std::size_t i = 0; i < problem.grid.size(); ++i) {
        Fn += solution.pressure[i] * problem.grid.element_area();
        Fx += solution.traction_x[i] * problem.grid.element_area();
        contact += solution.pressure[i] > 0;
        adhesion += solution.element_division[i] == ElementState::adhesion;
    }
    CHECK_THAT(solution.forces.Fn, WithinRel(Fn, 1e-12));
    CHECK_THAT(solution.forces.Fx, WithinRel(Fx, 1e-12));
    CHECK(solution.elements.contact == contact);
    CHECK(solution.elements.adhesion == adhesion);
    CHECK(solution.elements.slip == contact - adhesion);
    CHECK_THAT(solution.area.contact, WithinRel(contact * problem.grid.element_area(), 1e-12));
    CHECK_THAT(solution.area.adhesion + solution.area.slip, WithinRel(solution.area.contact, 1e-12));
    CHECK(solution.evidence.normal.seconds > 0);
    CHECK(solution.evidence.tangential->seconds > 0);
}

TEST_CASE("the force on the upper body opposes its shift", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    CHECK(solve_half_spaces(problem).forces.Fx < 0);
    problem.friction = FrictionLaw{{0.4}};
    problem.motion = Shift{{0, -0.00817}};
    CHECK(solve_half_spaces(problem).forces.Fy > 0);
}

TEST_CASE("without friction every contact element slips freely", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    SECTION("no friction given") {
        problem.friction.reset();
    }
    SECTION("coefficient of friction zero") {
        problem.friction->mu = {0};
    }
    const auto solution = solve_half_spaces(problem);
    CHECK(solution.converged());
    CHECK(solution.evidence.tangential.has_value() == problem.friction.has_value());
    CHECK(solution.elements.contact == 52);
    CHECK(solution.elements.slip == 52);
    CHECK(solution.forces.Fx == 0);
    CHECK(solution.traction_y.size() == problem.grid.size());
}

TEST_CASE("without a shift every contact element adheres", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    problem.motion = Shift{};
    const auto solution = solve_half_spaces(problem);
    CHECK(solution.converged());
    CHECK(solution.elements.adhesion == 52);
    CHECK(solution.forces.Fx == 0);
}

TEST_CASE("bodies that do not touch carry nothing", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    problem.approach = -0.001;
    const auto solution = solve_half_spaces(problem);
    CHECK(solution.converged());
    CHECK(solution.forces.Fn == 0);
    CHECK(solution.forces.Fx == 0);
    CHECK(solution.elements.contact == 0);
}

TEST_CASE("a shift along y is a shift along x rotated", "[contact]") {
    ContactProblem problem = cattaneo_problem(21);
    problem.grid = Grid::of_elements(21, 33, 0.11, 0.08);
    problem.gap = Paraboloid{40, 60};
    problem.settings.tangential.tolerance = 1e-8;
    const auto along_x = solve_half_spaces(problem);
    problem.grid = Grid::of_elements(33, 21, 0.08, 0.11);
    problem.gap = Paraboloid{60, 40};
    problem.friction = FrictionLaw{{0.4}};
    problem.motion = Shift{{0, 0.00817}};
    const auto along_y = solve_half_spaces(problem);
    CHECK_THAT(along_y.forces.Fn, WithinRel(along_x.forces.Fn, 1e-6));
    CHECK_THAT(along_y.forces.Fy, WithinRel(along_x.forces.Fx, 1e-6));
    CHECK(along_y.elements.adhesion == along_x.elements.adhesion);
    CHECK(along_y.elements.slip == along_x.elements.slip);
}

TEST_CASE("a solution is a good estimate for the same problem", "[contact]") {
    ContactProblem problem = cattaneo_problem(40);
    const auto first = solve_half_spaces(problem);
    problem.initial.pressure = first.pressure;
    problem.initial.traction_x = first.traction_x;
    problem.initial.traction_y = first.traction_y;
    const auto again = solve_half_spaces(problem);
    CHECK(again.evidence.normal.iterations == 0);
    CHECK(again.evidence.tangential->iterations < first.evidence.tangential->iterations / 2);
    CHECK_THAT(again.forces.Fx, WithinRel(first.forces.Fx, 1e-6));
}

TEST_CASE("only bodies that couple, or a slip law, need an outer loop", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    CHECK_FALSE(solve_half_spaces(problem).evidence.outer);
    problem.bodies = {{200, 0.3}, {400, 0.1}};  // (1-2nu)/G equal
    CHECK_FALSE(solve_half_spaces(problem).evidence.outer);
    problem.bodies = {{200, 0.3}, {400, 0.3}};
    CHECK(solve_half_spaces(problem).evidence.outer->converged);
    problem.friction.reset();
    CHECK_FALSE(solve_half_spaces(problem).evidence.outer);
}

TEST_CASE("invalid problems and operators of another size are refused", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    const ContactInfluence influence{
        std::make_shared<PairOperator>(half_space_pair(Grid::of_elements(9, 10, 1, 1), {200, 0.42}), 9, 10), nullptr};
    Observer observer;
    CHECK_THROWS_AS(solve_contact(problem, influence, observer), InvalidArgument);
    problem.friction->mu = {-1};
    CHECK_THROWS_AS(solve_half_spaces(problem), InvalidArgument);
}

TEST_CASE("progress of the whole computation grows from normal to tangential", "[contact]") {
    struct : Observer {
        double last_normal = -1, first_tangential = -1;
        void on_progress(const Progress& progress) override {
            if (progress.stage == "normal") last_normal = progress.fraction;
            if (progress.stage == "tangential" && first_tangential < 0) first_tangential = progress.fraction;
        }
    } observer;
    const ContactProblem problem = cattaneo_problem(16);
    solve_contact(problem, operators_of(problem, half_space_pair(problem.grid, problem.bodies.upper.material)),
                  observer);
    CHECK(observer.last_normal >= 0);
    CHECK(observer.first_tangential >= observer.last_normal);
}

TEST_CASE("the force and the approach prescribe the same contact", "[contact]") {
    ContactProblem problem = cattaneo_problem(24);
    const auto pressed = solve_half_spaces(problem);
    problem.approach.reset();
    problem.Fn = pressed.forces.Fn;
    const auto loaded = solve_half_spaces(problem);
    REQUIRE(loaded.converged());
    CHECK_THAT(loaded.approach, WithinRel(0.02, 1e-7));
    CHECK_THAT(loaded.forces.Fn, WithinRel(pressed.forces.Fn, 1e-12));
    CHECK_THAT(loaded.forces.Fx, WithinRel(pressed.forces.Fx, 1e-5));
}

TEST_CASE("bodies that do not touch carry nothing, and that is an answer", "[contact]") {
    ContactProblem problem = cattaneo_problem(8);
    SECTION("apart") {
        problem.approach = -0.01;
    }
    SECTION("no force") {
        problem.approach.reset();
        problem.Fn = 0;
    }
    SECTION("rolling apart") {
        problem.approach = -0.01;
        problem.motion = Rolling{.xi = 0.01, .phi = 1e-3};
    }
    SECTION("apart, with a slip law") {
        problem.approach = -0.01;
        problem.friction->kinetic = KineticFriction{SlipLaw::linear, 0.1, 1};
    }
    const auto solution = solve_half_spaces(problem);
    CHECK(solution.converged());
    CHECK(solution.elements.contact == 0);
    CHECK(solution.forces.Fn == 0);
    CHECK(solution.forces.Fx == 0);
    CHECK(solution.pmax == 0);
}

TEST_CASE("tractions of a step before stay where nothing moves", "[contact]") {
    ContactProblem problem = cattaneo_problem(20);
    const auto first = solve_half_spaces(problem);
    problem.previous = {first.pressure, first.traction_x, first.traction_y};
    problem.motion = Shift{};
    const auto second = solve_half_spaces(problem);
    REQUIRE(second.converged());
    CHECK_THAT(second.forces.Fx, WithinRel(first.forces.Fx, 1e-5));
    CHECK_THAT(*second.frictional_work, WithinAbs(0, 1e-6 * *first.frictional_work));
}

TEST_CASE("two small shifts end where one large one does", "[contact]") {
    ContactProblem problem = cattaneo_problem(20);
    const auto whole = solve_half_spaces(problem);
    problem.motion = Shift{{0.00817 / 2, 0}};
    const auto half = solve_half_spaces(problem);
    problem.previous = {half.pressure, half.traction_x, half.traction_y};
    const auto both = solve_half_spaces(problem);
    REQUIRE(both.converged());
    CHECK_THAT(both.forces.Fx, WithinRel(whole.forces.Fx, 2e-3));
}

TEST_CASE("rolling is steady, or becomes so", "[contact]") {
    ContactProblem problem = cattaneo_problem(16);
    problem.motion = Rolling{.xi = 4e-3, .eta = -2e-3, .phi = 1e-3};
    const auto steady = solve_half_spaces(problem);
    problem.motion = Rolling{.xi = 4e-3, .eta = -2e-3, .phi = 1e-3, .kind = RollingKind::transient, .steps = 200};
    const auto transient = solve_half_spaces(problem);
    REQUIRE(steady.converged());
    REQUIRE(transient.converged());
    CHECK_THAT(transient.forces.Fx, WithinRel(steady.forces.Fx, 1e-3));
    CHECK_THAT(transient.forces.Fy, WithinRel(steady.forces.Fy, 1e-3));
    CHECK_THAT(*transient.frictional_power, WithinRel(*steady.frictional_power, 1e-3));
}

TEST_CASE("steps in one request are those of several", "[contact]") {
    ContactProblem problem = cattaneo_problem(12);
    problem.motion = Rolling{.xi = 4e-3, .kind = RollingKind::transient, .steps = 3};
    const auto together = solve_half_spaces(problem);
    problem.motion = Rolling{.xi = 4e-3, .kind = RollingKind::transient};
    ContactSolution last;
    for (int step = 0; step < 3; ++step) {
        last = solve_half_spaces(problem);
        problem.previous = {last.pressure, last.traction_x, last.traction_y};
    }
    CHECK_THAT(together.forces.Fx, WithinRel(last.forces.Fx, 1e-5));
}

TEST_CASE("creepages are found from forces", "[contact]") {
    ContactProblem problem = cattaneo_problem(16);
    problem.motion = Rolling{.xi = 4e-3, .eta = -2e-3, .phi = 1e-3};
    const auto given = solve_half_spaces(problem);
    problem.motion = Rolling{.phi = 1e-3, .force = {given.forces.Fx, given.forces.Fy}};
    const auto found = solve_half_spaces(problem);
    REQUIRE(found.converged());
    const auto& rolling = std::get<Rolling>(*found.motion);
    CHECK_THAT(rolling.xi, WithinRel(4e-3, 1e-4));
    CHECK_THAT(rolling.eta, WithinRel(-2e-3, 1e-4));
    CHECK_THAT(found.forces.Fx, WithinRel(given.forces.Fx, 1e-5));
}

TEST_CASE("falling friction carries less than its static coefficient", "[contact]") {
    ContactProblem problem = cattaneo_problem(16);
    problem.motion = Rolling{.xi = 4e-3, .velocity = 1000};
    const auto coulomb = solve_half_spaces(problem);
    problem.friction->kinetic = KineticFriction{GENERATE(SlipLaw::linear, SlipLaw::exponential), 0.2, 2.0};
    const auto falling = solve_half_spaces(problem);
    REQUIRE(falling.converged());
    CHECK(std::abs(falling.forces.Fx) < std::abs(coulomb.forces.Fx));
    for (std::size_t i = 0; i < falling.pressure.size(); ++i) {
        const double v = 1000 * std::hypot(falling.slip_x[i], falling.slip_y[i]);
        const double traction = std::hypot(falling.traction_x[i], falling.traction_y[i]);
        if (falling.element_division[i] == ElementState::slip)
            CHECK_THAT(traction,
                       WithinRel(friction_coefficient(*problem.friction->kinetic, 0.4, v) * falling.pressure[i], 1e-4));
    }
}

TEST_CASE("friction takes work also where a solver was stopped at tractions of a wrong start", "[contact]") {
    ContactProblem problem = cattaneo_problem(20);
    const auto there = solve_half_spaces(problem);
    CHECK(*there.frictional_work > 0);
    problem.previous = {there.pressure, there.traction_x, there.traction_y};
    problem.initial.traction_x = there.traction_x;  // compares with the way there along the slip of the way back
    problem.initial.traction_y = there.traction_y;
    problem.motion = Shift{.rigid_shift = {.x = -0.00817}};
    problem.settings.tangential.max_iterations = GENERATE(1, 2, 3);
    const auto back = solve_half_spaces(problem);
    CHECK_FALSE(back.converged());
    CHECK(*back.frictional_work >= 0);
}

TEST_CASE("friction that never falls because the velocity was left out is warned of", "[contact]") {
    ContactProblem problem = cattaneo_problem(16);
    problem.friction->kinetic = KineticFriction{SlipLaw::exponential, 0.2, 500.0};
    const auto warnings = [&](const Motion& motion) {
        problem.motion = motion;
        return solve_half_spaces(problem).warnings;
    };
    REQUIRE(warnings(Rolling{.xi = 4e-3}).size() == 1);
    CHECK(warnings(Rolling{.xi = 4e-3}).front().find("friction.rolling.velocity") != std::string::npos);
    CHECK(warnings(Rolling{.xi = 4e-3, .velocity = 20000}).empty());
    REQUIRE(warnings(Shift{.rigid_shift = {.x = 0.008}}).size() == 1);
    CHECK(warnings(Shift{.rigid_shift = {.x = 0.008}}).front().find("friction.duration") != std::string::npos);
    // Friction that decreases this steeply in a step may have several solutions, which causes another warning.
    for (const std::string& warning : warnings(Shift{.rigid_shift = {.x = 0.008}, .duration = 1e-5}))
        CHECK(warning.find("hardly falls") == std::string::npos);
    CHECK(warnings(Rolling{}).empty());  // nothing slips
}

TEST_CASE("a yield stress in Pa is warned of", "[contact]") {
    const auto warned_of = [](double yield_stress) {
        ContactProblem problem = cattaneo_problem(10);
        problem.friction->layer = InterfacialLayer{.flexibility = 1e-6, .yield_stress = yield_stress};
        return has_warning(solve_half_spaces(problem), "friction.layer.yield_stress is");
    };
    const double G = cattaneo_problem(10).bodies.upper.material.G;
    CHECK(warned_of(0.5 * G));
    CHECK_FALSE(warned_of(0.05 * G));
    CHECK_FALSE(warned_of(std::numeric_limits<double>::infinity()));
}

TEST_CASE("strengths in Pa of a request of fatigue are warned of", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    Rolling rolling;
    rolling.xi = 1e-3;
    problem.motion = rolling;
    const double G = problem.bodies.upper.material.G;
    FatigueRequest request;
    request.strength =
        FatigueStrength{.name = "rail", .source = "a test", .shear_yield = 10 * G, .a_DV = 0.3, .tau_e = G};
    problem.fatigue = request;
    const ContactSolution solution = solve_half_spaces(problem);
    CHECK(has_warning(solution, "fatigue.strength.shear_yield is"));
    CHECK(has_warning(solution, "fatigue.strength.tau_e is"));
}

TEST_CASE("contact at the border of the potential contact area is warned of", "[contact]") {
    ContactProblem problem = cattaneo_problem(10);
    CHECK(solve_half_spaces(problem).warnings.empty());
    problem.approach = 0.05;
    const auto solution = solve_half_spaces(problem);
    CHECK(solution.elements.border > 0);
    REQUIRE(solution.warnings.size() == 1);
    CHECK(solution.warnings[0].find("border") != std::string::npos);
}

TEST_CASE("semi-axes stand for the paraboloid whose contact has them", "[contact]") {
    ContactProblem problem = cattaneo_problem(40);
    problem.friction.reset();
    problem.grid = Grid::of_elements(60, 50, 4.8 / 60, 2.4 / 50);
    problem.gap = SemiAxes{2, 1};
    SECTION("under a force") {
        problem.approach.reset();
        problem.Fn = 10;
    }
    SECTION("under an approach") {
        problem.approach = 0.02;
    }
    const auto solution = solve_half_spaces(problem);
    CHECK_THAT(solution.area.contact, WithinRel(2 * std::numbers::pi, 0.01));
}

TEST_CASE("simplified models answer the same request, near to the full one", "[contact]") {
    ContactProblem problem = cattaneo_problem(40);
    const auto full = solve_half_spaces(problem);
    problem.model = Model::hertz;
    Observer observer;
    const auto hertz = solve_contact(problem, {}, observer);
    CHECK_THAT(hertz.forces.Fn, WithinRel(full.forces.Fn, 1e-3));
    CHECK_THAT(hertz.forces.Fx, WithinRel(full.forces.Fx, 0.02));
    problem.motion = Rolling{.xi = 4e-3, .eta = 2e-3};
    problem.model = Model::full;
    const auto rolling = solve_half_spaces(problem);
    problem.model = Model::fastsim;
    const auto fastsim = solve_contact(problem, {}, observer);
    CHECK_THAT(fastsim.forces.Fx, WithinAbs(rolling.forces.Fx, 0.1 * 0.4 * rolling.forces.Fn));
    CHECK_THAT(fastsim.forces.Fy, WithinAbs(rolling.forces.Fy, 0.1 * 0.4 * rolling.forces.Fn));
}

TEST_CASE("what a simplified model does not know is refused by name", "[contact]") {
    const auto refused = [](const std::function<void(ContactProblem&)>& change) -> std::string {
        ContactProblem problem = cattaneo_problem(8);
        problem.model = Model::hertz;
        change(problem);
        Observer observer;
        try {
            solve_contact(problem, {}, observer);
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return "";
    };
    CHECK(refused([](ContactProblem&) {}).empty());
    CHECK(refused([](ContactProblem& p) { p.gap = Values(64, 0.0); }) == "gap");
    CHECK(refused([](ContactProblem& p) { p.gap = Paraboloid{50}; }) == "gap.paraboloid.Ry");
    CHECK(refused([](ContactProblem& p) { p.friction->mu = Values(64, 0.1); }) == "friction.mu");
    CHECK(refused([](ContactProblem& p) { p.model = Model::fastsim; }) == "friction");
    CHECK(refused([](ContactProblem& p) { p.motion = Rolling{.kind = RollingKind::transient}; }) ==
          "friction.rolling.kind");
    CHECK(refused([](ContactProblem& p) { p.previous.pressure = Values(64, 1.0); }) == "previous");
}

TEST_CASE("the Cattaneo problem is solved with bilinear tractions", "[contact]") {
    ContactProblem problem = cattaneo_problem(40);
    Ics bilinear;
    bilinear.load_shape = LoadShape::bilinear;
    problem.bodies = Bodies::of(problem.bodies.materials(), bilinear);
    const IcTable pair = half_space_pair(problem.grid, problem.bodies.upper.material, LoadShape::bilinear);
    Observer observer;

    const ContactSolution solution = solve_contact(problem, operators_of(problem, pair), observer);

    const reference::Hertz hertz = reference::hertz(problem.bodies.materials(), 50, *problem.approach);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fn, WithinRel(hertz.Fn, 2e-3));
    CHECK_THAT(solution.pmax, WithinRel(hertz.pmax, 5e-3));
    CHECK_THAT(solution.forces.Fx, WithinRel(-3.2216, 3e-3));  // compares with the limit h -> 0 with constant elements
}

TEST_CASE("rigid slip of the elements adds to that of the motion", "[contact]") {
    ContactProblem problem = cattaneo_problem(12);
    const Grid& grid = problem.grid;
    const auto solved_with = [&](const Motion& motion, const RigidSlip& slip) {
        problem.motion = motion;
        problem.rigid_slip = slip;
        return solve_half_spaces(problem);
    };
    SECTION("all of a shift") {
        const auto moved = solved_with(Shift{.rigid_shift = {0.006, -0.002}}, {});
        const auto slipped = solved_with(Shift{}, {Values(grid.size(), 0.006), Values(grid.size(), -0.002)});
        CHECK(slipped.traction_x == moved.traction_x);
        CHECK(slipped.slip_y == moved.slip_y);
    }
    SECTION("of rolling over the distance rolled, and beside creepages") {
        RigidSlip spin{Values(grid.size()), Values(grid.size())};
        for (int iy = 0; iy < grid.ny; ++iy)
            for (int ix = 0; ix < grid.nx; ++ix) {
                spin.x[at(grid, ix, iy)] = -2e-3 * grid.y(iy);
                spin.y[at(grid, ix, iy)] = 2e-3 * grid.x(ix);
            }
        const auto moved = solved_with(Rolling{.xi = 3e-3, .phi = 2e-3, .dq = 0.1}, {});
        const auto slipped = solved_with(Rolling{.xi = 3e-3, .dq = 0.1}, spin);
        REQUIRE(slipped.converged());
        CHECK_THAT(slipped.forces.Fx, WithinRel(moved.forces.Fx, 1e-6));
        CHECK_THAT(slipped.forces.Fy, WithinRel(moved.forces.Fy, 1e-6));
        CHECK_THAT(*slipped.frictional_power, WithinRel(*moved.frictional_power, 1e-6));
    }
    SECTION("the motion that a force takes is found beside it") {
        const auto moved = solved_with(Shift{.force = {.Fx = -3}}, {});
        const auto slipped = solved_with(Shift{.force = {.Fx = -3}}, {Values(grid.size(), 0.002), Values(grid.size())});
        const double found = std::get<Shift>(*moved.motion).rigid_shift.x;
        CHECK_THAT(slipped.forces.Fx, WithinRel(-3.0, 1e-5));
        CHECK_THAT(std::get<Shift>(*slipped.motion).rigid_shift.x, WithinRel(found - 0.002, 1e-3));
    }
    SECTION("of a field that no motion makes, the friction law holds") {
        const RigidSlip field{random_values(grid.size(), 3, -0.004, 0.006),
                              random_values(grid.size(), 4, -0.004, 0.004)};
        for (const Motion& motion : {Motion{Shift{.rigid_shift = {.x = 0.001}}}, Motion{Rolling{.xi = 1e-3}}}) {
            const auto solution = solved_with(motion, field);
            REQUIRE(solution.converged());
            CHECK(contact_faults(problem, solution, {}, 1e-4) == "");
        }
    }
    SECTION("of rolling one that is a length is warned of") {
        const auto slipped = solved_with(Rolling{.xi = 1e-3}, {Values(grid.size(), 3.0), Values(grid.size(), 4.0)});
        REQUIRE(slipped.warnings.size() == 1);
        CHECK(slipped.warnings[0].find("friction.rigid_slip is up to 5") == 0);
        CHECK(solved_with(Shift{}, {Values(grid.size(), 3.0), Values(grid.size(), 4.0)}).warnings.empty());
    }
    SECTION("what does not fit is refused by name") {
        problem.rigid_slip = {Values(3), Values(grid.size())};
        CHECK_THROWS_AS(solve_half_spaces(problem), InvalidArgument);
        problem.rigid_slip = {Values(grid.size()), {}};
        CHECK_THROWS_AS(solve_half_spaces(problem), InvalidArgument);
    }
}

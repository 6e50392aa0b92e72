// Tests operators that are kept between solves, including those larger than the budget.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <string>

#include "engine/engine.hpp"

using namespace contactd;
using namespace contactd::engine;

namespace {

ContactProblem problem_of(int n) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, 6.0 / n, 6.0 / n);
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    problem.gap = Paraboloid{400, 400};
    problem.Fn = 5000;
    return problem;
}

EngineSettings with_budget(std::size_t budget) {
    EngineSettings settings;
    settings.influence_budget_bytes = budget;
    return settings;
}

bool warns(const ContactSolution& solution) {
    for (const std::string& warning : solution.warnings)
        if (warning.find("store.influence_budget_bytes") != std::string::npos) return true;
    return false;
}

}  // namespace

TEST_CASE("Operators within the budget are cached and not reported") {
    Engine engine(with_budget(1 << 28));
    Observer observer;
    for (int solve = 0; solve < 2; ++solve) {
        const SolveReply reply = engine.solve(problem_of(12), observer);
        CHECK_FALSE(reply.operators);
        CHECK_FALSE(warns(reply.solution));
    }
    CHECK(engine.influences().usage().entries == 1);
}

TEST_CASE("Operators beyond the budget are cached while they are in use, and reported") {
    const std::size_t budget = influence_bytes(problem_of(12).grid, problem_of(12).bodies);
    Engine engine(with_budget(budget));
    Observer observer;
    const SolveReply first = engine.solve(problem_of(40), observer);
    REQUIRE(first.operators);
    CHECK(first.operators->made);
    CHECK(first.operators->bytes > budget);
    CHECK(first.operators->budget_bytes == budget);
    CHECK(warns(first.solution));
    // A small problem is solved alternately with it.
    CHECK_FALSE(warns(engine.solve(problem_of(11), observer).solution));
    const SolveReply again = engine.solve(problem_of(40), observer);
    REQUIRE(again.operators);
    CHECK_FALSE(again.operators->made);
    CHECK_FALSE(warns(again.solution));
    CHECK(again.solution.pressure == first.solution.pressure);
    CHECK(engine.influences().usage().entries == 2);
    CHECK(engine.influences().usage().bytes > again.operators->bytes);
}

TEST_CASE("The operators used last are cached beyond the budget") {
    Engine engine(with_budget(1));
    Observer observer;
    for (const int n : {12, 14, 12}) CHECK(engine.solve(problem_of(n), observer).operators->made);
    CHECK_FALSE(engine.solve(problem_of(12), observer).operators->made);
    CHECK(engine.influences().usage().entries == 1);
}

TEST_CASE("Operators of bodies that creep are those of their speed") {
    Engine engine(with_budget(1 << 28));
    Observer observer;
    ContactProblem problem = problem_of(12);
    problem.bodies.upper.viscoelastic = Viscoelasticity{1, 1e-3};
    problem.friction = FrictionLaw{{0.3}};
    const auto rolled = [&](double velocity, double tau = 1e-3) {
        problem.motion = Rolling{.xi = 1e-3, .velocity = velocity};
        problem.bodies.upper.viscoelastic->tau = tau;
        return engine.solve(problem, observer).solution;
    };
    const ContactSolution slow = rolled(500), fast = rolled(2000);
    CHECK(fast.pmax > 1.01 * slow.pmax);
    CHECK(engine.influences().usage().entries == 2);
    CHECK(rolled(500).pressure == slow.pressure);
    CHECK(rolled(1000, 5e-4).pressure == slow.pressure);  // equal law of creep
    CHECK(engine.influences().usage().entries == 2);
}

TEST_CASE("The steps of bodies that creep follow their speed") {
    Engine engine(with_budget(1 << 28));
    Observer observer;
    ContactProblem problem = problem_of(12);
    for (Body* body : {&problem.bodies.upper, &problem.bodies.lower}) body->viscoelastic = Viscoelasticity{1, 1e-3};
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = Rolling{.xi = 1e-3, .velocity = 500};
    const auto steps = engine.open(SessionSpec{problem, problem}, observer);
    for (const double velocity : {500.0, 2000.0, 500.0}) {
        const auto faster = [&](const std::optional<Motion>&, ContactProblem& step) {
            std::get<Rolling>(step.motion).velocity = velocity;
        };
        std::get<Rolling>(problem.motion).velocity = velocity;
        CHECK(std::abs(engine.solve(*steps, steps->start(), faster, observer).pmax /
                           engine.solve(problem, observer).solution.pmax -
                       1) < 1e-9);
    }
}

TEST_CASE("The steps of a simulation tell of operators beyond the budget once") {
    Engine engine(with_budget(1));
    Observer observer;
    const ContactProblem problem = problem_of(12);
    const auto steps = engine.open(SessionSpec{problem, problem}, observer);
    StepState state = steps->start();
    const auto step = [&] {
        ContactSolution solution =
            engine.solve(*steps, state, [](const std::optional<Motion>&, ContactProblem&) {}, observer);
        state = ContactSteps::after(state, ContactSolution(solution));
        return solution;
    };
    CHECK(warns(step()));
    CHECK_FALSE(warns(step()));
}

TEST_CASE("Wheels on rails tell of operators beyond the budget") {
    Engine engine(with_budget(1));
    Observer observer;
    WheelRailSetup setup;
    setup.dx = setup.dy = 1;
    WheelRailState state;
    state.Fz = 8e4;
    state.velocity.x = 3e4;
    const WheelRailSolution solution = engine.solve(setup, state, observer);
    REQUIRE(solution.patches.size() == 1);
    CHECK(warns(solution.patches.front().solution));
}

TEST_CASE("Operators beyond the budget are forgotten after a minute without use") {
    using Clock = InfluenceCache::Clock;
    constexpr auto minute = InfluenceCache::longest_unused;
    Engine engine(with_budget(1));
    Observer observer;
    CHECK(engine.forget_unused(Clock::now()) == Clock::time_point::max());
    const auto before = Clock::now();
    CHECK(warns(engine.solve(problem_of(12), observer).solution));
    const auto due = engine.forget_unused(before);
    CHECK(due >= before + minute);
    CHECK(due <= Clock::now() + minute);
    CHECK(engine.influences().usage().entries == 1);
    CHECK(engine.forget_unused(due) == Clock::time_point::max());
    CHECK(engine.influences().usage().entries == 0);
    CHECK(engine.influences().usage().bytes == 0);
    CHECK(warns(engine.solve(problem_of(12), observer).solution));
}

TEST_CASE("Operators beyond the budget are kept while a simulation has them") {
    using Clock = InfluenceCache::Clock;
    constexpr auto minute = InfluenceCache::longest_unused;
    Engine engine(with_budget(1));
    Observer observer;
    const ContactProblem problem = problem_of(12);
    auto steps = engine.open(SessionSpec{problem, problem}, observer);
    engine.solve(*steps, steps->start(), [](const std::optional<Motion>&, ContactProblem&) {}, observer);
    const auto late = Clock::now() + 10 * minute;
    CHECK(engine.forget_unused(late) == late + minute);
    CHECK(engine.influences().usage().entries == 1);
    steps.reset();
    CHECK(engine.forget_unused(late + minute) == Clock::time_point::max());
    CHECK(engine.influences().usage().entries == 0);
}

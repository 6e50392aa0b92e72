// Compares the cost of a step in process by contactd.h, by the engine, and by the solver alone.
//
// The problem is steady rolling on 25 x 25 elements with a creepage that varies up and down by 5 %, by full theory and
// by FASTSIM. Each step starts from the end of the previous one.
#include <benchmark/benchmark.h>

#include <stdexcept>
#include <utility>

#include "contactd.h"
#include "contactd/half_space.hpp"
#include "contactd/solve_contact.hpp"
#include "engine/engine.hpp"

using namespace contactd;

namespace {

constexpr int n = 25;
constexpr double dx = 13.2 / n, dy = 8.8 / n;

double creepage(int step) {
    return step % 2 == 0 ? 0.002 : 0.0021;
}

Rolling rolling(int step) {
    return {.xi = creepage(step), .eta = 0.001, .phi = 1e-4};
}

ContactProblem problem_of(Model model) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(n, n, dx, dy);
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    problem.model = model;
    problem.gap = SemiAxes{6, 4};
    problem.Fn = 50000;
    problem.friction = FrictionLaw{.mu = {0.3}};
    problem.motion = rolling(0);
    return problem;
}

Model model_of(const benchmark::State& state) {
    return state.range(0) == 0 ? Model::full : Model::fastsim;
}

// Runs the solver alone, with existing operators and the tractions of the previous step.
void solver(benchmark::State& state) {
    ContactProblem problem = problem_of(model_of(state));
    Observer observer;
    ContactInfluence influence;
    if (problem.model == Model::full) {
        const IcSpec spec{Ics{}, problem.bodies.upper.material, dx, dy, n, n};
        const IcTable table = half_space_table(spec);
        influence = make_influence(problem, table, table);
    }
    int step = 0;
    for (auto _ : state) {
        problem.motion = rolling(++step);
        ContactSolution solution = solve_contact(problem, influence, observer);
        benchmark::DoNotOptimize(solution.forces);
        if (problem.model == Model::full)
            problem.previous = problem.initial = {std::move(solution.pressure), std::move(solution.traction_x),
                                                  std::move(solution.traction_y)};
    }
}

void check(std::int32_t code, const void* handle) {
    if (code != CONTACTD_OK) throw std::runtime_error(contactd_last_error(handle));
}

void c_step(benchmark::State& state) {
    contactd_connection* connection;
    contactd_contact* contact;
    check(contactd_open("local", &connection), nullptr);
    check(contactd_new(connection, &contact), connection);
    const std::pair<const char*, double> inputs[] = {
        {"grid.nx", n},
        {"grid.ny", n},
        {"grid.dx", dx},
        {"grid.dy", dy},
        {"bodies.upper.G", 82000},
        {"bodies.upper.nu", 0.28},
        {"gap.semi_axes.a", 6},
        {"gap.semi_axes.b", 4},
        {"Fn", 50000},
        {"friction.mu", 0.3},
        {"friction.rolling.xi", creepage(0)},
        {"friction.rolling.eta", 0.001},
        {"friction.rolling.phi", 1e-4},
    };
    for (const auto& [path, value] : inputs) check(contactd_set(contact, path, value), contact);
    check(contactd_set_word(contact, "model", model_of(state) == Model::full ? "full" : "fastsim"), contact);
    check(contactd_start(contact), contact);
    std::int32_t xi;
    check(contactd_path(contact, "friction.rolling.xi", &xi), contact);
    int step = 0;
    double forces[4];
    for (auto _ : state) {
        check(contactd_set_at(contact, xi, creepage(++step)), contact);
        check(contactd_step(contact), contact);
        check(contactd_get_array(contact, "forces", forces, 4), contact);
        benchmark::DoNotOptimize(forces);
    }
    contactd_free(contact);
    contactd_close(connection);
}

void engine_step(benchmark::State& state) {
    engine::Engine engine({});
    Observer observer;
    const ContactProblem problem = problem_of(model_of(state));
    const auto steps = engine.open({problem, problem}, observer);
    engine::StepState here = steps->start();
    StepInput input;
    int step = 0;
    for (auto _ : state) {
        input.motion = rolling(++step);
        const auto overlay = [&](const std::optional<Motion>& last, ContactProblem& stated) {
            engine::overlay(input, last, stated);
        };
        ContactSolution solution = engine.solve(*steps, here, overlay, observer);
        benchmark::DoNotOptimize(solution.forces);
        here = engine::ContactSteps::after(here, std::move(solution));
    }
}

}  // namespace

BENCHMARK(solver)->ArgName("fastsim")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);
BENCHMARK(engine_step)->ArgName("fastsim")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);
BENCHMARK(c_step)->ArgName("fastsim")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

BENCHMARK_MAIN();

// Compares steady rolling on a longitudinally uniform body, by strips, with that on half-spaces. The problem is an
// elliptic contact on nx x ny elements. The lower body is a half-space, or a rail head with strips across its top.
// Counter ratio is the median time of a solve, or a product, with strips over that of an alternating one with
// half-spaces.
#include <utility>

#include "contact_cases.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/rotated_strips.hpp"
#include "contactd/strip_frames.hpp"

namespace {

using namespace contactd;
using bench::Values;

struct Rolled {
    static constexpr Material steel{41000, 0.28};  // on a rigid body, equivalent to two steel bodies
    static constexpr double Fn = 50000;

    ContactProblem problem;
    ContactInfluence half_spaces, strips;
    Values bound;
    RigidSlip rigid;
    mutable Observer observer;

    Rolled(int nx, int ny) {
        const Grid grid = Grid::of_elements(nx, ny, 13.2 / nx, 8.8 / ny);
        problem.grid = grid;
        problem.bodies = {{Material::rigid()}, {steel}};
        problem.friction = FrictionLaw{{0.3}};
        problem.motion = Rolling{.xi = 0.002, .eta = 0.001, .phi = 1e-4, .dq = grid.dx};
        IcSpec spec;
        spec.material = steel;
        spec.dx = grid.dx;
        spec.dy = grid.dy;
        spec.nx = grid.nx;
        spec.ny = grid.ny;
        half_spaces = make_influence(problem, BodyTable(IcTable(nx, ny)), BodyTable(half_space_table(spec)));

        Ics ics;
        ics.body = BodyShape::longitudinally_uniform;
        ics.section = Section{RailSection{.from = -0.5 * grid.ny * grid.dy}};
        problem.bodies.lower.ics = ics;
        problem.columns = ContactColumns{.frames = strip_frames(*ics.section, grid.ny, grid.dy)};
        Grid longer = grid;
        ++longer.nx;  // for the shift of a step
        strips = make_influence(problem, BodyTable(StripTable()),
                                BodyTable(rotated_strips(*ics.section, longer, steel, LoadShape::constant)));

        const Values distance = sampled(radii_of_force({6, 4}, (1 - steel.nu) / steel.G / 2, Fn), grid);
        bound = solve_normal_force(*half_spaces.current, distance, Fn / grid.element_area(), {}, {}, observer).pressure;
        for (double& g : bound) g *= 0.3;
        rigid = rigid_slip(grid, std::get<Rolling>(problem.motion), grid.dx);
    }

    RollingSolution steady(const ContactInfluence& influence) const {
        const RollingBodies bodies{*influence.current, *influence.increment, problem.grid, problem.grid.dx, 0};
        return solve_steady_rolling(bodies, bound, rigid.x, rigid.y, {}, {}, {}, observer);
    }
};

/// Calls run(influence) with half-spaces and with strips, alternately.
template <class Run>
void compare(benchmark::State& state, const Run& run) {
    const Rolled rolled(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    run(rolled, rolled.half_spaces);
    run(rolled, rolled.strips);
    std::vector<double> flat, curved;
    for (auto _ : state) {
        const double start = bench::processor_seconds();
        run(rolled, rolled.half_spaces);
        const double middle = bench::processor_seconds();
        run(rolled, rolled.strips);
        flat.push_back(middle - start);
        curved.push_back(bench::processor_seconds() - middle);
    }
    state.counters["ratio"] = bench::median(curved) / bench::median(flat);
}

void steady_rolling(benchmark::State& state) {
    int iterations[2] = {};
    bool converged = true;
    compare(state, [&](const Rolled& rolled, const ContactInfluence& influence) {
        const SolverEvidence evidence = rolled.steady(influence).evidence;
        iterations[&influence == &rolled.strips] = evidence.iterations;
        converged = converged && evidence.converged;
    });
    state.counters["iterations"] = iterations[1];
    state.counters["iterations_half_space"] = iterations[0];
    if (!converged) state.SkipWithError("the solver did not converge");
}

void change_product(benchmark::State& state) {
    compare(state, [](const Rolled& rolled, const ContactInfluence& influence) {
        Values ux(rolled.bound.size()), uy(ux);
        influence.increment->tangential(rolled.bound, rolled.bound, ux, uy);
    });
}

void normal_product(benchmark::State& state) {
    compare(state, [](const Rolled& rolled, const ContactInfluence& influence) {
        Values u(rolled.bound.size());
        influence.current->normal(rolled.bound, u);
    });
}

void coupled_product(benchmark::State& state) {
    compare(state, [](const Rolled& rolled, const ContactInfluence& influence) {
        Values ux(rolled.bound.size()), uy(ux);
        influence.current->tangential_of_normal(rolled.bound, ux, uy);
    });
}

void sizes(benchmark::internal::Benchmark* rows) {
    rows->ArgNames({"nx", "ny"})->Args({51, 39})->Args({100, 80})->Unit(benchmark::kMicrosecond);
}

BENCHMARK(steady_rolling)->Apply(sizes);
BENCHMARK(change_product)->Apply(sizes);
BENCHMARK(normal_product)->Apply(sizes);
BENCHMARK(coupled_product)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();

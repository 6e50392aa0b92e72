// The contact solvers on the paper's Cattaneo problem (section 4), n x n elements over the same window, cold starts.
// Counter A_p: time of the row in products A p (one scalar convolution), measured in the same run.
#include <benchmark/benchmark.h>

#include <ctime>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/convolution.hpp"
#include "contactd/half_space.hpp"
#include "contactd/normal.hpp"
#include "contactd/tangential.hpp"

namespace {

using namespace contactd;
using Values = std::vector<double>;
// Processor time, so that a busy machine does not spoil the ratio of a solve to a product.
double seconds_since(std::clock_t start) {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

IcSpec spec_of(int n) {
    IcSpec spec;
    spec.material = {200, 0.42};
    spec.dx = spec.dy = 2.4 / n;
    spec.nx = spec.ny = n;
    return spec;
}

struct Cattaneo {
    IcTable pair;
    ConvolutionOperator influence;
    Values gap, bound, shift_x, shift_y;
    Observer observer;

    explicit Cattaneo(int n) : pair(make_pair(n)), influence(pair, n, n) {
        gap = paraboloid(Grid::centred(n, n, 2.4 / n, 2.4 / n), 50, 50);
        for (double& h : gap) h -= 0.02;
        shift_x.assign(gap.size(), 0.00817);
        shift_y.assign(gap.size(), 0);
        bound = solve_normal(influence, gap, {}, {}, observer).pressure;
        for (double& g : bound) g *= 0.4;
    }

    NormalSolution normal() { return solve_normal(influence, gap, {}, {}, observer); }
    TangentialSolution tangential() {
        return solve_tangential(influence, bound, shift_x, shift_y, {}, {}, {}, observer);
    }

    // Seconds of one product.
    double product_seconds() const {
        Values u(bound.size());
        const std::size_t repeats = 2'000'000 / bound.size();
        const std::clock_t start = std::clock();
        for (std::size_t repeat = 0; repeat < repeats; ++repeat) influence.normal(bound, u);
        return seconds_since(start) / static_cast<double>(repeats);
    }

    static IcTable make_pair(int n) {
        const IcTable body = half_space_table(spec_of(n));
        return pair_of(body, body);
    }
};

template <class Solve>
void run_solver(benchmark::State& state, const Solve& solve) {
    Cattaneo problem(static_cast<int>(state.range(0)));
    SolverEvidence evidence = solve(problem);  // makes the coarser grids
    const double before = problem.product_seconds();
    double seconds = 0;
    for (auto _ : state) {
        const auto start = std::clock();
        evidence = solve(problem);
        seconds += seconds_since(start);
    }
    const double product = 0.5 * (before + problem.product_seconds());
    state.counters["A_p"] = seconds / static_cast<double>(state.iterations()) / product;
    state.counters["solver_iterations"] = evidence.iterations;
    if (!evidence.converged) state.SkipWithError("the solver did not converge");
}

void A_p(benchmark::State& state) {
    const Cattaneo problem(static_cast<int>(state.range(0)));
    Values u(problem.bound.size());
    for (auto _ : state) problem.influence.normal(problem.bound, u);
}

void A_p_tangential(benchmark::State& state) {
    const Cattaneo problem(static_cast<int>(state.range(0)));
    Values ux(problem.bound.size()), uy(ux);
    for (auto _ : state) problem.influence.tangential(problem.bound, problem.bound, ux, uy);
}

void precondition(benchmark::State& state) {
    const Cattaneo problem(static_cast<int>(state.range(0)));
    Values z(problem.bound.size());
    for (auto _ : state) problem.influence.precondition(Axis::z, problem.bound, z);
}

void NORM(benchmark::State& state) {
    run_solver(state, [](Cattaneo& problem) { return problem.normal().evidence; });
}

void TangCG(benchmark::State& state) {
    run_solver(state, [](Cattaneo& problem) { return problem.tangential().evidence; });
}

void closed_form_table(benchmark::State& state) {
    const IcSpec spec = spec_of(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(half_space_table(spec));
}

void convolution_operator(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    const IcTable pair = Cattaneo::make_pair(n);
    for (auto _ : state) benchmark::DoNotOptimize(ConvolutionOperator(pair, n, n));
}

void sizes(benchmark::internal::Benchmark* rows) {
    rows->ArgName("n")->Arg(40)->Arg(160)->Arg(320)->Unit(benchmark::kMicrosecond);
}

BENCHMARK(A_p)->Apply(sizes);
BENCHMARK(A_p_tangential)->Apply(sizes);
BENCHMARK(precondition)->Apply(sizes);
BENCHMARK(NORM)->Apply(sizes);
BENCHMARK(TangCG)->Apply(sizes);
BENCHMARK(closed_form_table)->Apply(sizes);
BENCHMARK(convolution_operator)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();

// Measures products and the contact solvers on the paper's Cattaneo problem (section 4), with n x n elements over the
// same window. Counter A_p is the time of the row in products A p (one scalar convolution), measured in the same run.
#include "contact_cases.hpp"
#include "contactd/closed_form_record.hpp"

namespace {

using namespace contactd;
using bench::Cattaneo;
using bench::Values;

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

void precondition_tangential(benchmark::State& state) {
    const Cattaneo problem(static_cast<int>(state.range(0)));
    Values zx(problem.bound.size()), zy(zx);
    for (auto _ : state) problem.influence.precondition_tangential(problem.bound, problem.bound, zx, zy);
}

void NORM(benchmark::State& state) {
    const Cattaneo problem(static_cast<int>(state.range(0)));
    bench::count_in_products(state, problem.influence, [&] { return problem.normal().evidence; });
}

void NORM_force(benchmark::State& state) {
    const Cattaneo problem(static_cast<int>(state.range(0)));
    bench::count_in_products(state, problem.influence, [&] { return problem.normal_force().evidence; });
}

void TangCG(benchmark::State& state) {
    const Cattaneo problem(static_cast<int>(state.range(0)));
    bench::count_in_products(state, problem.influence, [&] { return problem.tangential().evidence; });
}

// Starts from the solution of shifts and a rotation 5 % smaller. With `rotated`, the shift along y and the rotation
// decrease instead.
void TangCG_warm(benchmark::State& state) {
    const Cattaneo problem(static_cast<int>(state.range(0)));
    const double sideways = state.range(1) != 0 ? 0.95 : 1.05;
    const TangentialSolution last = problem.tangential(0.0077, 0.002, 0.001);
    bench::count_in_products(state, problem.influence, [&] {
        return problem.tangential(0.0077 * 1.05, 0.002 * sideways, 0.001 * sideways, last).evidence;
    });
}

void closed_form_table(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    const Grid grid = Grid::of_elements(n, n, 2.4 / n, 2.4 / n);
    for (auto _ : state) benchmark::DoNotOptimize(bench::pair_table(grid, {200, 0.42}));
}

// Computes the table of three layers, with its estimated errors.
void layers_table(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    IcSpec spec;
    spec.body = BodyShape::layered;
    spec.layered = Layers{{{0.3, 3, 0.2}, {0.8, 0.5, 0.5}, {1.5, 8, 0.33}}, {1, 0.28}};
    spec.material = spec.layered->surface();
    spec.dx = spec.dy = 2.4 / n;
    spec.nx = spec.ny = n;
    for (auto _ : state) benchmark::DoNotOptimize(closed_form_record(spec));
}

void convolution_operator(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    const IcTable pair = bench::pair_table(Grid::of_elements(n, n, 2.4 / n, 2.4 / n), {200, 0.42});
    for (auto _ : state) benchmark::DoNotOptimize(ConvolutionOperator(pair, n, n));
}

void sizes(benchmark::internal::Benchmark* rows) {
    rows->ArgName("n")->Arg(40)->Arg(160)->Arg(320)->Unit(benchmark::kMicrosecond);
}

BENCHMARK(A_p)->Apply(sizes);
BENCHMARK(A_p_tangential)->Apply(sizes);
BENCHMARK(precondition)->Apply(sizes);
BENCHMARK(precondition_tangential)->Apply(sizes);
BENCHMARK(NORM)->Apply(sizes);
BENCHMARK(NORM_force)->Apply(sizes);
BENCHMARK(TangCG)->Apply(sizes);
BENCHMARK(TangCG_warm)
    ->ArgNames({"n", "rotated"})
    ->ArgsProduct({{40, 160, 320}, {0, 1}})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(closed_form_table)->Apply(sizes);
BENCHMARK(layers_table)->Apply(sizes);
BENCHMARK(convolution_operator)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();

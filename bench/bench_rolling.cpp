// Measures rolling on the elliptic contact of the reference values, with n x n elements.
// Counter A_p is the time of the row in products A p (one scalar convolution), measured in the same run.
#include "contact_cases.hpp"

namespace {

using namespace contactd;
using bench::Elliptic;
using bench::Values;

void steady_cold(benchmark::State& state) {
    const Elliptic problem(static_cast<int>(state.range(0)));
    const RigidSlip w = problem.rigid();
    bench::count_in_products(state, problem.influence, [&] { return problem.steady(w).evidence; });
}

// Starts from the solution for creepages 5 % smaller; with `rotated`, lateral creepage and spin were larger instead.
void steady_warm(benchmark::State& state) {
    const Elliptic problem(static_cast<int>(state.range(0)));
    const double sideways = state.range(1) != 0 ? 0.95 : 1.05;
    const RollingSolution last = problem.steady(problem.rigid());
    const RigidSlip w = problem.rigid(1.05, sideways, sideways);
    bench::count_in_products(state, problem.influence, [&] { return problem.steady(w, last).evidence; });
}

void transient_step(benchmark::State& state) {
    const Elliptic problem(static_cast<int>(state.range(0)));
    const RollingSolution last = problem.steady(problem.rigid());
    const RigidSlip w = problem.rigid(1.05, 1.05, 1.05);
    bench::count_in_products(state, problem.influence, [&] { return problem.transient(w, last).evidence; });
}

void A_p(benchmark::State& state) {
    const Elliptic problem(static_cast<int>(state.range(0)));
    Values u(problem.bound.size());
    for (auto _ : state) problem.influence.normal(problem.bound, u);
}

void change_product(benchmark::State& state) {
    const Elliptic problem(static_cast<int>(state.range(0)));
    Values ux(problem.bound.size()), uy(ux);
    for (auto _ : state) problem.change.tangential(problem.bound, problem.bound, ux, uy);
}

void sizes(benchmark::internal::Benchmark* rows) {
    rows->ArgName("n")->Arg(25)->Arg(50)->Arg(100)->Arg(200)->Unit(benchmark::kMicrosecond);
}

BENCHMARK(A_p)->Apply(sizes);
BENCHMARK(change_product)->Apply(sizes);
BENCHMARK(steady_cold)->Apply(sizes);
BENCHMARK(steady_warm)
    ->ArgNames({"n", "rotated"})
    ->ArgsProduct({{25, 50, 100, 200}, {0, 1}})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(transient_step)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();

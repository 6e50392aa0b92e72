// Measures the cost for n x n elements from 16 to 640, which docs/performance.png shows (./dev bench --plot).
#include "contact_cases.hpp"

namespace {

using namespace contactd;
using bench::Values;

void A_p(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    const ConvolutionOperator influence(bench::pair_table(Grid::of_elements(n, n, 2.4 / n, 2.4 / n), {200, 0.42}), n,
                                        n);
    const Values p(influence.size(), 1.0);
    Values u(p.size());
    for (auto _ : state) influence.normal(p, u);
}

void NORM(benchmark::State& state) {
    const bench::Cattaneo problem(static_cast<int>(state.range(0)));
    bench::count_in_products(state, problem.influence, [&] { return problem.normal().evidence; });
}

void TangCG(benchmark::State& state) {
    const bench::Cattaneo problem(static_cast<int>(state.range(0)));
    bench::count_in_products(state, problem.influence, [&] { return problem.tangential().evidence; });
}

void steady_rolling(benchmark::State& state) {
    const bench::Elliptic problem(static_cast<int>(state.range(0)));
    const RigidSlip w = problem.rigid();
    bench::count_in_products(state, problem.influence, [&] { return problem.steady(w).evidence; });
}

void sizes(benchmark::internal::Benchmark* rows) {
    rows->ArgName("n")->Unit(benchmark::kMicrosecond);
    for (const int n : {16, 20, 25, 32, 40, 50, 64, 80, 100, 128, 160, 200, 256, 320, 400, 512, 640}) rows->Arg(n);
}

BENCHMARK(A_p)->Apply(sizes);
BENCHMARK(NORM)->Apply(sizes);
BENCHMARK(TangCG)->Apply(sizes);
BENCHMARK(steady_rolling)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();

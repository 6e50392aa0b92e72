// Measures the simplified contact models on the reference case of steady rolling (semi-axes 6 x 4 mm, 25 x 25
// elements), from zero. Counter A_p is the time of the row in products A p (one scalar convolution) on the same grid,
// measured in the same run.
#include <benchmark/benchmark.h>

#include <ctime>
#include <vector>

#include "closed_forms/hertz.hpp"
#include "closed_forms/kalker_coefficients.hpp"
#include "closed_forms/simplified/cattaneo_mindlin.hpp"
#include "closed_forms/simplified/fastsim.hpp"
#include "closed_forms/simplified/vermeulen_johnson.hpp"
#include "contactd/half_space.hpp"
#include "operators/convolution.hpp"

namespace {

using namespace contactd;

constexpr double mu = 0.3, Fn = 50000;
const Material steel{82000, 0.28};
const SemiAxes axes{6, 4};
const EllipticContact contact{axes, Fn, steel};

Grid window(int n) {
    return Grid::of_elements(n, n, 13.2 / n, 8.8 / n);
}

double seconds_of(std::clock_t ticks) {
    return static_cast<double>(ticks) / CLOCKS_PER_SEC;
}

// Returns the seconds of one product on the grid.
double product_seconds(const Grid& grid) {
    IcSpec spec;
    spec.material = steel;
    spec.dx = grid.dx;
    spec.dy = grid.dy;
    spec.nx = grid.nx;
    spec.ny = grid.ny;
    const IcTable body = half_space_table(spec);
    const ConvolutionOperator influence(pair_of(body, body), grid.nx, grid.ny);
    const std::vector<double> p(grid.size(), 1.0);
    std::vector<double> u(grid.size());
    const std::size_t repeats = 2'000'000 / grid.size() + 1;
    const std::clock_t start = std::clock();
    for (std::size_t repeat = 0; repeat < repeats; ++repeat) influence.normal(p, u);
    return seconds_of(std::clock() - start) / static_cast<double>(repeats);
}

template <class Model>
void run(benchmark::State& state, const Model& model) {
    const Grid grid = window(static_cast<int>(state.range(0)));
    const double product = product_seconds(grid);
    const std::clock_t start = std::clock();
    for (auto _ : state) benchmark::DoNotOptimize(model(grid));
    state.counters["A_p"] = seconds_of(std::clock() - start) / static_cast<double>(state.iterations()) / product;
}

Rolling creepages(double phi) {
    Rolling motion;
    motion.xi = 0.002;
    motion.eta = 0.001;
    motion.phi = phi;
    return motion;
}

void hertz(benchmark::State& state) {
    run(state, [](const Grid& grid) {
        const MaterialPair bodies{steel, steel};
        const auto found = hertz_of_semi_axes_and_force(axes, bodies.normal_compliance(), Fn);
        return hertz_pressure(grid, {{found.a, found.b}, found.Fn, combined_material(bodies)});
    });
}

void shift(benchmark::State& state) {
    Shift motion;
    motion.rigid_shift.x = 0.005;
    run(state, [&](const Grid& grid) { return cattaneo_mindlin(grid, contact, mu, motion); });
}

void rolling_without_spin(benchmark::State& state) {
    run(state, [](const Grid& grid) { return vermeulen_johnson(grid, contact, mu, creepages(0)); });
}

void rolling_fastsim(benchmark::State& state) {
    run(state, [](const Grid& grid) { return fastsim(grid, contact, mu, creepages(1e-4)); });
}

void derivatives_of_fastsim(benchmark::State& state) {
    run(state, [](const Grid&) { return fastsim_by_motion(contact, mu, creepages(1e-4)); });
}

void rolling_fastsim_by_force(benchmark::State& state) {
    Rolling motion = creepages(1e-4);
    motion.force.Fx = -0.6 * mu * Fn;
    motion.force.Fy = -0.4 * mu * Fn;
    run(state, [&](const Grid& grid) { return fastsim(grid, contact, mu, motion); });
}

void coefficients(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(kalker_coefficients(1.5, 0.28));
}

void sizes(benchmark::internal::Benchmark* rows) {
    rows->ArgName("n")->Arg(25)->Arg(160)->Unit(benchmark::kMicrosecond);
}

BENCHMARK(hertz)->Apply(sizes);
BENCHMARK(shift)->Apply(sizes);
BENCHMARK(rolling_without_spin)->Apply(sizes);
BENCHMARK(rolling_fastsim)->Apply(sizes);
BENCHMARK(derivatives_of_fastsim)->Apply(sizes);
BENCHMARK(rolling_fastsim_by_force)->Apply(sizes);
BENCHMARK(coefficients)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();

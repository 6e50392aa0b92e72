// Measures the cost of a step of the wheels of a vehicle under their loads (vehicle.hpp). Counters are the median and
// the 99th percentile of processor time per step (us). Two ratios relate the median to a product A p of 36 x 56
// elements and to a step at the resulting heights, all from one run. A step through the daemon at CONTACTD_ENDPOINT is
// compared with the same step in process, on one thread and two (us, and medians of the ratios of steps).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>

#include "contactd/wheel_rail_setup.hpp"
#include "vehicle.hpp"
#include "wheel_rail/patches/half_space_cache.hpp"

namespace {

using namespace contactd::bench;

/// Measures processor time with one thread, because other work on the machine affects it less, and otherwise
/// wall-clock time.
class Stopwatch {
   public:
    explicit Stopwatch(int threads = 1) : threads_(threads) {}
    double seconds() const {
        if (threads_ == 1) return static_cast<double>(std::clock() - processor_) / CLOCKS_PER_SEC;
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - clock_).count();
    }

   private:
    int threads_;
    std::clock_t processor_ = std::clock();
    std::chrono::steady_clock::time_point clock_ = std::chrono::steady_clock::now();
};

double time_of_step(Vehicle& vehicle, Run run, int k, int threads, const Values* at = nullptr) {
    const Stopwatch watch(threads);
    vehicle.step(run, k, threads, at);
    return watch.seconds();
}

double percentile(Values values, double share) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Measures the time (s) of the products on a patch of 36 x 56 elements.
class Product {
   public:
    Product() : p_(nx * ny, 1), u_(nx * ny) {
        contactd::ContactProblem problem;
        problem.bodies = contactd::WheelRailSetup{}.bodies;
        problem.grid = contactd::Grid::of_elements(static_cast<int>(nx), static_cast<int>(ny), 0.5, 0.5);
        influence_ = contactd::HalfSpaceCache(problem.bodies).of(problem);
    }
    double time() {
        constexpr int repeats = 20;
        const Stopwatch watch;
        for (int i = 0; i < repeats; ++i) influence_.current->normal(p_, u_);
        return watch.seconds() / repeats;
    }

   private:
    static constexpr std::size_t nx = 36, ny = 56;
    contactd::ContactInfluence influence_;
    Values p_, u_;
};

void vehicle(benchmark::State& state, const char* model, Run run, int threads, double accuracy = 0) {
    Vehicle loaded(model, accuracy), placed(model, accuracy);
    Product product;
    Values under_load, at_height, products;
    int k = 0;
    for (; k < 20; ++k) {
        loaded.step(run, k, 1);
        placed.step(run, k, 1, &loaded.heights());
    }
    for (auto _ : state) {
        under_load.push_back(time_of_step(loaded, run, k, threads));
        state.PauseTiming();
        at_height.push_back(time_of_step(placed, run, k, 1, &loaded.heights()));
        products.push_back(product.time());
        ++k;
        state.ResumeTiming();
    }
    const double median = percentile(under_load, 0.5);
    state.counters["us"] = 1e6 * median;
    state.counters["p99_us"] = 1e6 * percentile(under_load, 0.99);
    state.counters["over_product"] = median / percentile(products, 0.5);
    state.counters["over_placed"] = median / percentile(at_height, 0.5);
}

void by_daemon(benchmark::State& state, const char* model, Run run, double accuracy = 0) {
    const char* endpoint = std::getenv("CONTACTD_ENDPOINT");
    if (!endpoint) return state.SkipWithError("CONTACTD_ENDPOINT names no daemon");
    Vehicle served(model, accuracy, endpoint), on_one(model, accuracy), on_two(model, accuracy);
    Values by_message, over_one, over_two;
    int k = 0;
    const auto seconds = [&](Vehicle& vehicle, int threads) {
        const Stopwatch watch(0);  // wall-clock time
        vehicle.step(run, k, threads);
        return watch.seconds();
    };
    for (; k < 20; ++k)
        for (Vehicle* vehicle : {&served, &on_one, &on_two}) vehicle->step(run, k, 1);
    for (auto _ : state) {
        by_message.push_back(seconds(served, 0));
        state.PauseTiming();
        over_one.push_back(by_message.back() / seconds(on_one, 1));
        over_two.push_back(by_message.back() / seconds(on_two, 2));
        ++k;
        state.ResumeTiming();
    }
    state.counters["us"] = 1e6 * percentile(by_message, 0.5);
    state.counters["p99_us"] = 1e6 * percentile(by_message, 0.99);
    state.counters["over_one_thread"] = percentile(over_one, 0.5);
    state.counters["over_two_threads"] = percentile(over_two, 0.5);
}

BENCHMARK_CAPTURE(vehicle, full_hunting, "full", Run::hunting, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, full_curving, "full", Run::curving, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, full_hunting_on_two_threads, "full", Run::hunting, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, full_curving_on_two_threads, "full", Run::curving, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, full_hunting_to_1e4, "full", Run::hunting, 1, 1e-4)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, full_curving_to_1e4, "full", Run::curving, 1, 1e-4)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, full_hunting_to_1e4_on_two_threads, "full", Run::hunting, 2, 1e-4)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, full_curving_to_1e4_on_two_threads, "full", Run::curving, 2, 1e-4)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, fastsim_hunting, "fastsim", Run::hunting, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, fastsim_curving, "fastsim", Run::curving, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, fastsim_hunting_on_two_threads, "fastsim", Run::hunting, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(by_daemon, full_hunting, "full", Run::hunting)->UseRealTime()->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(by_daemon, full_curving, "full", Run::curving)->UseRealTime()->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(by_daemon, fastsim_hunting, "fastsim", Run::hunting)->UseRealTime()->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();

// Measures wheels on rails, from position and motion to forces: S1002 on 60E1 at 1/40, in contact on the tread and on
// the flange. The plain solve is that of the same patch with a known gap and creepages. Counter over_solve is the time
// of the row over that of the plain solve, measured in the same run.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

#include "contactd/solve_contact.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "geometry/position.hpp"
#include "wheel_rail/patches/half_space_cache.hpp"
#include "wheel_rail/patches/patch_solver.hpp"

namespace {

using namespace contactd;

constexpr double Fz = 80000;

WheelRailSetup wheel_on_rail(Model model, double element) {
    WheelRailSetup setup;
    setup.model = model;
    setup.dx = setup.dy = element;
    if (model == Model::hertz) setup.friction.reset();  // its closed form does not support spin, which wheels have
    return setup;
}

WheelRailState rolling(double y) {
    WheelRailState state;
    state.position.y = y;
    state.position.yaw = 2.4e-3 * y;
    state.velocity.x = 30000;
    state.velocity.pitch = -30000 / 460.0;
    return state;
}

/// Returns a state that prescribes the height at which the force is Fz.
WheelRailState at_height(const WheelRailContact& contact, double y) {
    WheelRailState state = rolling(y);
    state.Fz = Fz;
    Observer observer;
    state.position.z = contact.solve(state, observer).z;
    state.Fz.reset();
    return state;
}

double seconds_of(const std::function<void()>& work, std::int64_t repeats) {
    const auto start = std::chrono::steady_clock::now();
    for (std::int64_t repeat = 0; repeat < repeats; ++repeat) work();
    const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
    return duration.count() / static_cast<double>(repeats);
}

/// Element size (mm) for fast models, where elements only affect the pictures.
constexpr double coarse = 0.5;

void search(benchmark::State& state) {
    const WheelRailContact contact(wheel_on_rail(Model::full, 0.2));
    const WheelRailState wheel = at_height(contact, static_cast<double>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(contact.locate(wheel));
}

void step(benchmark::State& state, Model model, bool by_force) {
    const WheelRailContact contact(wheel_on_rail(model, coarse));
    WheelRailState wheel = at_height(contact, static_cast<double>(state.range(0)));
    if (by_force) wheel.Fz = Fz;
    Observer observer;
    for (auto _ : state) benchmark::DoNotOptimize(contact.solve(wheel, observer));
}

/// Measures the full theory, with about 60 x 60 elements in the patch.
void full(benchmark::State& state) {
    const WheelRailSetup setup = wheel_on_rail(Model::full, state.range(0) == 0 ? 0.23 : 0.2);
    const WheelRailContact contact(setup);
    const WheelRailState wheel = at_height(contact, static_cast<double>(state.range(0)));
    const geometry::Profiles profiles = geometry::make_profiles(setup);
    const geometry::Position position(setup, profiles, wheel);
    HalfSpaceCache cache(setup.bodies);
    std::vector<ContactProblem> problems;
    std::vector<ContactInfluence> influences;
    double elements = 0;
    for (geometry::CandidatePatch& found : position.candidates(wheel.position.height())) {
        position.measure(found, wheel.position.height());
        problems.push_back(problem_of(setup, wheel, found, position.rail()));
        influences.push_back(cache.of(problems.back()));
        elements += static_cast<double>(found.place.grid.size());
    }
    Observer observer;
    const auto plain = [&] {
        for (std::size_t i = 0; i < problems.size(); ++i)
            benchmark::DoNotOptimize(solve_contact(problems[i], influences[i], observer));
    };
    // Both alternate, so that other work on the machine affects them equally.
    double of_step = 0, of_plain = 0;
    for (auto _ : state) {
        of_step += seconds_of([&] { benchmark::DoNotOptimize(contact.solve(wheel, observer)); }, 1);
        state.PauseTiming();
        of_plain += seconds_of(plain, 1);
        state.ResumeTiming();
    }
    state.counters["elements"] = elements;
    state.counters["over_solve"] = of_step / of_plain;
}

// Adds rows for lateral shifts of the wheelset (mm): tread, and two contacts or the flange.
void shifts(benchmark::internal::Benchmark* rows) {
    rows->ArgName("y")->Arg(0)->Arg(4)->Arg(8)->Unit(benchmark::kMicrosecond);
}

BENCHMARK(search)->Apply(shifts);
BENCHMARK_CAPTURE(step, hertz_at_z, Model::hertz, false)->Apply(shifts);
BENCHMARK_CAPTURE(step, hertz_under_Fz, Model::hertz, true)->Apply(shifts);
BENCHMARK_CAPTURE(step, fastsim_at_z, Model::fastsim, false)->Apply(shifts);
BENCHMARK_CAPTURE(step, fastsim_under_Fz, Model::fastsim, true)->Apply(shifts);
BENCHMARK(full)->Apply(shifts);

}  // namespace

BENCHMARK_MAIN();

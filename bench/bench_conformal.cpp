// Compares conformal contact of S1002 on 60E1, in steps along y, with planar contact at the same places: on a rail, on
// a rail by slices, and on a roller. A session of each makes alternating steps. Counter over_plane is the processor
// time of the conformal steps over that of the planar ones, cpu_ms that of a conformal step. Counters elements, Fx and
// Fy are the elements and forces (N) of the last patch.
#include <benchmark/benchmark.h>

#include <chrono>
#include <ctime>

#include "contactd/make_profile.hpp"
#include "contactd/solve_wheel_rail.hpp"

namespace {

using namespace contactd;

struct Place {
    double Fz;
    double y, step;  ///< start and spacing of the steps (mm)
    int steps;       ///< processor time of an iteration
};

constexpr Place gauge_corner{10'000, 6.2, 0.05, 12}, gauge_corner_slowly{10'000, 6.2, 0.0005, 12},
    flange_root{80'000, 6.6, 0.05, 4};

enum class Under { rail, slices, roller };  ///< inputs of the wheel

constexpr double roller_radius = 1000;

/// The slices rise by 1 mm over a metre, and lie where the gauge places the rail at x = 0.
WheelRailContact contact_of(Conformal conformal, double element, Under under) {
    WheelRailSetup setup;
    setup.dx = setup.dy = element;
    setup.conformal = conformal;
    if (under == Under::roller) setup.track.roller_radius = roller_radius;
    if (under == Under::slices) {
        const ProfileFrame frame = WheelRailContact(setup).locate({}).rail_frame;
        setup.track.rail_origin = ProfilePoint{frame.y, frame.z};
        const ProfileCurve curve = make_profile(setup.rail).curve;
        for (int i = -2; i <= 2; ++i) {
            ProfilePoints lifted{{curve.points().begin(), curve.points().end()}};
            for (ProfilePoint& point : lifted.points) point.z -= 0.5 * i;
            setup.rail_slices.push_back({500.0 * i, {ProfileKind::rail, lifted}});
        }
    }
    return WheelRailContact(setup);
}

WheelRailState at(const Place& place, int step, Under under) {
    constexpr double speed = 30'000;
    WheelRailState state;
    state.Fz = place.Fz;
    state.position.y = place.y + place.step * step;
    state.position.yaw = 0.0072;
    state.velocity.pitch = -speed / 460;
    if (under == Under::roller)
        state.roller_pitch = speed / roller_radius;
    else
        state.velocity.x = speed;
    return state;
}

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Sessions continue from step to step; other solves start from zero.
void steps(benchmark::State& state, const Place& place, bool session, Under under = Under::rail) {
    const double element = 0.01 * static_cast<double>(state.range(0));
    const WheelRailContact conformal = contact_of(Conformal::rotated, element, under),
                           plane = contact_of(Conformal::off, element, under);
    WheelRailEstimates of_conformal, of_plane;
    Observer observer;
    WheelRailSolution last;
    const auto solve = [&](const WheelRailContact& contact, WheelRailEstimates& estimates, int step) {
        const WheelRailState wheel = at(place, step, under);
        return session ? contact.solve(wheel, estimates, observer) : contact.solve(wheel, observer);
    };
    double conformal_seconds = 0, plane_seconds = 0;
    for (auto _ : state) {
        double seconds = 0;
        for (int step = 0; step < place.steps; ++step) {
            const auto start = std::chrono::steady_clock::now();
            const double before = processor_seconds();
            last = solve(conformal, of_conformal, step);
            const double between = processor_seconds();
            seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            benchmark::DoNotOptimize(solve(plane, of_plane, step));
            conformal_seconds += between - before;
            plane_seconds += processor_seconds() - between;
        }
        state.SetIterationTime(seconds / place.steps);
    }
    if (!last.converged()) state.SkipWithError("the last step has not converged");
    const Grid& grid = last.patches.at(0).place.grid;
    state.counters["over_plane"] = conformal_seconds / plane_seconds;
    state.counters["elements"] = static_cast<double>(grid.size());
    state.counters["cpu_ms"] = 1e3 * conformal_seconds / static_cast<double>(state.iterations()) / place.steps;
    state.counters["Fx"] = last.forces.track.Fx;
    state.counters["Fy"] = last.forces.track.Fy;
}

// Uses elements of 0.4 and 0.2 mm. The large patch below has elements of 0.15 mm, at least 20,000 of them.
void rows(benchmark::internal::Benchmark* rows) {
    rows->ArgName("hundredths")->Arg(40)->Arg(20)->UseManualTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(steps, gauge_corner, gauge_corner, true)->Apply(rows);
BENCHMARK_CAPTURE(steps, gauge_corner_slowly, gauge_corner_slowly, true)->Apply(rows);
BENCHMARK_CAPTURE(steps, gauge_corner_from_nothing, gauge_corner, false)->Apply(rows);
BENCHMARK_CAPTURE(steps, flange_root, flange_root, true)->Apply(rows);
BENCHMARK_CAPTURE(steps, flange_root_from_nothing, flange_root, false)->Apply(rows);
BENCHMARK_CAPTURE(steps, gauge_corner_on_a_roller, gauge_corner, true, Under::roller)->Apply(rows);
BENCHMARK_CAPTURE(steps, gauge_corner_on_slices, gauge_corner, true, Under::slices)->Apply(rows);
BENCHMARK_CAPTURE(steps, flange_root_on_a_roller, flange_root, true, Under::roller)->Apply(rows);
BENCHMARK_CAPTURE(steps, flange_root_on_slices, flange_root, true, Under::slices)->Apply(rows);
BENCHMARK_CAPTURE(steps, large, flange_root, true)
    ->ArgName("hundredths")
    ->Arg(15)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();

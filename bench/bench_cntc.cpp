// Compares the cost of a step through the functions of libcontactd-cntc with that through contactd.h. The problems are
// steady rolling on 25 x 25 elements, and a hunting wheel under its load, by full theory and by KPEC. Counter
// over_plain is the median time of a step over that of an alternating step through contactd.h; counter more_us is the
// difference.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <stdexcept>
#include <vector>

#include "client/cntc/rail_calls.hpp"
#include "contactd.h"

namespace {

using contactd::Side;
using contactd::cntc::test::Case;
using contactd::cntc::test::manchester_wheel;
using contactd::cntc::test::RailCase;

void check(std::int32_t code, const void* handle) {
    if (code != CONTACTD_OK) throw std::runtime_error(contactd_last_error(handle));
}

template <class Handle>
void set(Handle* handle, const char* path, double value) {
    check(contactd_set(handle, path, value), handle);
}

/// Solves a step of either library; its argument is the number of the step.
using Step = std::function<void(int)>;

void alternate(benchmark::State& state, const Step& cntc, const Step& plain) {
    const auto seconds_of = [](const Step& step, int k) {
        const std::clock_t start = std::clock();
        step(k);
        return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    };
    int k = 0;
    std::vector<double> cntc_seconds, plain_seconds;
    for (auto _ : state) {
        cntc_seconds.push_back(seconds_of(cntc, ++k));
        state.PauseTiming();
        plain_seconds.push_back(seconds_of(plain, k));
        state.ResumeTiming();
    }
    const auto median = [](std::vector<double>& values) {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    };
    const double one = median(cntc_seconds), other = median(plain_seconds);
    state.counters["over_plain"] = one / other;
    state.counters["more_us"] = 1e6 * (one - other);
}

double creepage(int step) {
    return step % 2 == 0 ? 0.002 : 0.0021;
}

void contact(benchmark::State& state) {
    Case cntc(1);
    cntc.flag(1983, 3);
    cntc.material(0.28, 0.28, 82000, 82000);
    cntc.coulomb(0.3);
    cntc.hertz(-3, {25, 25, 6, 4, 1.1});
    cntc.normal_force(50000);
    contactd_connection* connection;
    contactd_contact* plain;
    check(contactd_open("local", &connection), nullptr);
    check(contactd_new(connection, &plain), connection);
    for (const char* size : {"grid.nx", "grid.ny"}) set(plain, size, 25);
    set(plain, "grid.dx", 13.2 / 25);
    set(plain, "grid.dy", 8.8 / 25);
    set(plain, "bodies.upper.G", 82000);
    set(plain, "bodies.upper.nu", 0.28);
    set(plain, "gap.semi_axes.a", 6);
    set(plain, "gap.semi_axes.b", 4);
    set(plain, "Fn", 50000);
    set(plain, "friction.mu", 0.3);
    set(plain, "friction.rolling.eta", 0.001);
    set(plain, "friction.rolling.phi", 1e-4);
    set(plain, "friction.rolling.xi", creepage(0));
    check(contactd_start(plain), plain);
    double forces[4];
    alternate(
        state,
        [&](int k) {
            cntc.creepages(creepage(k), 0.001, 1e-4);
            if (cntc.calculate() < 0) throw std::runtime_error(contactd::cntc::test::last_sentence());
            benchmark::DoNotOptimize(cntc.forces());
        },
        [&](int k) {
            set(plain, "friction.rolling.xi", creepage(k));
            check(contactd_step(plain), plain);
            check(contactd_get_array(plain, "forces", forces, 4), plain);
            benchmark::DoNotOptimize(forces);
        });
    contactd_free(plain);
    contactd_close(connection);
}

enum class Theory { full, kpec };

/// Runs S1002 on 60E1 under 80 kN, with elements of half a millimetre. `estimate` is the value of flag 1983.
void hunt(benchmark::State& state, Theory theory, int estimate) {
    RailCase cntc = manchester_wheel(2, Side::right);
    cntc.whole.potential(-1, {0.5, 0.5, 1.5707963267948966, 8, 4, 12});
    cntc.whole.flag(1983, estimate);
    cntc.vertical_force(80000);
    contactd_connection* connection;
    contactd_wheel* plain;
    check(contactd_open("local", &connection), nullptr);
    check(contactd_wheel_new(connection, &plain), connection);
    set(plain, "setup.dx", 0.5);
    set(plain, "setup.dy", 0.5);
    set(plain, "state.Fz", 80000);
    if (theory == Theory::kpec) {
        cntc.whole.flag(1971, 5);
        cntc.whole.flag(1979, 3);
        check(contactd_set_word(plain, "setup.model", "fastsim"), plain);
        check(contactd_set_word(plain, "setup.normal_model", "kpec"), plain);
        check(contactd_set_word(plain, "setup.simplified.coefficients", "printed"), plain);
        set(plain, "setup.simplified.blended", 1);
        set(plain, "setup.simplified.on_elements", 1);
    }
    for (const auto& [path, points] : {std::pair{"setup.rail.points", contactd::cntc::test::rail_60e1()},
                                       {"setup.wheel.points", contactd::cntc::test::s1002()}})
        check(contactd_set_array(plain, path, points.data(), static_cast<std::int32_t>(points.size())), plain);
    double forces[6];
    alternate(
        state,
        [&](int k) {
            const double y = 2 * std::sin(0.05 * k), yaw = 0.002 * std::cos(0.05 * k);
            cntc.position(2, {0, y, 0, 0, yaw, 0});
            cntc.velocity(2, {20000, 0, 0, 0, 0, -43.48});
            if (cntc.whole.calculate() < 0) throw std::runtime_error(contactd::cntc::test::last_sentence());
            benchmark::DoNotOptimize(cntc.patch(1).forces());
        },
        [&](int k) {
            set(plain, "state.position.y", 2 * std::sin(0.05 * k));
            set(plain, "state.position.yaw", 0.002 * std::cos(0.05 * k));
            set(plain, "state.velocity.x", 20000);
            set(plain, "state.velocity.pitch", -43.48);
            check(contactd_wheel_solve_many(&plain, 1, 1), plain);
            check(contactd_get_array(plain, "forces.track", forces, 6), plain);
            benchmark::DoNotOptimize(forces);
        });
    contactd_wheel_free(plain);
    contactd_close(connection);
}

void wheel(benchmark::State& state) {
    hunt(state, Theory::full, 3);
}

void wheel_by_kpec(benchmark::State& state) {
    hunt(state, Theory::kpec, static_cast<int>(state.range(0)));
}

}  // namespace

BENCHMARK(contact)->Unit(benchmark::kMicrosecond);
BENCHMARK(wheel)->Unit(benchmark::kMicrosecond);
BENCHMARK(wheel_by_kpec)->ArgName("estimate")->Arg(0)->Arg(3)->Unit(benchmark::kMicrosecond);

BENCHMARK_MAIN();

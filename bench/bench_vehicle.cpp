// A vehicle of eight wheels, S1002 on 60E1, from contactd.h in process: what a step of all of them costs under their
// loads. It hunts by 3 mm, or runs through a curve, where the flange of the first wheelset touches. Counters: the
// median and the 99th percentile of processor time a step (us), and the median over that of a product A p of 36 x 56
// elements and over that of a step at the heights that were found, all from one run.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "contactd.h"
#include "contactd/wheel_rail_setup.hpp"
#include "wheel_rail/patches/half_space_cache.hpp"

namespace {

using Values = std::vector<double>;

constexpr int wheelsets = 4;
constexpr double speed = 20'000;      // mm/s
constexpr double radius = 460;        // mm
constexpr double static_Fz = 70'000;  // N

enum class Run { hunting, curving };

/// Asked of one wheel in a step.
struct WheelStep {
    double y, yaw, roll, y_rate, Fz;
};

WheelStep step_of(Run run, int wheelset, bool left, int k) {
    const double way = 2 * std::numbers::pi * k / 300 + 0.7 * wheelset, sway = 0.05 * std::sin(7 * way + left);
    const double share = left == (run == Run::curving) ? 60.0 / 70 : 80.0 / 70;
    if (run == Run::hunting)
        return {3 * std::sin(way), 2e-3 * std::cos(way), -1.5e-4 * std::sin(way), 63 * std::cos(way),
                static_Fz * share * (1 + sway)};
    const double aside = wheelset % 2 == 0 ? 6 : -1;
    return {aside + 0.2 * std::sin(way), (wheelset % 2 == 0 ? 4e-3 : -1e-3) + 1e-4 * std::cos(way), 0,
            4 * std::cos(way), static_Fz * share * (1 + sway)};
}

void check(std::int32_t code, const void* handle) {
    if (code != CONTACTD_OK) throw std::runtime_error(contactd_last_error(handle));
}

/// Measures time of the processor where there is one thread, which other work on the machine does not slow down, else
/// of the clock.
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

class Vehicle {
   public:
    explicit Vehicle(const char* model) {
        check(contactd_open("local", &connection_), nullptr);
        check(contactd_set_log(connection_, nullptr, nullptr), connection_);
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            check(contactd_wheel_new(connection_, &wheels_[i]), connection_);
            contactd_wheel* wheel = wheels_[i];
            check(contactd_set_word(wheel, "setup.model", model), wheel);
            check(contactd_set_word(wheel, "setup.side", i % 2 == 0 ? "right" : "left"), wheel);
            for (const char* size : {"setup.dx", "setup.dy"}) check(contactd_set(wheel, size, 0.5), wheel);
            check(contactd_set(wheel, "setup.friction.mu", 0.3), wheel);
        }
    }
    Vehicle(const Vehicle&) = delete;
    ~Vehicle() {
        for (contactd_wheel* wheel : wheels_) contactd_wheel_free(wheel);
        contactd_close(connection_);
    }

    /// Returns how long it takes (s). Heights are those that the forces had, where `at` has them.
    double step(Run run, int k, int threads, const Values* at = nullptr) {
        const Stopwatch watch(threads);
        heights_.clear();
        for (int i = 0; i < 2 * wheelsets; ++i) {
            contactd_wheel* wheel = wheels_[static_cast<std::size_t>(i)];
            const WheelStep now = step_of(run, i / 2, i % 2 == 1, k);
            for (const auto& [path, value] : {std::pair{"state.position.y", now.y},
                                              {"state.position.yaw", now.yaw},
                                              {"state.position.roll", now.roll},
                                              {"state.velocity.y", now.y_rate},
                                              {"state.velocity.x", speed},
                                              {"state.velocity.pitch", -speed / radius}})
                check(contactd_set(wheel, path, value), wheel);
            if (at)
                check(contactd_set(wheel, "state.position.z", (*at)[static_cast<std::size_t>(i)]), wheel);
            else
                check(contactd_set(wheel, "state.Fz", now.Fz), wheel);
        }
        check(contactd_wheel_solve_many(wheels_.data(), 2 * wheelsets, threads), nullptr);
        for (contactd_wheel* wheel : wheels_) {
            check(contactd_get_array(wheel, "forces.track", forces_.data(), 6), wheel);
            double z;
            check(contactd_get(wheel, "z", &z), wheel);
            heights_.push_back(z);
        }
        return watch.seconds();
    }
    const Values& heights() const { return heights_; }

   private:
    contactd_connection* connection_ = nullptr;
    std::array<contactd_wheel*, 2 * wheelsets> wheels_{};
    std::array<double, 6> forces_{};
    Values heights_;
};

double percentile(Values values, double share) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// The time (s) of the products that a patch of 36 x 56 elements takes.
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

void vehicle(benchmark::State& state, const char* model, Run run, int threads) {
    Vehicle loaded(model), placed(model);
    Product product;
    Values under_load, at_height, products;
    int k = 0;
    for (; k < 20; ++k) {
        loaded.step(run, k, 1);
        placed.step(run, k, 1, &loaded.heights());
    }
    for (auto _ : state) {
        under_load.push_back(loaded.step(run, k, threads));
        state.PauseTiming();
        at_height.push_back(placed.step(run, k, 1, &loaded.heights()));
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

BENCHMARK_CAPTURE(vehicle, full_hunting, "full", Run::hunting, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, full_curving, "full", Run::curving, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, full_hunting_on_two_threads, "full", Run::hunting, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, full_curving_on_two_threads, "full", Run::curving, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, fastsim_hunting, "fastsim", Run::hunting, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, fastsim_curving, "fastsim", Run::curving, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(vehicle, fastsim_hunting_on_two_threads, "fastsim", Run::hunting, 2)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();

// Eight wheels of a vehicle on their rails, on one thread and on two.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "client/cntc/rail_calls.hpp"

using namespace contactd;
using namespace contactd::cntc::test;

namespace {

constexpr int wheels = 8, few_steps = 12;
constexpr int first_element = 800;

/// Returns how much memory of the process is in use (MiB).
double resident_memory() {
    std::ifstream pages("/proc/self/statm");
    double all = 0, resident = 0;
    pages >> all >> resident;
    return resident * 4096 / (1 << 20);
}

/// Each wheel makes so many steps, which the environment may say: the more, the longer it takes.
int steps_of_endurance() {
    const char* said = std::getenv("CONTACTD_ENDURANCE_STEPS");
    return said != nullptr ? std::stoi(said) : 200;
}

/// What a wheel answers, step by step.
using Answers = std::vector<std::array<double, 3>>;

/// A wheelset that hunts, whose wheels are on other elements: a coarse grid is enough to tell threads apart.
Answers hunt(int wheel, int steps) {
    RailCase rail = manchester_wheel(first_element + wheel, wheel % 2 == 0 ? Side::left : Side::right);
    rail.whole.potential(0, {1, 1, 0});
    rail.whole.flag(1983, 3);
    rail.vertical_force(10000 + 500 * wheel);
    Answers answers;
    for (int step = 0; step < steps; ++step) {
        const double phase = 0.2 * step + 0.7 * (wheel / 2);
        rail.position(2, {0, 3 * std::sin(phase), 0, 0, 0.002 * std::cos(phase), 0});
        rail.velocity(2, {2000, 10 * std::cos(phase), 0, 0, 0, -4.348});
        if (rail.whole.calculate() != 0) return {};  // threads may not use the macros of tests
        const auto forces = rail.patch(1).forces();
        answers.push_back({forces.fn, forces.fx, forces.fy});
    }
    return answers;
}

}  // namespace

TEST_CASE("eight wheels answer the same on one thread and on two", "[rail]") {
    std::array<Answers, wheels> one, two;
    for (int wheel = 0; wheel < wheels; ++wheel) one[static_cast<std::size_t>(wheel)] = hunt(wheel, few_steps);
    {
        std::vector<std::jthread> threads;
        for (const int thread : {0, 1})
            threads.emplace_back([&two, thread] {
                for (int wheel = thread; wheel < wheels; wheel += 2)
                    two[static_cast<std::size_t>(wheel)] = hunt(wheel, few_steps);
            });
    }
    for (const Answers& answers : one) CHECK(answers.size() == few_steps);
    CHECK(one == two);
    CHECK(one[0] != one[1]);
}

// Asked for by its tag: it takes minutes with as many steps as a long simulation has.
TEST_CASE("many steps of eight wheels on two threads are those of one, and take no more memory", "[.endurance]") {
    const int steps = steps_of_endurance();
    std::array<Answers, wheels> one, two;
    const auto run = [steps](std::array<Answers, wheels>& answers, int first, int stride) {
        for (int wheel = first; wheel < wheels; wheel += stride)
            answers[static_cast<std::size_t>(wheel)] = hunt(wheel, steps);
    };
    run(one, 0, 1);
    const auto memory_after_two_threads = [&] {
        {
            std::vector<std::jthread> threads;
            for (const int thread : {0, 1}) threads.emplace_back([&, thread] { run(two, thread, 2); });
        }
        CHECK((one == two));
        return resident_memory();
    };
    // At first buffers grow to what they need, and wheels are kept prepared for others like them.
    for (int warm_up = 0; warm_up < 3; ++warm_up) memory_after_two_threads();
    const double first = memory_after_two_threads(), again = memory_after_two_threads();
    INFO("MiB: " << first << " before the last time, " << again << " after it");
    CHECK(again < first + 10);
    for (const Answers& answers : one) CHECK(answers.size() == static_cast<std::size_t>(steps));
}

// Eight wheels of a vehicle on their rails, on one thread and on two.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <thread>
#include <vector>

#include "client/cntc/rail_calls.hpp"

using namespace contactd;
using namespace contactd::cntc::test;

namespace {

constexpr int wheels = 8, steps = 12;
constexpr int first_element = 800;

/// What a wheel answers, step by step.
using Answers = std::vector<std::array<double, 3>>;

/// A wheelset that hunts, whose wheels are on other elements: a coarse grid is enough to tell threads apart.
Answers hunt(int wheel) {
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
    for (int wheel = 0; wheel < wheels; ++wheel) one[static_cast<std::size_t>(wheel)] = hunt(wheel);
    {
        std::vector<std::jthread> threads;
        for (const int thread : {0, 1})
            threads.emplace_back([&two, thread] {
                for (int wheel = thread; wheel < wheels; wheel += 2) two[static_cast<std::size_t>(wheel)] = hunt(wheel);
            });
    }
    for (const Answers& answers : one) CHECK(answers.size() == steps);
    CHECK(one == two);
    CHECK(one[0] != one[1]);
}

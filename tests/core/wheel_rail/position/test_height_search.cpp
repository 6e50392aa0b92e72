#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <vector>

#include "wheel_rail/position/height_search.hpp"

using namespace contactd;
using Catch::Matchers::WithinRel;

namespace {

double power(double depth, double exponent) {
    return depth > 0 ? 1e6 * std::pow(depth, exponent) : 0;
}

HeightTask task_of(std::function<double(double)> estimate, std::function<double(double)> force) {
    return {std::move(estimate), std::move(force), 0.3, 5.3, 5e4, {1e-9, 40}};
}

}  // namespace

TEST_CASE("A force that is its estimate is found in one solve") {
    const auto force = [](double z) { return power(z - 0.3, 1.5); };
    const HeightFound found = find_height(task_of(force, force));
    CHECK(found.evidence.converged);
    CHECK(found.evidence.iterations == 1);
    CHECK_THAT(force(found.z), WithinRel(5e4, 1e-9));
}

TEST_CASE("An estimate that is off by a factor, and a power, costs a few solves more") {
    const auto force = [](double z) { return power(z - 0.3, 1.6); };
    const HeightFound found = find_height(task_of([](double z) { return 0.8 * power(z - 0.3, 1.5); }, force));
    CHECK(found.evidence.converged);
    CHECK(found.evidence.iterations <= 5);
    CHECK_THAT(force(found.z), WithinRel(5e4, 1e-9));
}

TEST_CASE("An estimate is asked for once at each height, and seldom far below the one that is found") {
    std::vector<double> asked;
    const auto force = [](double z) { return power(z - 0.3, 1.6); };
    const auto estimate = [&](double z) {
        CHECK(std::count(asked.begin(), asked.end(), z) == 0);
        asked.push_back(z);
        return 0.8 * power(z - 0.3, 1.5);
    };
    const HeightFound found = find_height(task_of(estimate, force));
    CHECK(found.evidence.converged);
    CHECK(asked.size() <= 20);
    CHECK(*std::max_element(asked.begin(), asked.end()) - 0.3 < 2 * (found.z - 0.3));
}

TEST_CASE("Patches that appear are in the estimate, or between bounds") {
    const auto force = [](double z) { return power(z - 0.3, 1.5) + 3 * power(z - 0.4, 1.5); };
    const HeightFound known = find_height(task_of(force, force));
    CHECK(known.evidence.iterations == 1);
    const HeightFound unknown = find_height(task_of([](double z) { return power(z - 0.3, 1.5); }, force));
    CHECK(unknown.evidence.converged);
    CHECK_THAT(force(unknown.z), WithinRel(5e4, 1e-9));
}

TEST_CASE("A force that jumps over the prescribed one is an answer that has not converged") {
    const auto force = [](double z) { return z < 0.41 ? 1e4 : 9e4; };
    const HeightFound found = find_height(task_of([](double z) { return power(z - 0.3, 1.5); }, force));
    CHECK_FALSE(found.evidence.converged);
    CHECK(found.evidence.residual > 0.5);
    CHECK(std::abs(found.z - 0.41) < 1e-6);
}

TEST_CASE("A force that never comes is an answer that has not converged") {
    const auto none = [](double) { return 0.0; };
    const HeightFound found = find_height(task_of(none, none));
    CHECK_FALSE(found.evidence.converged);
}

TEST_CASE("A search that knows how far the estimate is off needs no other solve") {
    const auto force = [](double z) { return power(z - 0.3, 1.6); };
    HeightTask task = task_of([](double z) { return 0.8 * power(z - 0.3, 1.5); }, force);
    const HeightFound first = find_height(task);
    REQUIRE(first.evidence.iterations > 1);
    task.correction = first.correction;
    task.settings.tolerance = 1e-6;
    CHECK(find_height(task).evidence.iterations == 1);
    task.target = 5.5e4;
    const HeightFound next = find_height(task);
    CHECK(next.evidence.converged);
    CHECK(next.evidence.iterations <= 3);
    CHECK_THAT(force(next.z), WithinRel(5.5e4, 1e-6));
}

TEST_CASE("A correction that is wrong costs solves, and no more") {
    const auto force = [](double z) { return power(z - 0.3, 1.5); };
    for (const HeightCorrection wrong : {HeightCorrection{3, 0}, HeightCorrection{-3, 50}, HeightCorrection{0, -1e6}}) {
        HeightTask task = task_of(force, force);
        task.correction = wrong;
        const HeightFound found = find_height(task);
        CHECK(found.evidence.converged);
        CHECK_THAT(force(found.z), WithinRel(5e4, 1e-9));
    }
}

TEST_CASE("A force that stays a thousand times the prescribed one ends the search") {
    int solves = 0;
    const auto force = [&](double z) {
        ++solves;
        return z > 0.3 ? 1e9 : 0;
    };
    const HeightFound found = find_height(task_of([](double z) { return power(z - 0.3, 1.5); }, force));
    CHECK(!found.evidence.converged);
    CHECK(found.evidence.residual > 1e3);
    CHECK(solves == 2);
}

TEST_CASE("A first force far beyond the prescribed one is only the estimate's fault") {
    const auto force = [](double z) { return power(z - 0.3, 1.5); };
    const HeightFound found = find_height(task_of([&](double z) { return 1e-5 * force(z); }, force));
    CHECK(found.evidence.converged);
    CHECK_THAT(force(found.z), WithinRel(5e4, 1e-9));
}

TEST_CASE("Of several heights that bring a force the nearest to the step before is found, and the fall is told") {
    // The force exceeds the target, decreases to half of it over 0.004 mm, and increases again, as when patches merge.
    const auto estimate = [](double z) { return power(z - 0.3, 1.5); };
    const double drop = GENERATE(0.437, 0.438, 0.439);
    const auto force = [&](double z) {
        const double merged = std::clamp((z - drop) / 0.004, 0.0, 1.0);
        return estimate(z) * (1 - 0.3 * merged);
    };
    HeightTask task = task_of(estimate, force);
    const double apart = 0.3 + std::pow(0.05, 2.0 / 3), merged = 0.3 + std::pow(0.05 / 0.7, 2.0 / 3);
    REQUIRE(apart < drop);
    REQUIRE(merged > drop + 0.004);
    SECTION("before they merge, also where the first height is a little off") {
        task.correction.logarithm = GENERATE(0.04, 0.01, 0.0, -0.01, -0.02);
        const HeightFound found = find_height(task);
        CHECK(found.evidence.converged);
        CHECK_THAT(found.z, WithinRel(apart, 1e-6));
    }
    SECTION("after they have merged") {
        task.correction.logarithm = std::log(0.7) + GENERATE(0.0, -0.01, 0.01);
        const HeightFound found = find_height(task);
        CHECK(found.evidence.converged);
        CHECK_THAT(found.z, WithinRel(merged, 1e-6));
        CHECK_FALSE(found.falls);
    }
}

TEST_CASE("A force that jumps over its target is found where it jumps, with the forces on both sides") {
    const auto estimate = [](double z) { return power(z - 0.3, 1.5); };
    // The height of the jump is below that of the target by the estimate, and above it.
    for (const double at : {0.42, 0.44}) {
        const HeightFound found =
            find_height(task_of(estimate, [&](double z) { return (z < at ? 0.7 : 1.3) * estimate(z); }));
        CHECK(!found.evidence.converged);
        CHECK(std::abs(found.z - at) < 1e-6);
        REQUIRE(found.jump);
        CHECK_THAT(found.jump->above, WithinRel(0.7 * estimate(at), 1e-4));
        CHECK_THAT(found.jump->below, WithinRel(1.3 * estimate(at), 1e-4));
    }
    CHECK(!find_height(task_of(estimate, estimate)).jump);
}

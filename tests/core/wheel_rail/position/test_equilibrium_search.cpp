#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "wheel_rail/position/equilibrium_search.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Values = EquilibriumTask::Values;

namespace {

EquilibriumTask of_one(std::function<double(double)> function, double start, double slope) {
    EquilibriumTask task;
    task.residuals = [function = std::move(function)](const Values& x) { return Values{function(x[0])}; };
    task.start = {start};
    task.low = {-10};
    task.high = {10};
    task.first_step = {0.5};
    task.slopes = {slope};
    task.tolerance = 1e-9;
    return task;
}

}  // namespace

TEST_CASE("Functions that are as straight as they are expected to be take one step") {
    const EquilibriumFound found = find_equilibrium(of_one([](double x) { return 2 * (x - 0.3); }, 0, 2));
    CHECK(found.converged);
    CHECK(found.evaluations == 2);
    CHECK_THAT(found.at[0], WithinAbs(0.3, 1e-12));
}

TEST_CASE("A creep force that saturates is brought by few solves, from slopes that are off") {
    const auto creep = [](double x) { return std::tanh(4 * x) - 0.9; };
    for (const double slope : {1.0, 4.0, 20.0}) {
        const EquilibriumFound found = find_equilibrium(of_one(creep, 0, slope));
        CHECK(found.converged);
        CHECK(found.evaluations <= 14);
        CHECK_THAT(found.at[0], WithinAbs(std::atanh(0.9) / 4, 1e-8));
    }
}

TEST_CASE("What a search has learnt makes the next one shorter") {
    const auto pair = [](double shift) {
        EquilibriumTask task;
        task.residuals = [shift](const Values& x) {
            return Values{std::tanh(x[0]) + 0.4 * x[1] - 0.3 - shift, 0.3 * x[0] + x[1] + x[1] * x[1] * x[1] - 0.5};
        };
        task.start = {0, 0};
        task.low = {-5, -5};
        task.high = {5, 5};
        task.first_step = {0.2, 0.2};
        task.slopes = {1, 0, 0, 1};
        task.tolerance = 1e-8;
        return task;
    };
    const EquilibriumFound first = find_equilibrium(pair(0));
    REQUIRE(first.converged);
    EquilibriumTask next = pair(0.01);
    next.start = first.at;
    next.slopes = first.slopes;
    const EquilibriumFound second = find_equilibrium(next);
    CHECK(second.converged);
    CHECK(second.evaluations < first.evaluations);
    for (const double residual : next.residuals(second.at)) CHECK_THAT(residual, WithinAbs(0, 1e-8));
}

TEST_CASE("A search stays within its bounds, and says so where there is no root") {
    const EquilibriumFound far = find_equilibrium(of_one([](double x) { return std::atan(x) + 2; }, 0, 1));
    CHECK_FALSE(far.converged);
    CHECK(far.evaluations <= 40);
    CHECK(far.at[0] >= -10);
    const EquilibriumFound jump = find_equilibrium(of_one([](double x) { return x < 0.2 ? -1.0 : 1.0; }, 0, 1));
    CHECK_FALSE(jump.converged);
    CHECK(jump.evaluations <= 40);
    const double none = std::numeric_limits<double>::quiet_NaN();
    const EquilibriumFound nothing = find_equilibrium(of_one([none](double) { return none; }, 0, 1));
    CHECK_FALSE(nothing.converged);
    CHECK(nothing.evaluations == 1);
}

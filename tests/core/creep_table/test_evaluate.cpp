#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <limits>

#include "blended_forces.hpp"
#include "contactd/error.hpp"

using namespace contactd;
using namespace contactd::creep_table;
using Catch::Matchers::WithinAbs;

namespace {

ScaledForces at(double log_a_over_b, const Triple& w) {
    return evaluate(blended_table().spline(), log_a_over_b, w);
}

// Compares the Jacobian with central differences of the table.
void check_derivatives(double l, const Triple& w, double tolerance) {
    CAPTURE(l, w[0], w[1], w[2]);
    const ScaledForces here = at(l, w);
    for (int j = 0; j < 4; ++j) {
        const double step = j < 3 ? 0.01 * std::hypot(w[0], w[1], w[2]) : 2e-3;
        Triple after = w, before = w;
        if (j < 3) {
            after[j] += step;
            before[j] -= step;
        }
        const double more = j == 3 ? step : 0;
        const Triple high = at(l + more, after).forces, low = at(l - more, before).forces;
        for (int i = 0; i < 3; ++i) {
            const double slope = j < 3 ? here.by_creepage[i][j] : here.by_log_ratio[i];
            CHECK_THAT(slope, WithinAbs((high[i] - low[i]) / (2 * step), tolerance));
        }
    }
}

}  // namespace

TEST_CASE("a table holds the forces at its nodes", "[creep_table]") {
    const BlendedTable& table = blended_table();
    std::size_t next = 0;
    double largest = 0;
    for_each_node(table.grid.axes, 1, [&](const std::array<double, 4>& point) {
        const Triple found = at(point[0], creepages_at(table.grid, table.nu, point)).forces;
        for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(found[i] - table.nodes[next++]));
    });
    CHECK(next == node_values(table.grid));
    CHECK(largest < 2e-5);
}

TEST_CASE("a table interpolates between its nodes", "[creep_table]") {
    RandomStates states;
    double largest = 0, sum = 0;
    constexpr int count = 300;
    for (int n = 0; n < count; ++n) {
        const double l = states.log_ratio();
        const Triple w = states.creepages(), found = at(l, w).forces;
        const Triple expected = blended_forces(std::exp(l), blended_table().nu, w);
        for (int i = 0; i < 3; ++i) {
            largest = std::max(largest, std::abs(found[i] - expected[i]));
            sum += std::abs(found[i] - expected[i]);
        }
    }
    CHECK(largest < 0.02);
    CHECK(sum / (3 * count) < 1e-3);
}

TEST_CASE("a table has the symmetries of the theory", "[creep_table]") {
    const Triple sign = GENERATE(Triple{-1, -1, -1}, Triple{1, -1, -1}, Triple{-1, 1, 1});
    const Triple mask = GENERATE(Triple{1, 1, 1}, Triple{0, 1, 1}, Triple{1, 1, 0}, Triple{1, 0, 0}, Triple{0, 0, 1},
                                 Triple{0, 1, 0}, Triple{1e-4, 1e-4, 1e-4});
    RandomStates states;
    const double l = states.log_ratio();
    Triple w = states.creepages(), reflected{};
    for (int i = 0; i < 3; ++i) reflected[i] = sign[i] * (w[i] *= mask[i]);
    const ScaledForces here = at(l, w), there = at(l, reflected);
    for (int i = 0; i < 3; ++i) {
        CHECK_THAT(there.forces[i], WithinAbs(sign[i] * here.forces[i], 1e-12));
        for (int j = 0; j < 3; ++j)
            CHECK_THAT(there.by_creepage[i][j], WithinAbs(sign[i] * sign[j] * here.by_creepage[i][j], 1e-12));
    }
    if (w[0] == 0) CHECK(here.forces[0] == 0);
    if (w[1] == 0 && w[2] == 0) CHECK((here.forces[1] == 0 && here.forces[2] == 0));
}

TEST_CASE("the Jacobian of a table is that of its forces", "[creep_table]") {
    RandomStates states;
    for (int n = 0; n < 30; ++n) check_derivatives(states.log_ratio(), states.creepages(), 5e-3);
    const double l = states.log_ratio(), Y = GENERATE(0.4, -1.0);
    check_derivatives(l, {0, Y, 0}, 0.02);
    check_derivatives(l, {1e-4, Y, 1e-4}, 0.02);
    check_derivatives(l, {0.3, Y, 0}, 0.02);
    check_derivatives(l, {0, Y, 0.3}, 0.02);
}

TEST_CASE("without creepage, a table has Kalker's coefficients", "[creep_table]") {
    const double l = std::log(0.8);
    const KalkerCoefficients C = kalker_coefficients(0.8, 0.28);
    const auto expected = creepage_matrix(C.C11, C.C22, C.C23, C.C33);
    const ScaledForces none = at(l, {});
    for (int i = 0; i < 3; ++i) {
        CHECK(none.forces[i] == 0);
        for (int j = 0; j < 3; ++j) CHECK_THAT(none.by_creepage[i][j], WithinAbs(expected[i][j], 1e-5 * C.C11));
    }
    const Triple w{1e-3, -2e-3, 5e-4};  // where the spline begins
    const ScaledForces small = at(l, w);
    for (int i = 0; i < 3; ++i) {
        const double linear = expected[i][0] * w[0] + expected[i][1] * w[1] + expected[i][2] * w[2];
        CHECK_THAT(small.forces[i], WithinAbs(linear, 0.03 * 0.01));
    }
}

TEST_CASE("large creepages produce the forces at infinity", "[creep_table]") {
    const Triple w = GENERATE(Triple{1, 2, 0}, Triple{-1, 0.1, 2}, Triple{0, 0, -1}),
                 large{1e9 * w[0], 1e9 * w[1], 1e9 * w[2]};
    const Triple found = at(0.1, large).forces, limit = forces_at_infinite_creepage(std::exp(0.1), w);
    for (int i = 0; i < 3; ++i) CHECK_THAT(found[i], WithinAbs(limit[i], 0.01));
}

TEST_CASE("creepages that are not finite are refused", "[creep_table]") {
    const double bad =
        GENERATE(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e200);
    CHECK_THROWS_AS(at(0, {0, bad, 0}), InvalidArgument);
    CHECK_THROWS_AS(at(0, {bad, 0, 1}), InvalidArgument);
}

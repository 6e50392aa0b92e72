// Tests tractions of patches that move, grow, merge and split.
#include "wheel_rail/position/traction_history.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numeric>

using namespace contactd;
using Catch::Matchers::WithinRel;

namespace {

WheelRailEstimates::Patch patch_at(double along, double across, int nx, int ny) {
    const Grid grid = Grid::of_elements(nx, ny, 0.5, 0.25);
    WheelRailEstimates::Patch patch{grid, 0, {along, across}, 0, {}};
    for (std::size_t i = 0; i < grid.size(); ++i) {
        patch.tractions.pressure.push_back(1 + static_cast<double>(i));
        patch.tractions.traction_x.push_back(0.3 + static_cast<double>(i));
        patch.tractions.traction_y.push_back(-0.2);
    }
    return patch;
}

geometry::CandidatePatch candidate_at(double along, double across, int nx, int ny) {
    geometry::CandidatePatch found;
    found.place.grid = Grid::of_elements(nx, ny, 0.5, 0.25);
    found.place.on_rail = {along, across};
    return found;
}

ContactProblem problem_on(const Grid& grid) {
    ContactProblem problem;
    problem.grid = grid;
    return problem;
}

WheelRailState shift() {
    WheelRailState state;
    state.motion = WheelRailMotion::shift;
    return state;
}

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

TEST_CASE("Tractions move by whole elements, and the grid grows for them") {
    const TractionHistory history({patch_at(0, 0, 5, 3)}, {candidate_at(1, 0.25, 5, 3)}, shift());
    const Grid grid = history.widened(0);
    CHECK(grid.nx == 7);
    CHECK(grid.ny == 4);
    const SurfaceState state = history.on(0, problem_on(grid));
    REQUIRE(state.pressure.size() == 28);
    CHECK(state.pressure[0] == 1);
    CHECK(state.pressure[7] == 6);
    CHECK(state.pressure[5] == 0);
    CHECK(sum(state.pressure) == 120);
    CHECK(history.force_left_behind() == 0);
}

TEST_CASE("Tractions of patches that merge and split are kept") {
    const auto right = patch_at(0, 0, 5, 5), left = patch_at(0.5, 2, 5, 5);
    const double total = sum(right.tractions.traction_x) + sum(left.tractions.traction_x);
    const TractionHistory merged({right, left}, {candidate_at(0, 1, 7, 9)}, shift());
    CHECK_THAT(sum(merged.on(0, problem_on(merged.widened(0))).traction_x), WithinRel(total, 1e-12));

    const auto whole = patch_at(0, 1, 5, 13);
    const TractionHistory split({whole}, {candidate_at(0, 0, 5, 5), candidate_at(0, 2, 5, 5)}, shift());
    double kept = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const double part = sum(split.on(i, problem_on(split.widened(i))).traction_x);
        CHECK(part > 0);
        kept += part;
    }
    CHECK_THAT(kept, WithinRel(sum(whole.tractions.traction_x), 1e-12));
}

TEST_CASE("Parts that go on from the whole of a patch have all of its tractions, in planes the first one only") {
    const bool curved = GENERATE(false, true);
    const WheelRailEstimates::Patch whole = patch_at(0, 0, 5, 7), other = patch_at(0, 40, 5, 3);
    std::vector<geometry::CandidatePatch> now{candidate_at(0, 0, 5, 2), candidate_at(0, 0.5, 5, 2),
                                              candidate_at(0, 40, 5, 3)};
    if (curved)
        for (geometry::CandidatePatch& found : now) found.place.rows.resize(1);
    const TractionHistory own({whole, other}, now, shift()), all({whole, other}, now, shift(), PatchHistory::whole);
    CHECK_FALSE(own.shares(0));
    CHECK(all.shares(0));
    CHECK(all.shares(1) == curved);
    CHECK_FALSE(all.shares(2));
    CHECK(all.widened(0).ny == 7);
    CHECK(all.widened(1).ny == (curved ? 7 : own.widened(1).ny));
    CHECK(all.widened(2) == own.widened(2));
    CHECK(all.force_left_behind() == 0);
}

TEST_CASE("Tractions too far away are counted, and left behind") {
    const TractionHistory history({patch_at(0, 0, 5, 3)}, {candidate_at(100, 0, 5, 3)}, shift());
    CHECK(history.widened(0) == candidate_at(100, 0, 5, 3).place.grid);
    CHECK(history.on(0, problem_on(history.widened(0))).empty());
    CHECK(history.force_left_behind() > 0);
}

TEST_CASE("Elements of steady rolling are taken for those next to them") {
    const auto before = patch_at(0.2, 0.1, 5, 3);
    const TractionHistory history({before}, {candidate_at(0, 0, 5, 3)}, shift());
    CHECK(history.on(0, problem_on(history.widened(0))).pressure == before.tractions.pressure);
}

TEST_CASE("Elements of transient rolling move with the wheelset, and those of a shift stay on the rail") {
    auto before = patch_at(10, 0, 5, 3);
    before.x = 10;
    WheelRailState state;
    state.position.x = 30;
    const auto now = candidate_at(30, 0, 5, 3);
    state.motion = WheelRailMotion::transient_rolling;
    const TractionHistory rolls({before}, {now}, state);
    CHECK(rolls.on(0, problem_on(rolls.widened(0))).pressure == before.tractions.pressure);
    state.motion = WheelRailMotion::shift;
    CHECK(TractionHistory({before}, {now}, state).force_left_behind() > 0);
}

TEST_CASE("What particles carry moves with their tractions, and those that enter have not slipped yet") {
    auto before = patch_at(0, 0, 5, 3);
    before.tractions.yield_stress.assign(15, 90);
    before.tractions.friction_coefficient.assign(15, 0.2);
    const auto now = candidate_at(1, 0, 5, 3);
    const TractionHistory history({before}, {now}, shift());
    ContactProblem problem = problem_on(history.widened(0));
    CHECK(history.on(0, problem).yield_stress.empty());
    CHECK(history.on(0, problem).friction_coefficient.empty());
    KineticFriction kinetic;
    kinetic.memory = FrictionMemory{0.01, 1};
    problem.friction = FrictionLaw{{0.35}, kinetic, InterfacialLayer{0, 80, 500}};
    const SurfaceState state = history.on(0, problem);
    CHECK(state.yield_stress[0] == 90);
    CHECK(state.friction_coefficient[0] == 0.2);
    CHECK(state.yield_stress[6] == 80);
    CHECK(state.friction_coefficient[6] == 0.35);
}

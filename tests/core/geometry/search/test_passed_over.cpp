// Tests edges of rails of slices that the search along the locus misses.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/search/sliced_cases.hpp"

using namespace contactd;
using namespace contactd::test;

namespace {

/// Creates a rail that is higher by `rise` from x = `at` on, away from the axle.
WheelRailSetup on_step(double at, double rise) {
    return on_rail_of({-200, -100, at - 20, at - 10, at - 0.05, at + 0.05, at + 10, at + 20, 200},
                      [=](double x, double) { return (x - at) * at > 0 ? rise : 0; });
}

WheelRailSolution pressed(const WheelRailSetup& setup) {
    WheelRailState state;
    state.Fz = 30000;
    return solve(setup, state);
}

std::string sentence_of_edge(const WheelRailSolution& solution) {
    for (const std::string& warning : solution.warnings)
        if (warning.find("misses. Set patches.search to mesh.") != std::string::npos) return warning;
    return "";
}

}  // namespace

TEST_CASE("A step that the wheel reaches ahead of its contact is warned of") {
    // At 15 mm the wheel is 0.25 mm above its lowest point, and the rail 0.3 mm.
    const double at = GENERATE(15.0, -15.0);
    WheelRailSetup setup = on_step(at, 0.3);
    setup.side = GENERATE(Side::left, Side::right);
    const std::string sentence = sentence_of_edge(pressed(setup));
    CAPTURE(at, sentence);
    CHECK(sentence.starts_with("At x = " + std::string(at > 0 ? "1" : "-1")));
    CHECK(sentence.find(setup.side == Side::left ? "and y = -7" : "and y = 7") != std::string::npos);

    // The search on a mesh finds it without a warning.
    setup.patches.search = ContactSearch::mesh;
    const WheelRailSolution mesh = pressed(setup);
    CHECK(sentence_of_edge(mesh).empty());
    const auto reaches_step = [at](const WheelRailPatch& patch) {
        const Extent& x = patch.place.regions[0].x;
        return at > 0 ? x.to > 14 : x.from < -14;
    };
    CHECK(std::ranges::any_of(mesh.patches, reaches_step));
}

TEST_CASE("A step on a part of the rail's head is warned of") {
    const WheelRailSetup setup = on_rail_of({-200, -100, -5, 5, 14.95, 15.05, 25, 35, 200},
                                            [](double x, double y) { return x > 15 && y > 5 ? 0.4 : 0; });
    CHECK(!sentence_of_edge(pressed(setup)).empty());
}

TEST_CASE("A wheel in a notch that touches one side of it first is warned of the other one") {
    const WheelRailSetup setup = on_rail_of({-200, -100, -60, -40, -20, -1, 1, 20, 40, 60, 100, 200},
                                            [](double x, double) { return 0.02 * std::max(0.0, std::abs(x) - 0.5); });
    CHECK(!sentence_of_edge(pressed(setup)).empty());
}

TEST_CASE("Rails of slices without an edge in reach are not warned of") {
    const std::vector<double> places{-200, -100, -60, -40, -20, 0, 20, 40, 60, 100, 200};
    const WheelRailSetup setup = GENERATE_COPY(
        on_step(15, -0.3), on_step(40, 0.3), on_step(-25, -0.3), on_rail_of(places, [](double, double) { return 0; }),
        on_rail_of(places, [](double x, double) { return 0.01 * x; }),
        on_rail_of(places, [](double x, double y) { return 0.005 * x + 1e-4 * x * y; }),
        on_rail_of(places, [](double x, double) { return 0.5 * std::cos(x / 200); }));
    CHECK(sentence_of_edge(pressed(setup)).empty());
}

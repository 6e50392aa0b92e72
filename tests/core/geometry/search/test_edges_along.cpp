// Compares the fast search along lines from slice to slice with the coarse mesh that finds edges.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/position.hpp"
#include "geometry/search/edges_along.hpp"
#include "geometry/search/passed_over.hpp"
#include "geometry/search/sliced_cases.hpp"

using namespace contactd;
using namespace contactd::geometry;
using namespace contactd::test;

namespace {

/// Holds the surfaces of a state, and their searches.
struct Searched {
    Searched(const WheelRailSetup& setup, const WheelRailState& state)
        : profiles(make_profiles(setup)),
          wheel(profiles.wheel, setup.wheelset, state.position),
          rail(profiles.slices, state.position.x, setup.track, profiles.rail_origin, state.rail),
          locus(wheel, rail, setup.patches.locus_step * setup.dy, no_observer),
          edges(wheel, rail) {}

    Profiles profiles;
    WheelSurface wheel;
    RailSurface rail;
    Locus locus;
    EdgesAlong edges;
};

/// Creates a rail with a step, across all or part of its head, under a wheel nearby.
struct RandomEdge {
    explicit RandomEdge(std::mt19937& generator) {
        const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(generator); };
        const double at = between(2, 60), rise = between(0.05, 1), beside = between(-20, 15), ramp = between(0.05, 3);
        const double noise = between(0, 1) < 0.3 ? between(0, 0.03) : 0, incline = between(-0.01, 0.01);
        std::vector<double> places{-200, -100, at - 20 - ramp, at - ramp, at, at + ramp, at + 20, at + 100, 300};
        std::vector<double> heights;
        for (std::size_t i = 0; i < places.size(); ++i) heights.push_back(between(-noise, noise));
        setup = on_rail_of(places, [=](double x, double y) {
            const auto slice = static_cast<std::size_t>(std::ranges::find(places, x) - places.begin());
            return incline * x + heights[slice] + (x >= at && y > beside ? rise : 0);
        });
        setup.track.cant = between(0, 0.05);
        state.position.x = between(-3, 3);
        state.position.y = between(-4, 4);
        state.position.yaw = between(-0.02, 0.02);
        height = between(0.02, 0.25);
    }
    WheelRailSetup setup;
    WheelRailState state;
    double height;  // below the first contact
};

}  // namespace

TEST_CASE("Lines from slice to slice leave out no edge that a coarse mesh finds") {
    std::mt19937 generator(54);
    int found = 0;
    for (int i = 0; i < 150; ++i) {
        CAPTURE(i);
        const RandomEdge edge(generator);
        Searched at(edge.setup, edge.state);
        const double z = at.locus.least_gap() + edge.height;
        at.locus.look_below(z);
        if (!CoarseMesh(at.wheel, at.rail, no_observer).passed_over(at.locus, z)) continue;
        ++found;
        CHECK(at.edges.may_reach(at.locus, z));
    }
    CHECK(found > 30);
}

TEST_CASE("Rails without an edge in reach need no mesh") {
    std::vector<double> places;
    for (double x = -300; x <= 300; x += 25) places.push_back(x);
    const WheelRailSetup setup =
        GENERATE_COPY(on_rail_of(places, [](double, double) { return 0; }),
                      on_rail_of(places, [](double x, double) { return 0.01 * x; }),
                      on_rail_of(places, [](double x, double) { return 0.5 * std::sin(x / 150); }),
                      on_rail_of({-300, -200, -100, 69.95, 70.05, 100, 200}, [](double x, double) { return x > 70; }));
    Searched at(setup, {});
    const double z = at.locus.least_gap() + 0.15;
    at.locus.look_below(z);
    CHECK(!at.edges.may_reach(at.locus, z));
}

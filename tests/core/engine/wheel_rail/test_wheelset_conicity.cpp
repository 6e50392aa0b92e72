#include "engine/wheel_rail/wheelset_conicity.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "contactd/error.hpp"

using namespace contactd;
using namespace contactd::engine;
using Catch::Matchers::StartsWith;
using Catch::Matchers::WithinAbs;

TEST_CASE("A cone has its own conicity, and what is wrong with a request for it is named") {
    const Observer observer;
    WheelRailSetup setup;
    ConicityRequest wanted{{2}};
    const auto field = [&] {
        try {
            static_cast<void>(wheelset_conicities(setup, wanted, observer));
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return std::string();
    };
    setup.wheel.shape = ConeProfile{-0.05, -60, 60};
    CHECK_THAT(wheelset_conicities(setup, wanted, observer).at(0).integrated, WithinAbs(0.05, 1e-7));
    SECTION("amplitudes") {
        wanted.amplitudes = {1, -1};
        CHECK(field() == "conicity.amplitudes[1]");
    }
    SECTION("profiles that end") {
        setup.rail.shape = ArcProfile{300, 0, -5, 5};
        wanted.amplitudes = {10};
        CHECK(field() == "conicity.amplitudes");
    }
    SECTION("points") {
        setup.rail.shape = ProfilePoints{{{0, 0}}};
        CHECK_THAT(field(), StartsWith("setup.rail.points"));
    }
    SECTION("a rail that varies") {
        setup.rail_slices = {{0, {}}, {1, {}}};
        CHECK(field() == "setup.rail_slices");
    }
}

TEST_CASE("A search for conicities ends when it is cancelled") {
    struct Impatient final : Observer {
        bool cancelled() const override { return true; }
    } observer;
    CHECK_THROWS_AS(wheelset_conicities({}, {{3}}, observer), Cancelled);
}

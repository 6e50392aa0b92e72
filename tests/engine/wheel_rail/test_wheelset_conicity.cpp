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
    WheelsetSetup setup;
    ConicityRequest request{{2}};
    const auto field = [&] {
        try {
            static_cast<void>(wheelset_conicities(setup, request, observer));
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return std::string();
    };
    setup.setup.wheel.shape = ConeProfile{-0.05, -60, 60};
    CHECK_THAT(wheelset_conicities(setup, request, observer).at(0).integrated, WithinAbs(0.05, 1e-7));
    SECTION("amplitudes") {
        request.amplitudes = {1, -1};
        CHECK(field() == "conicity.amplitudes[1]");
    }
    SECTION("profiles that end") {
        setup.setup.rail.shape = ArcProfile{300, 0, -5, 5};
        request.amplitudes = {10};
        CHECK(field() == "conicity.amplitudes");
    }
    SECTION("points") {
        setup.setup.rail.shape = ProfilePoints{{{0, 0}}};
        CHECK_THAT(field(), StartsWith("setup.rail.points"));
    }
    SECTION("points of the left side") {
        setup.left = WheelRailSetup{};
        setup.left->wheel.shape = ProfilePoints{{{0, 0}}};
        CHECK_THAT(field(), StartsWith("left.wheel.points"));
    }
    SECTION("a gauge that is none") {
        setup.left = WheelRailSetup{};
        setup.left->track.gauge = 30;
        CHECK(field() == "left.track.gauge");
    }
    SECTION("a roller") {
        setup.setup.track.roller_radius = 500;
        CHECK(field() == "setup.track.roller_radius");
    }
    SECTION("a roller of the left side") {
        setup.left = setup.setup;
        setup.left->track.roller_radius = 500;
        CHECK(field() == "left.track.roller_radius");
    }
    SECTION("a rail that varies") {
        setup.setup.rail_slices = {{0, {}}, {1, {}}};
        CHECK(field() == "setup.rail_slices");
    }
}

TEST_CASE("A search for conicities ends when it is cancelled") {
    struct Impatient final : Observer {
        bool cancelled() const override { return true; }
    } observer;
    CHECK_THROWS_AS(wheelset_conicities({}, {{3}}, observer), Cancelled);
}

TEST_CASE("A wheelset touches its rails at each shift") {
    const Observer observer;
    WheelsetSetup setup;
    setup.setup.wheel.shape = ConeProfile{-0.05, -60, 60};
    const auto contacts = wheelset_contacts(setup, {{-3, 0, 3}}, observer);
    REQUIRE(contacts.size() == 3);
    CHECK_THAT(contacts[0].radius_difference(), WithinAbs(-0.3, 1e-6));
    CHECK(contacts[1].left.y == -contacts[1].right.y);
    SECTION("whose sides may differ") {
        setup.left = WheelRailSetup{};
        const auto mixed = wheelset_contacts(setup, {{3}}, observer);
        CHECK(mixed[0].right == contacts[2].right);
        CHECK(mixed[0].left == wheelset_contacts({}, {{3}}, observer)[0].left);
    }
    SECTION("also in their radii") {
        setup.left = setup.setup;
        setup.left->wheelset.nominal_radius = 459;
        const auto unequal = wheelset_contacts(setup, {{3}}, observer);
        CHECK(unequal[0].right == contacts[2].right);
        CHECK(unequal[0].left.radius == contacts[2].left.radius - 1);
    }
    SECTION("but not where it has left them") {
        CHECK_THROWS_WITH(wheelset_contacts(setup, {{0, 300}}, observer), StartsWith("contacts.shifts[1] is 300"));
    }
    SECTION("until it is cancelled") {
        struct Impatient final : Observer {
            bool cancelled() const override { return true; }
        } impatient;
        CHECK_THROWS_AS(wheelset_contacts(setup, {{0}}, impatient), Cancelled);
    }
}

TEST_CASE("Profiles lie where their contacts are") {
    WheelsetSetup setup;
    setup.setup.track.cant = 0.02;
    const ProfilesOfSides profiles = placed_profiles(setup);
    CHECK(profiles.left == profiles.right);
    CHECK(profiles.right.wheel_origin == 750);
    const WheelsetContacts contacts = wheelset_contacts(setup, {{2}}, Observer()).at(0);
    CHECK_THAT(contacts.right.y, WithinAbs(profiles.right.rail_origin.y + contacts.right.rail_y, 1e-9));
    CHECK_THAT(contacts.right.y - 2, WithinAbs(profiles.right.wheel_origin + contacts.right.wheel_y, 1e-9));
    setup.left = WheelRailSetup{};
    CHECK(placed_profiles(setup).left != profiles.right);
}

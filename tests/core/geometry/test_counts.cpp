// Tests inputs that lead to absurdly large numbers of rows, nodes, elements and stations.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <functional>
#include <limits>
#include <string>

#include "contactd/count_of.hpp"
#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "contactd/wheelset_contacts.hpp"
#include "geometry/placement/out_of_round.hpp"
#include "geometry/placement/sliced_rail.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Returns the field of the call's refusal, or "" if it succeeds.
std::string refused(const std::function<void()>& call) {
    try {
        call();
    } catch (const InvalidArgument& error) {
        return error.field();
    }
    return "";
}

/// Creates a profile 80 mm wide and many kilometres long, which jumps up and down between neighbours.
ProfileCurve leaping(double height) {
    std::vector<ProfilePoint> points;
    for (int i = 0; i <= 800; ++i) points.push_back({-40 + 0.1 * i, i % 2 == 0 ? 0 : height});
    return ProfileCurve(std::move(points));
}

}  // namespace

TEST_CASE("A quotient becomes a count where it is one") {
    const Counted rows{"patches.locus_step", "is 1e-09", "rows", "make it larger", 100};
    CHECK(count_of(0, rows) == 0);
    CHECK(count_of(99.9, rows) == 99);
    CHECK(count_of(100, rows) == 100);
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const double quotient :
         {100.1, 1e9, 5e9, 1e19, 1e300, infinite, -infinite, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        CAPTURE(quotient);
        CHECK_THROWS_AS(count_of(quotient, rows), InvalidArgument);
    }
    CHECK_THROWS_WITH(
        count_of(7.2e7, rows),
        "patches.locus_step is 1e-09, which results in 7.2e+07 rows; at most 100 are allowed: make it larger");
}

TEST_CASE("Rows of the search that no memory holds are refused by the step that makes them") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.patches.locus_step = GENERATE(1e-6, 1e-9, 1e-15, 1e-20, 1e-300);
    WheelRailState state;
    state.position.z = 0.05;
    CHECK(refused([&] { solve(setup, state); }) == "patches.locus_step");
}

TEST_CASE("Nodes of the mesh search that no memory holds are refused by the elements that make them") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.patches.search = ContactSearch::mesh;
    setup.wheelset.nominal_radius = 9999;
    setup.dx = setup.dy = 1e-4;
    CHECK(refused([&] { solve(setup, WheelRailState{}); }) == "dx");
}

TEST_CASE("Elements of the contacts of simplified models are bounded as those of full ones") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.model = GENERATE(Model::full, Model::hertz);
    setup.dx = setup.dy = 1e-3;
    WheelRailState state;
    state.position.z = 0.05;
    CHECK(refused([&] { solve(setup, state); }) == "dx");
}

TEST_CASE("Slices that are files have a bounded number of points together") {
    std::string text;
    for (int i = 0; i < 15000; ++i) text += std::to_string(-36 + 72. * i / 15000) + " 0\n";
    const ProfileSpec file{ProfileKind::rail, ProfileFile{.name = "a.txt", .text = text, .mirror_z = false}};
    WheelRailSetup setup = cylinder_on_arc(300);
    for (int i = 0; i < 20; ++i) setup.rail_slices.push_back({10. * i, file, {0, 1e5}});
    CHECK(refused([&] { WheelRailContact contact(setup); }) == "rail_slices");
    setup.rail_slices.resize(3);
    CHECK(refused([&] { WheelRailContact contact(setup); }).empty());
}

TEST_CASE("Profiles that leap up and down are refused where their length makes the stations") {
    const ProfileCurve flat = make_profile({ProfileKind::rail, ArcProfile{300, 0, -40, 40}}).curve,
                       long_one = leaping(1e5);
    CHECK(refused([&] { geometry::SlicedRail({{0, long_one}, {100, long_one}}); }) == "rail_slices");
    CHECK(refused([&] { geometry::OutOfRound({0, 1}, {long_one, long_one}); }) == "wheel_slices[0].profile");
    CHECK(refused([&] { contacts_at(wheelset_on_track(long_one, flat, {}, {}), 0); }) == "wheel");
}

// Tests friction between places along the track.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <string>
#include <utility>
#include <vector>

#include "contact_file_cases.hpp"
#include "contactd/friction_along_track.hpp"

using namespace contactd;
using namespace contactd::contact_file_cases;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinRel;

namespace {

using Track = std::vector<ContactFrictionAtPlace>;

/// Returns the difference over 10 m, half-way, or 0 if it is small enough.
double difference(int law, std::vector<double> one, std::vector<double> other) {
    const auto thin = thin_friction(law, {{0, std::move(one)}, {1e4, std::move(other)}}, 5e3);
    return thin ? thin->difference : 0;
}

}  // namespace

TEST_CASE("numbers of friction are interpolated between places, and constant beyond them", "[contact_files]") {
    const Track track{{-10, {0.2, 0.1, 50, 0, 1}}, {10, {0.4, 0, 150, 0.2, 3}}, {20, {0.5, 0, 0, 0, 0}}};
    CHECK(friction_along_track(track, 0) == std::vector<double>{0.2 + 0.5 * (0.4 - 0.2), 0.05, 100, 0.1, 2});
    for (const auto& [place, values] : track) CHECK(friction_along_track(track, place) == values);
    CHECK(friction_along_track(track, -1e6) == track.front().values);
    CHECK(friction_along_track(track, 1e6) == track.back().values);
    CHECK_THAT(friction_along_track(track, 12.5)[0], WithinRel(0.425, 1e-15));
    const Track equal{{0, {0.3, 0.1, 7}}, {1, {0.3, 0.1, 7}}};
    CHECK(friction_along_track(equal, 1.0 / 3) == equal.front().values);
}

TEST_CASE("coefficients that differ over metres are too thin, and others are not", "[contact_files]") {
    const Track track{{0, {0.2, 0.2}}, {2900, {0.4, 0.4}}, {6100, {0.6, 0.6}}, {9200, {0.65, 0.65}}};
    const auto thin = thin_friction(0, track, 3000);
    REQUIRE(thin);
    CHECK(thin->from == 2900);
    CHECK(thin->to == 6100);
    CHECK_THAT(thin->difference, WithinRel(0.2, 1e-12));
    for (const double place : {-100.0, 0.0, 1450.0, 2900.0, 6100.0, 8000.0, 9200.0, 1e5})
        CHECK_FALSE(thin_friction(0, track, place));
}

TEST_CASE("laws differ where they bend, whatever they are at rest", "[contact_files]") {
    // FKIN + F1 2^(-v/s): at 100 mm/s one half of one term remains, and almost nothing of the other.
    CHECK_THAT(difference(4, {0.1, 0.4, 100, 0, 1}, {0.1, 0.4, 1, 0, 1}), WithinRel(0.2, 1e-12));
    // FKIN + F1 max(0, 1 - v/(2 s))
    CHECK_THAT(difference(2, {0.1, 0.4, 100, 0, 1}, {0.1, 0.4, 50, 0, 1}), WithinRel(0.2, 1e-12));
    // FKIN + F1/(1 + v/s) + F2/(1 + (v/s)^2): at 100 mm/s 1/2 and 1/5 of 0.5 remain.
    CHECK_THAT(difference(3, {0.1, 0.5, 100, 0, 1}, {0.1, 0, 1, 0.5, 50}), WithinRel(0.15, 1e-12));
    CHECK(difference(4, {0.3, 0.1, 100, 0, 1}, {0.3, 0.1, 120, 0, 1}) == 0);
    CHECK_THAT(difference(4, {0.1, 0.3, 100, 0, 1}, {0.3, 0.1, 100, 0, 1}), WithinRel(0.2, 1e-12));
    // The law is a straight line from (TREF, FREF) to (TREF + DTHEAT, FREF + DFHEAT): at 120 degrees 0.2 and 0.4.
    CHECK_THAT(difference(6, {0.4, 20, -0.2, 100}, {0.4, 120, -0.2, 100}), WithinRel(0.2, 1e-12));
    CHECK(difference(6, {0.4, 20, -0.2, 100}, {0.4, 30, -0.2, 100}) == 0);
}

TEST_CASE("a case between places that are too far apart is warned of", "[contact_files]") {
    RailCase rail;
    rail.digits = "1203100\n2022033\n0000001\n";
    rail.friction = "3 NVF\n0. 0.2 0.2\n10000. 0.4 0.4\n12000. 0.2 0.2\n";
    const auto warnings_at = [&](const std::string& place) {
        rail.position = place + " 1.5 10000. 0.001 0. 0.\n";
        std::string all;
        for (const std::string& warning : last_of(rail.text()).warnings) all += warning;
        return all;
    };
    CHECK_THAT(warnings_at("6000."), ContainsSubstring("S_WS = 6000, between friction at SVF = 0 and 10000 mm") &&
                                         ContainsSubstring("differ by 0.2"));
    CHECK(warnings_at("10000.").empty());
    CHECK(warnings_at("11000.").empty());
    CHECK(warnings_at("-5.").empty());
    rail.digits = "1203100\n2422033\n0000001\n";
    rail.friction = "2 NVF\n0. 0.2 0.1 100. 0. 0.\n10000. 0.2 0.3 100. 0. 0.\n0. 1.\n";
    CHECK_THAT(warnings_at("6000."), ContainsSubstring("differ by 0.2"));
}

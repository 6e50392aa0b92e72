// Tests the conversion of a profile's value to its curve, and its refusals.
#include "contactd/make_profile.hpp"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <random>

#include "contactd/error.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;

namespace {

/// Returns points half a millimetre apart, as an instrument measures them.
ProfilePoints measured(const ProfileSpec& spec, double noise = 0) {
    const ProfileCurve curve = make_profile(spec).curve;
    std::mt19937 dice(7);
    std::normal_distribution<double> error(0, noise > 0 ? noise : 1);
    ProfilePoints given;
    for (double s = 0; s <= curve.end(); s += 0.5) {
        given.points.push_back(curve.at(s));
        if (noise > 0) given.points.back().z += error(dice);
    }
    return given;
}

const ProfileSpec wheel{ProfileKind::wheel, S1002{}}, rail{ProfileKind::rail, Rail60E1{0.025}};

/// Across both curves (mm).
double largest_difference(const ProfileCurve& a, const ProfileCurve& b, double from, double to) {
    double most = 0;
    for (double y = from; y <= to; y += 0.1) {
        const double s = a.s_at_y(y);
        most = std::max(most, std::abs(std::cos(a.angle(s)) * (a.at(s).z - b.at(b.s_at_y(y)).z)));
    }
    return most;
}

void refused(ProfileKind kind, const ProfilePoints& given, const std::string& what) {
    CHECK_THROWS_MATCHES(make_profile({kind, given}), InvalidArgument, MessageMatches(ContainsSubstring(what)));
}

}  // namespace

TEST_CASE("points give the curve that they were taken from", "[profile]") {
    const auto given = measured(wheel);
    const Profile made = make_profile({ProfileKind::wheel, given});
    CHECK(made.kind == ProfileKind::wheel);
    CHECK(made.evidence.points_given == given.points.size());
    CHECK(made.evidence.largest_distance == 0);
    CHECK(largest_difference(made.curve, make_profile(wheel).curve, -60, 59) < 5e-4);
    CHECK(made.curve.y_is_monotone());
}

TEST_CASE("units, mirroring and order do not change a profile", "[profile]") {
    const auto& [kind, spec] = GENERATE(std::pair(ProfileKind::wheel, wheel), std::pair(ProfileKind::rail, rail));
    const auto given = measured(spec);
    const Profile made = make_profile({kind, given});
    ProfilePoints other = given;
    other.unit = 1000;
    other.mirror_y = other.mirror_z = true;
    for (ProfilePoint& point : other.points) point = {-point.y / 1000, -point.z / 1000};
    if (GENERATE(true, false)) std::reverse(other.points.begin(), other.points.end());
    const Profile same = make_profile({kind, other});
    REQUIRE(same.curve.points().size() == made.curve.points().size());
    CHECK(largest_difference(same.curve, made.curve, -35, 25) < 1e-12);
    CHECK(same.curve.points().front().y < same.curve.points().back().y);
}

TEST_CASE("smoothing takes noise away, and states how far the points are from the curve", "[profile]") {
    auto given = measured(rail, 0.003);
    const ProfileCurve exact = make_profile(rail).curve;
    const Profile rough = make_profile({ProfileKind::rail, given});
    given.smoothing_length = 5;
    const Profile smooth = make_profile({ProfileKind::rail, given});
    const auto bumps = [&](const Profile& profile) {
        double most = 0;
        for (double y = -15; y < 15; y += 0.1)
            most = std::max(
                most, std::abs(profile.curve.curvature(profile.curve.s_at_y(y)) - exact.curvature(exact.s_at_y(y))));
        return most;
    };
    CHECK(bumps(smooth) < 0.2 * bumps(rough));
    CHECK(smooth.evidence.rms_distance > 0.001);
    CHECK(smooth.evidence.rms_distance < 0.004);
    CHECK(smooth.evidence.largest_distance > smooth.evidence.rms_distance);
    CHECK(largest_difference(smooth.curve, exact, -25, 15) < 0.5 * largest_difference(rough.curve, exact, -25, 15));
}

TEST_CASE("of an inclined head remains what is seen from above", "[profile]") {
    const double inclination = GENERATE(0.0, 1.0 / 40, 1.0 / 20, 1.0 / 10);
    const Profile made = make_profile({ProfileKind::rail, Rail60E1{inclination}});
    CHECK(made.curve.y_is_monotone());
    CHECK((made.evidence.points_kept < made.evidence.points_given) == (inclination > 0.04));
}

TEST_CASE("kinks survive smoothing", "[profile]") {
    ProfilePoints roof;
    for (int i = -40; i <= 40; ++i) roof.points.push_back({0.5 * i, 0.4 * std::abs(i)});
    roof.smoothing_length = 10;
    const Profile made = make_profile({ProfileKind::rail, roof});
    CHECK(made.curve.kinks() == std::vector<std::size_t>{40});
    CHECK(made.evidence.largest_distance < 1e-9);  // both sides are straight
    roof.points.erase(roof.points.begin() + 40);
    CHECK(make_profile({ProfileKind::rail, roof}).evidence.largest_distance > 1e-3);  // two turns are not a kink
}

TEST_CASE("nothing swings out below a lip, and what it hides has its part in smoothing", "[profile]") {
    ProfilePoints worn;
    for (int i = 0; i <= 100; ++i) worn.points.push_back({35 - 0.5 * i, std::pow((35 - 0.5 * i) / 35, 2) * 5});
    for (int i = 0; i < 40; ++i)  // a lip that is 1 mm wide, 3.5 mm high, before a face that recedes
        worn.points.push_back({-15 - std::exp(-std::pow((i - 14) / 7.0, 2)) + 0.02 * i, 1.5 + 0.25 * i});
    worn.points.push_back({-16, 30});
    const Profile rough = make_profile({ProfileKind::rail, worn});
    REQUIRE(rough.evidence.warnings.size() == 1);
    CHECK_THAT(rough.evidence.warnings[0], ContainsSubstring("(-16, 30)") && ContainsSubstring("hidden from above"));
    const auto widest = [](const ProfileCurve& curve) {
        double least = 0;
        for (double s = curve.begin(); s < curve.end(); s += 0.01)
            if (curve.at(s).z < 25) least = std::min(least, curve.at(s).y);
        return least;
    };
    CHECK_THAT(widest(rough.curve), WithinAbs(-15.725, 3e-3));
    worn.smoothing_length = 4;
    // The bump decreases about equally on both sides, and would decrease less at an end.
    CHECK_THAT(widest(make_profile({ProfileKind::rail, worn}).curve), WithinAbs(-15.60, 0.06));
}

TEST_CASE("points that make no profile are refused with what to do", "[profile]") {
    const auto good = measured(wheel);
    refused(ProfileKind::wheel, {}, "profile.points has 0 entries; a profile needs at least two");
    refused(ProfileKind::rail, {{{1, 1}}}, "profile.points has 1 entries; a profile needs at least two");
    refused(ProfileKind::rail, {{{1, 1}, {1, 1}, {1, 1}}}, "span less than 1 mm");
    auto bad = good;
    bad.points[7].z = std::nan("");
    refused(ProfileKind::wheel, bad, "profile.points[7] is (");
    bad = good;
    bad.points[9].y = std::numeric_limits<double>::infinity();
    refused(ProfileKind::wheel, bad, "must be finite");
    bad = good;
    std::shuffle(bad.points.begin(), bad.points.end(), std::mt19937(3));
    refused(ProfileKind::wheel, bad, "cross themselves");
    bad = good;
    std::swap_ranges(bad.points.begin() + 50, bad.points.begin() + 80, bad.points.begin() + 150);
    refused(ProfileKind::wheel, bad, "order the points along the profile");
    bad = good;
    bad.mirror_z = true;
    refused(ProfileKind::wheel, bad, "change mirror_z");
    // Its faces are as deep as its flange is high.
    const ProfilePoints with_faces{{{-70, -21},
                                    {-69, 9},
                                    {-60, 26},
                                    {-55, 28},
                                    {-48, 24},
                                    {-40, 14},
                                    {-36, 8},
                                    {-30, 3.6},
                                    {-20, 1.4},
                                    {-10, .5},
                                    {0, 0},
                                    {20, -1},
                                    {60, -3},
                                    {66, -8},
                                    {66.5, -20.5}}};
    CHECK_NOTHROW(make_profile({ProfileKind::wheel, with_faces}));
    bad = with_faces;
    bad.mirror_z = true;
    refused(ProfileKind::wheel, bad, "change mirror_z");
    bad = good;
    bad.mirror_y = true;
    refused(ProfileKind::wheel, bad, "the flange at y = 5");
    bad = measured(rail);
    bad.mirror_z = true;
    refused(ProfileKind::rail, bad, "have both ends near the top");
    bad = good;
    bad.unit = 1e4;
    refused(ProfileKind::wheel, bad, "or the unit");
    bad.unit = 0.001;
    refused(ProfileKind::wheel, bad, "check their unit");
    ProfilePoints loop;
    for (int i = 0; i < 100; ++i) loop.points.push_back({30 * std::sin(0.1 * i), 30 * std::cos(0.13 * i)});
    refused(ProfileKind::rail, loop, "cross themselves: the chord from (");
}

TEST_CASE("no points whatever crash, hang or make a curve that is not one", "[profile]") {
    std::mt19937 dice(11);
    std::uniform_real_distribution<double> share(-1, 1);
    int made = 0;
    for (int round = 0; round < 3000; ++round) {
        auto given = measured(round % 2 ? wheel : rail);
        given.points.resize(1 + dice() % given.points.size());
        for (unsigned change = dice() % 8; change-- > 0;) {
            ProfilePoint& point = given.points[dice() % given.points.size()];
            switch (dice() % 6) {
                case 0:
                    point.y += share(dice);
                    break;
                case 1:
                    point.z *= -1;
                    break;
                case 2:
                    point = given.points[dice() % given.points.size()];
                    break;
                case 3:
                    point.y = std::pow(10.0, 300 * share(dice));
                    break;
                case 4:
                    point.z = std::nan("");
                    break;
                default:
                    given.smoothing_length = std::pow(10.0, 3 * share(dice));
            }
        }
        try {
            const Profile profile = make_profile({round % 2 ? ProfileKind::wheel : ProfileKind::rail, given});
            ++made;
            REQUIRE(std::isfinite(profile.curve.arc_length(profile.curve.end())));
            REQUIRE(profile.curve.end() >= 1);
        } catch (const InvalidArgument& refusal) {
            INFO(refusal.what());
            REQUIRE(refusal.field().starts_with("profile."));
        }
    }
    CHECK(made > 300);
    CHECK(made < 2900);
}

// Tests equivalent conicity against cones, arcs, and the motion integrated step by step.
#include "contactd/equivalent_conicity.hpp"

#include "contactd/conicity_warnings.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>

#include "contactd/error.hpp"
#include "contactd/make_profile.hpp"
#include "geometry/conicity/radius_difference.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;

WheelsetOnTrack on_60e1(const ProfileShape& wheel, double inclination) {
    return wheelset_on_track(make_profile({ProfileKind::wheel, wheel}).curve,
                             make_profile({ProfileKind::rail, Rail60E1{inclination}}).curve);
}

/// Returns half a wavelength over sqrt(2e r0), by Runge-Kutta steps from rest until the motion rests again.
double half_swing_by_steps(const geometry::RadiusDifference& difference, double amplitude) {
    double y = amplitude, velocity = 0, length = 0;
    const double step = 1e-3;
    while (true) {
        const double v0 = velocity, v1 = v0 - step / 2 * difference(y), y2 = y + step / 2 * v1,
                     v2 = v0 - step / 2 * difference(y + step / 2 * v0), v3 = v0 - step * difference(y2);
        const double slope =
            (difference(y) + 2 * difference(y + step / 2 * v0) + 2 * difference(y2) + difference(y + step * v2)) / 6;
        const double next = velocity - step * slope;
        if (next > 0 && velocity < 0) return length + step * velocity / (velocity - next);
        y += step * (v0 + 2 * v1 + 2 * v2 + v3) / 6;
        velocity = next;
        length += step;
    }
}

}  // namespace

TEST_CASE("a cone has its own conicity, whatever the amplitude", "[conicity]") {
    const std::vector<double> amplitudes{1, 3, 8};
    for (const auto& found : equivalent_conicities(on_60e1(ConeProfile{-0.05, -60, 60}, 1.0 / 40), amplitudes)) {
        CHECK_THAT(found.integrated, WithinAbs(0.05, 1e-9));
        CHECK_THAT(found.harmonic, WithinAbs(0.05, 1e-9));
        CHECK_THAT(found.wavelength, WithinRel(2 * pi * std::sqrt(750 * 460 / 0.05), 1e-8));  // Klingel
    }
}

TEST_CASE("with roll a cone rolls as its closed form", "[conicity]") {
    const double R = 300, angle = 0.01, closed = angle * (750 + R * angle) / (750 - 460 * angle);
    const WheelOverRail pair{make_profile({ProfileKind::wheel, ConeProfile{-std::tan(angle), -60, 60}}).curve,
                             make_profile({ProfileKind::rail, ArcProfile{R, -std::tan(angle)}}).curve,
                             750,
                             {750, 0}};
    const std::vector<double> amplitudes{1};
    const auto found = equivalent_conicities({pair, pair}, amplitudes, {WheelsetRoll::demanded}).front();
    CHECK_THAT(found.integrated, WithinRel(closed, 1e-3));
    CHECK_THAT(found.harmonic, WithinRel(found.integrated, 1e-3));
}

TEST_CASE("arcs on arcs have the conicity of their closed form", "[conicity]") {
    const double Rw = 500, Rr = 300, lean = std::atan(0.05);
    const WheelOverRail pair{make_profile({ProfileKind::wheel, ArcProfile{Rw, -0.05}}).curve,
                             make_profile({ProfileKind::rail, ArcProfile{Rr, -0.05}}).curve,
                             750,
                             {750, 0}};
    const std::vector<double> amplitudes{0.1};
    const auto found = equivalent_conicities({pair, pair}, amplitudes).front();
    CHECK_THAT(found.integrated, WithinRel(Rw / (Rw - Rr) * std::tan(lean), 1e-5));
    CHECK_THAT(found.harmonic, WithinRel(found.integrated, 1e-5));
}

TEST_CASE("the energy integral gives the wavelength of the motion integrated step by step", "[conicity]") {
    const auto stiffening = [](double y) { return 0.1 * y + 0.02 * y * y * y; };
    const auto jump = [](double y) { return y > 2 ? 1 + 0.1 * y : y < -2 ? -1 + 0.1 * y : 0.1 * y; };
    for (const geometry::RadiusDifference& difference :
         {geometry::RadiusDifference({-6, 6}, 1e-4, stiffening), geometry::RadiusDifference({-6, 6}, 1e-4, jump)})
        for (const double amplitude : {1.0, 3.0, 5.0})
            CHECK_THAT(difference.half_swing(amplitude), WithinRel(half_swing_by_steps(difference, amplitude), 2e-3));
    CHECK_THAT(geometry::RadiusDifference({-6, 6}, 1e-4, stiffening).harmonic(3),
               WithinRel(0.05 + 0.01 * 0.75 * 9, 1e-4));
}

TEST_CASE("just beyond a leap, the motion is that of its closed form", "[conicity]") {
    // The wheel H on the rail A of EN 15302 has nearly this difference: k y, and h more beyond the shift s.
    const double k = 0.05, h = 2.254, s = 2.49847;
    const auto leap = [&](double y) { return k * y + (y > s ? h : y < -s ? -h : 0); };
    const geometry::RadiusDifference difference({-6, 6}, 1e-4, leap);
    for (const double beyond : {0.0015, 0.1, 1.0}) {
        const double amplitude = s + beyond;
        const double before = std::asin(s / std::sqrt(amplitude * amplitude + 2 * h * beyond / k)),
                     behind = pi / 2 - std::asin((s + h / k) / (amplitude + h / k));
        CHECK_THAT(difference.half_swing(amplitude), WithinRel(2 / std::sqrt(k) * (before + behind), 1e-4));
    }
    CHECK_THAT(difference.half_swing(2.49), WithinRel(pi / std::sqrt(k), 1e-4));
}

TEST_CASE("a motion around another middle is that around zero", "[conicity]") {
    const auto cubic = [](double y) { return 0.1 * y + 0.02 * y * y * y; };
    const geometry::RadiusDifference centred({-6, 6}, 1e-4, cubic),
        beside({-6, 6}, 1e-4, [&](double y) { return cubic(y - 0.4); });
    CHECK_THAT(beside.half_swing(3), WithinRel(centred.half_swing(3), 1e-5));
    CHECK_THAT(beside.harmonic(3), WithinRel(centred.harmonic(3), 1e-5));
}

TEST_CASE("what does not swing has no wavelength", "[conicity]") {
    const geometry::RadiusDifference away({-6, 6}, 1e-4, [](double y) { return -0.1 * y; });
    CHECK(std::isnan(away.half_swing(2)));
    const geometry::RadiusDifference aside({-6, 6}, 1e-4, [](double) { return 1.0; });
    CHECK(std::isnan(aside.half_swing(2)));
    CHECK(std::isnan(aside.harmonic(2)));
}

TEST_CASE("wheels of unequal radii swing around where they roll alike", "[conicity]") {
    const double r0 = GENERATE(459.0, 461.0, 459.9);
    const std::vector<double> amplitudes{1, 3};
    const auto cone = on_60e1(ConeProfile{-0.05, -60, 60}, 1.0 / 40);
    auto unequal = cone;
    unequal.left.nominal_radius = r0;
    for (const auto& found : equivalent_conicities(unequal, amplitudes)) {
        CHECK_THAT(found.integrated, WithinAbs(0.05, 1e-7));
        CHECK_THAT(found.harmonic, WithinAbs(0.05, 1e-7));
        CHECK_THAT(found.wavelength, WithinRel(2 * pi * std::sqrt(750 * (460 + r0) / 2 / 0.05), 1e-6));
    }
}

TEST_CASE("unequal radii shift the radius difference, and the swing with it", "[conicity]") {
    const auto equal = [](double y) { return 0.1 * y + 0.02 * y * y * y; };
    const auto unequal = [&](double y) { return equal(y) + 1; };
    geometry::RadiusDifference near({-4, 4}, 1e-5, unequal);
    CHECK(std::isnan(near.centre(3)));
    CHECK(near.side_of_centre(3) == -1);
    near.extend({-9, 4});
    // In closed form the potential is 0.05 y^2 + 0.005 y^4 + y, and 0.1 y + 0.01 (2 y^3 + 2 y A^2) + 1 is zero.
    const double centre = near.centre(3);
    CHECK_THAT(0.1 * centre + 0.02 * (centre * centre * centre + 9 * centre) + 1, WithinAbs(0, 1e-4));
    CHECK_THAT(near.half_swing(3), WithinRel(geometry::RadiusDifference({-9, 9}, 1e-5, unequal).half_swing(3), 1e-5));
}

TEST_CASE("cylinders have no conicity", "[conicity]") {
    const auto amplitude = GENERATE(0.01, 1.0, 5.0);
    const auto shape = GENERATE(ProfileShape{ConeProfile{0, -60, 60}},
                                ProfileShape{ProfilePoints{{{-60, 0}, {-20, 0}, {5, 0}, {60, 0}}}});
    const auto roll = GENERATE(WheelsetRoll::neglected, WheelsetRoll::demanded);
    const auto found = equivalent_conicities(on_60e1(shape, 1.0 / 40), std::vector{amplitude}, {roll}).front();
    CHECK(found.integrated == 0);
    CHECK(found.harmonic == 0);
    CHECK(std::isinf(found.wavelength));
}

TEST_CASE("where the radius difference is zero for a while, so is the conicity, and grows beyond", "[conicity]") {
    const auto idle = [](double y) { return y > 2 ? y - 2 : y < -2 ? y + 2 : 0; };
    const geometry::RadiusDifference difference({-6, 6}, 1e-4, idle);
    CHECK(std::isinf(difference.half_swing(1)));
    CHECK(difference.harmonic(1) == 0);
    CHECK_THAT(difference.half_swing(4), WithinRel(half_swing_by_steps(difference, 4), 2e-3));
    const geometry::RadiusDifference rough({-6, 6}, 1e-3, [&](double y) { return idle(y) - 2e-4 * std::sin(y); });
    CHECK(std::isinf(rough.half_swing(1)));
}

TEST_CASE("cylinders of unequal radii never swing back", "[conicity]") {
    auto wheelset = on_60e1(ConeProfile{0, -60, 60}, 1.0 / 40);
    wheelset.left.nominal_radius = 459;
    const auto found = equivalent_conicities(wheelset, std::vector{1.0}).front();
    CHECK(std::isnan(found.integrated));
    CHECK(std::isnan(found.harmonic));
}

TEST_CASE("a wheelset on rollers has no equivalent conicity", "[conicity]") {
    auto wheelset = on_60e1(S1002{}, 1.0 / 40);
    wheelset.left.roller_radius = 500;
    CHECK_THROWS_MATCHES(equivalent_conicities(wheelset, std::vector{1.0}), InvalidArgument,
                         MessageMatches(ContainsSubstring("left.track.roller_radius is 500")));
}

TEST_CASE("S1002 on 60E1 has the conicity that its profiles give point by point", "[conicity]") {
    const double inclination = GENERATE(1.0 / 40, 1.0 / 20);
    const auto wheelset = on_60e1(S1002{}, inclination);
    const auto& [wheel, rail, wheel_origin, rail_origin, nominal_radius, roller_radius] = wheelset.right;
    const auto radius = [&](double shift) {  // of the point with the smallest gap
        double least = 1e9, z_there = 0;
        for (double y = -45; y < 45; y += 0.02) {
            const double z = wheel.at(wheel.s_at_y(y)).z, on_rail = y + shift + wheel_origin - rail_origin.y;
            if (on_rail < -36 || on_rail > 34) continue;
            if (const double gap = rail.at(rail.s_at_y(on_rail)).z - z; gap < least) least = gap, z_there = z;
        }
        return z_there;
    };
    const double amplitude = 3;
    double sum = 0;
    const int turn = 180;
    for (int k = 0; k < turn; ++k) {
        const double sine = std::sin(2 * pi * (k + 0.5) / turn);
        sum += (radius(amplitude * sine) - radius(-amplitude * sine)) / 2 * sine;
    }
    const double expected = 2 * sum / turn / amplitude;
    const auto found = equivalent_conicities(wheelset, std::vector{amplitude}).front();
    CHECK_THAT(found.harmonic, WithinRel(expected, 0.02));
    CHECK_THAT(found.integrated, WithinRel(expected, 0.03));
}

TEST_CASE("S1002 on 60E1 is conical on rails of 1/40, and hardly so on rails of 1/20 before its flange touches",
          "[conicity]") {
    const std::vector<double> amplitudes{1, 2, 3, 4, 5, 6, 7, 8};
    const auto steep = equivalent_conicities(on_60e1(S1002{}, 1.0 / 40), amplitudes);
    const auto flat = equivalent_conicities(on_60e1(S1002{}, 1.0 / 20), amplitudes);
    for (std::size_t k = 0; k < amplitudes.size(); ++k) {
        INFO(amplitudes[k] << " mm: " << steep[k].integrated << ", " << flat[k].integrated);
        CHECK(steep[k].integrated > flat[k].integrated);
        CHECK_THAT(steep[k].harmonic, WithinRel(steep[k].integrated, 0.2));
        CHECK((flat[k].integrated < 0.012) == (amplitudes[k] < 6.5));
        CHECK(std::isfinite(flat[k].wavelength));
    }
}

TEST_CASE("amplitudes beyond a profile's end are refused", "[conicity]") {
    const auto wheelset = wheelset_on_track(make_profile({ProfileKind::wheel, ArcProfile{400, -0.05, -10, 10}}).curve,
                                            make_profile({ProfileKind::rail, Rail60E1{1.0 / 40}}).curve);
    CHECK(equivalent_conicities(wheelset, std::vector{1.0}).front().integrated > 0.05);
    CHECK_THROWS_MATCHES(equivalent_conicities(wheelset, std::vector{6.0}), InvalidArgument,
                         MessageMatches(ContainsSubstring("amplitudes reach 6 mm, but at the shift -")));
}

TEST_CASE("amplitudes, distances and shifts in metres are warned of", "[conicity]") {
    const auto sentence = [](const std::vector<std::string>& warnings) {
        REQUIRE(warnings.size() == 1);
        return warnings.front();
    };
    CHECK(sentence(unit_warnings(ConicityRequest{{0.01, 0.03}})) ==
          "conicity.amplitudes are at most 0.03 mm, smaller than any motion of a wheelset on its track. Give "
          "amplitudes in "
          "mm, not in m. If it is in m, it is 30 mm.");
    CHECK(sentence(unit_warnings(ConicityRequest{{3}, {.contact_distance = 1.5}})) ==
          "conicity.contact_distance is 1.5 mm, less than the distance of the rails of any track. Give it in mm, not "
          "in m. "
          "If it is in m, it is 1500 mm.");
    CHECK(sentence(unit_warnings(ContactsRequest{{-0.006, 0, 0.003}})) ==
          "contacts.shifts are at most 0.006 mm, micrometres from the track centre. Give lengths in mm, not in m. If "
          "it is "
          "in m, it is 6 mm.");
    CHECK(unit_warnings(ConicityRequest{{0.01, 3}}).empty());
    CHECK(unit_warnings(ContactsRequest{{0}}).empty());
    CHECK(unit_warnings(ContactsRequest{{-6, 0, 6}}).empty());
}

TEST_CASE("amplitudes and settings that make no sense are refused", "[conicity]") {
    const auto wheelset = on_60e1(ConeProfile{-0.05, -60, 60}, 0);
    const auto refused = [&](double amplitude, const ConicitySettings& settings, const std::string& what) {
        const std::vector<double> amplitudes{3, amplitude};
        CHECK_THROWS_MATCHES(equivalent_conicities(wheelset, amplitudes, settings), InvalidArgument,
                             MessageMatches(ContainsSubstring(what)));
    };
    refused(0, {}, "amplitudes[1] is 0");
    refused(std::nan(""), {}, "amplitudes[1] is nan");
    refused(100, {}, "amplitudes[1] is 100");
    refused(1, {WheelsetRoll::neglected, 0}, "contact_distance is 0");
    refused(1, {WheelsetRoll::neglected, 1500, 1e-9}, "tolerance is 1e-09");
    CHECK(equivalent_conicities(wheelset, {}).empty());
}

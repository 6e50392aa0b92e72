// Compares the search and the gaps with brute force over the surfaces, implemented again here.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contactd/make_profile.hpp"
#include "geometry/position.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;

namespace {

/// Holds profiles that are functions z(y), as in the set-up.
class Surfaces {
   public:
    Surfaces(const WheelRailSetup& setup, const WheelRailState& state)
        : setup_(setup), state_(state), profiles_(geometry::make_profiles(setup)) {}

    /// Returns z of the rail at a point of the track.
    double rail(double x, double y) const {
        const double in_profile = y - profiles_.rail_origin.y;  // neither cant nor roll
        const double z = profiles_.rail.at(profiles_.rail.s_at_y(in_profile)).z + profiles_.rail_origin.z;
        if (!setup_.track.roller_radius) return z;
        const double axle = *setup_.track.roller_radius + profiles_.rail_origin.z;
        return axle - std::sqrt((axle - z) * (axle - z) - x * x);
    }

    /// Returns the distance of a point of the track from the wheelset's axle minus that of the wheel's surface, at a
    /// prescribed z.
    double outside_wheel(double x, double y, double z, double z_ws) const {
        const double roll = state_.position.roll, yaw = state_.position.yaw;
        const double dy = y - state_.position.y, dz = z - (z_ws - setup_.wheelset.nominal_radius);
        const double unrolled_y = std::cos(roll) * dy + std::sin(roll) * dz;
        const double unrolled_z = -std::sin(roll) * dy + std::cos(roll) * dz;
        const double along = std::cos(yaw) * x + std::sin(yaw) * unrolled_y;
        const double side = -std::sin(yaw) * x + std::cos(yaw) * unrolled_y;
        const Wheelset& wheelset = setup_.wheelset;
        const double in_profile = side - (wheelset.flange_back_distance / 2 - wheelset.flange_back_position);
        const double radius = wheelset.nominal_radius + profiles_.wheel.at(profiles_.wheel.s_at_y(in_profile)).z;
        return std::hypot(along, unrolled_z) - radius;
    }

    /// z of the wheel below (x, y).
    double wheel(double x, double y, double z_ws) const {
        double low = z_ws - 100, high = z_ws + 100;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (outside_wheel(x, y, middle, z_ws) > 0 ? high : low) = middle;
        }
        return low;
    }

    const geometry::Profiles& profiles() const { return profiles_; }

   private:
    const WheelRailSetup& setup_;
    const WheelRailState& state_;
    geometry::Profiles profiles_;
};

WheelRailState random_position(int seed) {
    WheelRailState state;
    state.position = {-8 + 4.1 * seed, 0, 0.002 * seed - 0.006, 0.02 - 0.008 * seed};
    return state;
}

}  // namespace

TEST_CASE("The clearance is the least vertical distance over both surfaces") {
    WheelRailSetup setup;
    if (GENERATE(false, true)) setup.track.roller_radius = 800;
    const WheelRailState state = random_position(GENERATE(0, 1, 2, 3, 4));
    setup.patches.locus_step = 0.01;  // rows 0.002 mm apart
    const Surfaces surfaces(setup, state);
    const geometry::Position position(setup, surfaces.profiles(), state);
    // Searches around the locus with decreasing steps.
    double least = 1e9, x = 0, y = 750, reach_x = 60, reach_y = 40;
    for (int round = 0; round < 7; ++round) {
        const double middle_x = x, middle_y = y;
        for (int i = -40; i <= 40; ++i)
            for (int j = -40; j <= 40; ++j) {
                const double at_x = middle_x + reach_x * i / 40, at_y = middle_y + reach_y * j / 40;
                const double gap = surfaces.rail(at_x, at_y) - surfaces.wheel(at_x, at_y, 0);
                if (gap < least) {
                    least = gap;
                    x = at_x;
                    y = at_y;
                }
            }
        reach_x *= 0.2;
        reach_y *= 0.2;
    }
    CHECK_THAT(position.clearance(0), WithinAbs(least, 1e-5));
}

TEST_CASE("Gaps end on both surfaces, along the normal of the plane") {
    WheelRailSetup setup;
    setup.wheel_surface = GENERATE(WheelSurfaceKind::exact, WheelSurfaceKind::bilinear);
    if (GENERATE(false, true)) setup.track.roller_radius = 800;
    const WheelRailState state = random_position(GENERATE(0, 2, 4));
    const Surfaces surfaces(setup, state);
    geometry::Position position(setup, surfaces.profiles(), state);
    const double z_ws = position.clearance(0) + 0.05;
    auto candidates = position.candidates(z_ws);
    REQUIRE_FALSE(candidates.empty());
    for (geometry::CandidatePatch& found : candidates) {
        position.measure(found, z_ws);
        const ContactPlace& place = found.place;
        const std::vector<double>& gap = found.gap;
        const auto& [x_c, y_c, z_c, angle] = place.reference;
        const double c = std::cos(angle), s = std::sin(angle);
        CHECK(place.approach > 0);
        CHECK_THAT(*std::min_element(gap.begin(), gap.end()), WithinAbs(0, 1e-15));
        for (int iy = 0; iy < place.grid.ny; iy += 5)
            for (int ix = 0; ix < place.grid.nx; ix += 5) {
                const double x = x_c + place.grid.x(ix), t = place.grid.y(iy);
                const double h = gap[static_cast<std::size_t>(iy * place.grid.nx + ix)] - place.approach;
                // Finds the rail's height by bisection; the wheel's is lower by h.
                double low = -5, high = 5;
                for (int i = 0; i < 60; ++i) {
                    const double n = 0.5 * (low + high), y = y_c + c * t - s * n, z = z_c + s * t + c * n;
                    (z > surfaces.rail(x, y) ? high : low) = n;
                }
                const double n = low - h, y = y_c + c * t - s * n, z = z_c + s * t + c * n;
                const double accuracy = setup.wheel_surface == WheelSurfaceKind::exact ? 1e-8 : 1e-3;
                CHECK_THAT(surfaces.outside_wheel(x, y, z, z_ws), WithinAbs(0, accuracy));
            }
    }
}

TEST_CASE("Regions far apart are patches of their own, and close ones are one") {
    // Creates a rail with two humps under a cylinder, 4 mm wide in contact.
    WheelRailSetup setup;
    setup.wheel.shape = ConeProfile{0, -40, 40};
    const double apart = GENERATE(8.0, 12.0, 15.0, 40.0);
    ProfilePoints rail;
    for (double y = -40; y <= 40; y += 0.25) {
        const double d = std::abs(y) - apart / 2;
        rail.points.push_back({y, d * d / 160 + 1e-4 * std::abs(y)});
    }
    setup.rail.shape = rail;
    setup.track.rail_origin = ProfilePoint{750, 0};
    const WheelRailState state;
    const geometry::Profiles profiles = geometry::make_profiles(setup);
    geometry::Position position(setup, profiles, state);
    const double depth = 0.025, half = std::sqrt(160 * depth);
    const auto candidates = position.candidates(position.clearance(0) + depth);
    const double between = apart - 2 * half;
    if (between > 8) {
        REQUIRE(candidates.size() == 2);
        CHECK(candidates[0].place.reference.y > candidates[1].place.reference.y);
    } else {
        REQUIRE(candidates.size() == 1);
        CHECK(candidates[0].place.regions.size() == (between > 4 ? 2u : 1u));
        if (between > 4) CHECK_THAT(candidates[0].place.shares[1], WithinAbs(std::pow((8 - between) / 4, 0.8), 0.02));
    }
}

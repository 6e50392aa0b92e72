// Tests heights of wheels that are straight between the nodes of a mesh.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <memory>

#include "contactd/make_profile.hpp"
#include "geometry/distance/heights.hpp"

using Catch::Matchers::WithinAbs;
using namespace contactd;
using namespace contactd::geometry;

namespace {

const ContactReference reference{0.4, 751, 0.1, -0.02};

WheelSurface wheel_with(std::shared_ptr<const OutOfRound> out_of_round = nullptr) {
    WheelsetPosition position;
    position.y = 0.7;
    position.yaw = 0.01;
    return {make_profile({ProfileKind::wheel, S1002{}}).curve, Wheelset{}, position, {}, std::move(out_of_round)};
}

std::vector<double> meshed(const WheelSurface& wheel, const Grid& grid, const ElementMiddle& counted_from) {
    ContactPlace place;
    place.reference = reference;
    place.regions = {{reference, {-5, 5}, {748, 754}, {}, 0.01, 1}};
    return meshed_wheel_heights(wheel, {place, grid, counted_from}, grid);
}

}  // namespace

TEST_CASE("A meshed wheel differs from the wheel by what chords leave out") {
    const WheelSurface wheel = wheel_with();
    const Grid grid{21, 15, 0.5, 0.4, -5.25, -3.0};
    const std::vector<double> on_wheel = wheel_heights(wheel, reference, grid), on_mesh = meshed(wheel, grid, {});
    double most = 0;
    for (std::size_t i = 0; i < on_wheel.size(); ++i) most = std::max(most, std::abs(on_wheel[i] - on_mesh[i]));
    CHECK(most > 2e-5);
    CHECK(most < 0.5 * 0.5 / (8 * 455) + 0.4 * 0.4 / (8 * 200));
}

TEST_CASE("Nodes of a mesh lie where elements are counted from") {
    const WheelSurface wheel = wheel_with();
    const double chord = 0.5 * 0.5 / (8 * 460);
    // Uses one element whose middle is at x, at a node or half a node away.
    const auto left_out = [&](double x, double from) {
        const Grid grid{1, 1, 0.5, 0.4, x - 0.25, -0.2};
        return wheel_heights(wheel, reference, grid)[0] - meshed(wheel, grid, {from, 0})[0];
    };
    CHECK_THAT(left_out(0, 0), WithinAbs(0, 0.1 * chord));
    CHECK_THAT(left_out(0.25, 0), WithinAbs(chord, 0.1 * chord));
    CHECK_THAT(left_out(0.25, 0.25), WithinAbs(0, 0.1 * chord));
    // So far away the wheel's own axes, which are rotated, put rows elsewhere, too.
    CHECK_THAT(left_out(0, -10.25) - left_out(0, -10.5), WithinAbs(chord, 0.1 * chord));
}

TEST_CASE("Between points of slices a wheel is smooth") {
    const ProfileCurve profile = make_profile({ProfileKind::wheel, S1002{}}).curve;
    std::vector<double> angles;
    std::vector<ProfileCurve> slices;
    for (int i = 0; i < 40; ++i) {
        angles.push_back(-3 + 0.15 * i);
        slices.push_back(profile);
    }
    const WheelSurface wheel = wheel_with(std::make_shared<const OutOfRound>(angles, slices));
    const Grid grid{21, 15, 0.5, 0.4, -5.25, -3.0};
    const std::vector<double> on_wheel = wheel_heights(wheel_with(), reference, grid);
    const std::vector<double> on_mesh = meshed(wheel, grid, {});
    for (std::size_t i = 0; i < on_wheel.size(); ++i) CHECK_THAT(on_mesh[i], WithinAbs(on_wheel[i], 2e-6));
}

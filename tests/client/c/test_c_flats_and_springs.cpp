// Wheels that are not round and rails that give way, by the C interface: in process and with a daemon to the last bit,
// in whatever order things are said, and what is refused.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "c_wheel.hpp"
#include "client/cpp/own_daemon.hpp"

using Catch::Approx;

namespace {

constexpr double radius = 450, depth = 0.5;
const double edge = std::acos(1 - depth / radius);  // half the angle of the flat

/// A cylinder with a flat, at pitch 0 on the rail, which is an arc.
void set_flat(contactd_wheel* w) {
    set_rolling(w, 0);
    require_ok(contactd_wheel_set_arc(w, CONTACTD_RAIL, 300, 0, -30, 30), w);
    require_ok(contactd_wheel_set_rail_origin(w, 750, 0), w);
    require_ok(contactd_wheel_set_wheelset(w, 1360, -70, radius), w);
    for (int k = -20; k <= 20; ++k) {
        const double angle = 0.15 * k * edge, z = std::min(0.0, (radius - depth) / std::cos(angle) - radius);
        const double y[3] = {-40, 0, 40}, level[3] = {z, z, z};
        require_ok(contactd_wheel_set_points(w, CONTACTD_WHEEL, y, level, 3, 0), w);
        require_ok(contactd_wheel_add_wheel_slice(w, angle), w);
    }
}

/// In the flange, on a rail that something else draws inwards, too.
void set_on_springs(contactd_wheel* w) {
    set_rolling(w, 7.5);
    require_ok(contactd_wheel_set_springs(w, 1e4, 1e5), w);
    require_ok(contactd_wheel_set_rail_forces(w, -300, 1000), w);
}

double height(contactd_wheel* w) {
    double z = 0, pitch = 0;
    require_ok(contactd_wheel_solve(w), w);
    require_ok(contactd_wheel_get_motion(w, &z, &pitch), w);
    return z;
}

struct Shift {
    double y = 0, z = 0;
};

Shift shift_of(contactd_wheel* w) {
    Shift shift;
    require_ok(contactd_wheel_get_rail_shift(w, &shift.y, &shift.z), w);
    return shift;
}

/// A statement; its code.
using Saying = std::function<std::int32_t(contactd_wheel*)>;

/// A cone that is a little out of round.
void set_out_of_round(contactd_wheel* w) {
    constexpr std::array slopes{-0.05, -0.051, -0.05};
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        require_ok(contactd_wheel_set_cone(w, CONTACTD_WHEEL, slopes[k], -40, 40), w);
        require_ok(contactd_wheel_add_wheel_slice(w, 0.4 * static_cast<double>(k) - 0.5), w);
    }
}

/// A rail that varies along the track.
void set_slices(contactd_wheel* w) {
    require_ok(contactd_wheel_set_rail_origin(w, 750, 0), w);
    for (const double x : {-500.0, 500.0}) {
        require_ok(contactd_wheel_set_arc(w, CONTACTD_RAIL, 300 + 0.1 * x, 0, -30, 30), w);
        require_ok(contactd_wheel_add_slice(w, x), w);
    }
}

}  // namespace

TEST_CASE("In process and with a daemon flats and springs have the same answers to the last bit", "[c]") {
    Daemon daemon;
    const Place here("local"), there(daemon.endpoint());
    const auto beside_its_flat = [](contactd_wheel* w) {
        set_flat(w);
        require_ok(contactd_wheel_set_pitch_angle(w, 0.8 * edge), w);
    };
    const auto flat_and_springs = [](contactd_wheel* w) {
        set_flat(w);
        require_ok(contactd_wheel_set_side(w, CONTACTD_LEFT), w);
        require_ok(contactd_wheel_set_springs(w, 0, 3e4), w);
    };
    const auto derived = [](contactd_wheel* w) {
        set_on_springs(w);
        require_ok(contactd_wheel_want_derivatives(w, 1), w);
    };
    const std::vector<std::function<void(contactd_wheel*)>> cases{set_flat, beside_its_flat, flat_and_springs, derived};
    for (const auto& set : cases) {
        const WheelHandle own(here), remote(there);
        set(own);
        set(remote);
        const Numbers mine = solved(own);
        CHECK(mine.size() > 100);
        CHECK(mine == solved(remote));
        CHECK(mine == solved(own));
    }
}

TEST_CASE("The axle goes down over a flat, and comes up where it is taken back", "[c]") {
    const Place here("local");
    const WheelHandle w(here), round(here);
    set_flat(w);
    const double on_the_flat = height(w);
    require_ok(contactd_wheel_set_pitch_angle(w, 1), w);
    const double beside = height(w);
    CHECK(on_the_flat > beside + 0.8 * depth);

    set_flat(round);
    require_ok(contactd_wheel_clear_wheel_slices(round), round);
    require_ok(contactd_wheel_set_cone(round, CONTACTD_WHEEL, 0, -40, 40), round);
    require_ok(contactd_wheel_set_mesh_search(round, 1), round);
    CHECK(height(round) == Approx(beside).margin(1e-4));
}

TEST_CASE("A rail on springs is in balance with its wheel and with what else acts on it", "[c]") {
    const Place here("local");
    const WheelHandle w(here);
    set_on_springs(w);
    require_ok(contactd_wheel_solve(w), w);
    double forces[6], residual = 1;
    std::int32_t solves = 0, converged = 0;
    require_ok(contactd_wheel_get_forces(w, CONTACTD_IN_TRACK, forces), w);
    require_ok(contactd_wheel_get_evidence(w, CONTACTD_RAIL_SHIFT, &solves, &residual, &converged), w);
    CHECK(forces[1] - 300 == Approx(1e4 * shift_of(w).y).margin(0.05));
    CHECK(forces[2] + 1000 == Approx(1e5 * shift_of(w).z).margin(0.05));
    CHECK(forces[1] != 0);
    CHECK(solves > 1);
    CHECK(residual <= 1e-6);
    CHECK(converged == 1);
    CHECK(contactd_wheel_get_rail_shift(w, nullptr, &residual) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(w) == std::string("y"));
    CHECK(contactd_wheel_get_rail_shift(w, &residual, nullptr) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(w) == std::string("z"));
}

TEST_CASE("A rail whose springs are taken back is rigid again", "[c]") {
    const Place here("local");
    const WheelHandle w(here), rigid(here);
    set_rolling(rigid, 7.5);
    set_on_springs(w);
    require_ok(contactd_wheel_set_springs(w, 0, 5e4), w);
    require_ok(contactd_wheel_set_rail_forces(w, 0, 0), w);
    require_ok(contactd_wheel_solve(w), w);
    CHECK(shift_of(w).y == 0);
    CHECK(shift_of(w).z == Approx(1e4 / 5e4));
    require_ok(contactd_wheel_set_springs(w, 0, 0), w);
    CHECK(solved(w) == solved(rigid));
    double y = 0, z = 0, residual = 0;
    std::int32_t solves = 0, converged = 0;
    CHECK(contactd_wheel_get_rail_shift(w, &y, &z) == CONTACTD_NOT_FOUND);
    CHECK(contactd_wheel_get_evidence(w, CONTACTD_RAIL_SHIFT, &solves, &residual, &converged) == CONTACTD_NOT_FOUND);
}

TEST_CASE("What one function has set no other one takes back, in whatever order they are called", "[c]") {
    const Place here("local");
    const bool varies = GENERATE(false, true);
    std::vector<Saying> sayings{
        [](contactd_wheel* w) { return contactd_wheel_set_springs(w, 2e4, 1e5); },
        [](contactd_wheel* w) { return contactd_wheel_set_position(w, 2, 0, 0.001, 0.004); },
        [](contactd_wheel* w) { return contactd_wheel_set_pitch_angle(w, 0.1); },
        [](contactd_wheel* w) { return contactd_wheel_set_deviation(w, 0.5, 0.2, 0.001); },
        [](contactd_wheel* w) { return contactd_wheel_set_deviation_rate(w, 5, 2, 0.01); },
        [](contactd_wheel* w) { return contactd_wheel_set_rail_forces(w, -200, 700); },
        [](contactd_wheel* w) { return contactd_wheel_set_Fz(w, 2e4); },
    };
    if (varies) {
        sayings.emplace_back([](contactd_wheel* w) { return contactd_wheel_set_x(w, 100); });
        sayings.emplace_back([](contactd_wheel* w) { return contactd_wheel_set_rail_origin(w, 749, 0.5); });
    } else {
        sayings.emplace_back([](contactd_wheel* w) { return contactd_wheel_set_track(w, 1433, 14, 0.004); });
        sayings.emplace_back([](contactd_wheel* w) { return contactd_wheel_set_roller(w, 600); });
    }
    const auto said = [&] {
        const WheelHandle w(here);
        set_rolling(w, 0);
        set_out_of_round(w);
        if (varies) set_slices(w);
        for (const Saying& saying : sayings) require_ok(saying(w), w);
        return contactd_wheel_solve(w) == CONTACTD_OK ? solved(w) : Numbers{};
    };
    const Numbers first = said();
    CHECK(first.size() > 100);
    std::ranges::reverse(sayings);
    CHECK(first == said());
    for (Saying& saying : sayings) {  // each means something
        const Saying kept = std::exchange(saying, [](contactd_wheel*) { return CONTACTD_OK; });
        CHECK_FALSE(first == said());
        saying = kept;
    }
}

TEST_CASE("The wheels of a wheelset press their rails down, each by its force", "[c]") {
    Daemon daemon;
    const std::string where = GENERATE(as<std::string>(), "local", "daemon");
    const Place place(where == "local" ? where : daemon.endpoint());
    const WheelHandle right(place), left(place);
    for (contactd_wheel* w : {static_cast<contactd_wheel*>(right), static_cast<contactd_wheel*>(left)}) {
        set_rolling(w, 0);
        require_ok(contactd_wheel_set_springs(w, 0, 5e4), w);
    }
    require_ok(contactd_wheel_set_side(left, CONTACTD_LEFT), left);
    require_ok(contactd_wheel_set_Fz(right, 2e4), right);
    require_ok(contactd_wheel_set_rail_forces(left, 0, 5e3), left);
    require_ok(contactd_wheel_solve_wheelset(right, left), right);
    CHECK(shift_of(right).z == Approx(0.4).epsilon(1e-4));
    CHECK(shift_of(left).z == Approx(0.3).epsilon(1e-4));
    double roll = 0;
    require_ok(contactd_wheel_get_roll(right, &roll), right);
    CHECK(roll > 0);

    require_ok(contactd_wheel_set_pitch_angle(left, 0.1), left);
    CHECK(contactd_wheel_solve_wheelset(right, left) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(right) == std::string("state.position"));
}

TEST_CASE("Flats and springs that make no sense are refused alike in process and with a daemon", "[c]") {
    Daemon daemon;
    const std::string where = GENERATE(as<std::string>(), "local", "daemon");
    const Place place(where == "local" ? where : daemon.endpoint());
    const WheelHandle w(place);
    set_rolling(w, 0);
    const auto refused = [&](const std::string& name) {
        CHECK(contactd_wheel_solve(w) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_last_field(w) == name);
    };
    require_ok(contactd_wheel_set_rail_forces(w, 100, 0), w);
    refused("state.rail.Fy");
    require_ok(contactd_wheel_set_springs(w, 1e5, 0), w);
    require_ok(contactd_wheel_set_rail_forces(w, 100, 100), w);
    refused("state.rail.Fz");
    require_ok(contactd_wheel_set_rail_forces(w, 0, 0), w);
    require_ok(contactd_wheel_set_springs(w, -1, 0), w);
    refused("setup.track.springs.y");
    require_ok(contactd_wheel_set_springs(w, 0, 0), w);
    require_ok(contactd_wheel_add_wheel_slice(w, 0), w);
    refused("setup.wheel_slices");
    require_ok(contactd_wheel_add_wheel_slice(w, 90), w);  // degrees
    refused("setup.wheel_slices[1].angle");
    require_ok(contactd_wheel_clear_wheel_slices(w), w);
    require_ok(contactd_wheel_add_wheel_slice(w, 0), w);
    require_ok(contactd_wheel_set_cone(w, CONTACTD_WHEEL, -0.05, -20, 20), w);
    require_ok(contactd_wheel_add_wheel_slice(w, 1), w);
    refused("setup.wheel_slices[1].profile");
    require_ok(contactd_wheel_clear_wheel_slices(w), w);
    require_ok(contactd_wheel_solve(w), w);
}

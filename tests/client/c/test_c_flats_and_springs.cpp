// Tests out-of-round wheels and flexible rails with the C interface, in process and with a daemon to the last bit, with
// fields in any order, and refusals.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "c_wheel.hpp"
#include "client/cpp/own_daemon.hpp"

using Catch::Approx;

namespace {

constexpr double radius = 450, depth = 0.5;
const double edge = std::acos(1 - depth / radius);  // half the angle of the flat

/// Creates a cylinder with a flat, at pitch 0 on the rail, which is an arc.
void set_flat(contactd_wheel* w) {
    set_rolling(w, 0);
    set_arc(w, "setup.rail", 300);
    set(w, {{"setup.track.rail_origin.y", 750}, {"setup.track.rail_origin.z", 0}});
    set(w, "setup.wheelset.nominal_radius", radius);
    for (int k = -20; k <= 20; ++k) {
        const double angle = 0.15 * k * edge, z = std::min(0.0, (radius - depth) / std::cos(angle) - radius);
        const std::string at = slice("wheel_slices", static_cast<std::size_t>(k + 20));
        set(w, at + ".angle", angle);
        set_array(w, at + ".profile.points", {-40, z, 0, z, 40, z});
    }
}

/// Creates a flange contact, on a rail that is also pulled inwards.
void set_on_springs(contactd_wheel* w) {
    set_rolling(w, 7.5);
    set(w, {{"setup.track.springs.y", 1e4}, {"setup.track.springs.z", 1e5}});
    set(w, {{"state.rail.Fy", -300}, {"state.rail.Fz", 1000}});
}

double height(contactd_wheel* w) {
    require_ok(contactd_wheel_solve(w), w);
    return get(w, "z");
}

/// Creates a cone that is slightly out of round.
void set_out_of_round(contactd_wheel* w) {
    constexpr std::array slopes{-0.05, -0.051, -0.05};
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        set(w, slice("wheel_slices", k) + ".angle", 0.4 * static_cast<double>(k) - 0.5);
        set_cone(w, slice("wheel_slices", k) + ".profile", slopes[k], 40);
    }
}

/// Creates a rail that varies along the track.
void set_slices(contactd_wheel* w) {
    set(w, {{"setup.track.rail_origin.y", 750}, {"setup.track.rail_origin.z", 0}});
    for (const std::size_t k : {0, 1}) {
        const double x = k == 0 ? -500 : 500;
        set(w, slice("rail_slices", k) + ".x", x);
        set_arc(w, slice("rail_slices", k) + ".profile", 300 + 0.1 * x);
    }
}

}  // namespace

TEST_CASE("In process and with a daemon flats and springs have the same answers to the last bit", "[c]") {
    Daemon daemon;
    const Place here("local"), there(daemon.endpoint());
    const auto beside_its_flat = [](contactd_wheel* w) {
        set_flat(w);
        set(w, "state.position.pitch", 0.8 * edge);
    };
    const auto flat_and_springs = [](contactd_wheel* w) {
        set_flat(w);
        set_word(w, "setup.side", "left");
        set(w, "setup.track.springs.z", 3e4);
    };
    const auto derived = [](contactd_wheel* w) {
        set_on_springs(w);
        set(w, "state.derivatives", 1);
    };
    const std::vector<std::function<void(contactd_wheel*)>> cases{set_flat, beside_its_flat, flat_and_springs, derived};
    for (const auto& set : cases) {
        const WheelHandle own(here), remote(there);
        set(own);
        set(remote);
        std::int32_t fresh = 0;
        require_ok(contactd_save(own, &fresh), own);
        const Numbers mine = solved(own);
        CHECK(mine.size() > 100);
        CHECK(mine == solved(remote));
        require_ok(contactd_restore(own, fresh), own);
        CHECK(mine == solved(own));
    }
}

TEST_CASE("The axle goes down over a flat, and comes up where it is taken back", "[c]") {
    const Place here("local");
    const WheelHandle w(here), round(here);
    set_flat(w);
    const double on_the_flat = height(w);
    set(w, "state.position.pitch", 1);
    const double beside = height(w);
    CHECK(on_the_flat > beside + 0.8 * depth);

    set_flat(round);
    clear(round, "setup.wheel_slices");
    set_cone(round, "setup.wheel", 0, 40);
    set_word(round, "setup.patches.search", "mesh");
    CHECK(height(round) == Approx(beside).margin(1e-4));
}

TEST_CASE("A rail on springs is in balance with its wheel and with what else acts on it", "[c]") {
    const Place here("local");
    const WheelHandle w(here);
    set_on_springs(w);
    require_ok(contactd_wheel_solve(w), w);
    CHECK(get(w, "forces.track.Fy") - 300 == Approx(1e4 * get(w, "rail_deflection.y")).margin(0.05));
    CHECK(get(w, "forces.track.Fz") + 1000 == Approx(1e5 * get(w, "rail_deflection.z")).margin(0.05));
    CHECK(get(w, "forces.track.Fy") != 0);
    CHECK(get(w, "rail_search.iterations") > 1);
    CHECK(get(w, "rail_search.residual") <= 1e-6);
    CHECK(get(w, "rail_search.converged") == 1);
}

TEST_CASE("A rail whose springs are taken back is rigid again", "[c]") {
    const Place here("local");
    const WheelHandle w(here), rigid(here);
    set_rolling(rigid, 7.5);
    set_on_springs(w);
    clear(w, "setup.track.springs.y");
    set(w, "setup.track.springs.z", 5e4);
    set(w, {{"state.rail.Fy", 0}, {"state.rail.Fz", 0}});
    require_ok(contactd_wheel_solve(w), w);
    CHECK(get(w, "rail_deflection.y") == 0);
    CHECK(get(w, "rail_deflection.z") == Approx(1e4 / 5e4));
    clear(w, "setup.track.springs");
    CHECK(solved(w) == solved(rigid));
    CHECK_FALSE(has(w, "rail_deflection"));
    CHECK_FALSE(has(w, "rail_search.residual"));
}

TEST_CASE("Fields are set in whatever order, and each means something", "[c]") {
    const Place here("local");
    const bool varies = GENERATE(false, true);
    std::vector<std::pair<const char*, double>> fields{
        {"setup.track.springs.y", 2e4}, {"setup.track.springs.z", 1e5}, {"state.position.y", 2},
        {"state.position.roll", 0.001}, {"state.position.pitch", 0.1},  {"state.rail.y", 0.5},
        {"state.rail.z", 0.2},          {"state.rail.y_velocity", 5},   {"state.rail.roll_velocity", 0.01},
        {"state.rail.Fy", -200},        {"state.rail.Fz", 700},         {"state.Fz", 2e4}};
    if (varies) {
        fields.insert(fields.end(), {{"state.position.x", 100}, {"setup.track.rail_origin.z", 0.5}});
    } else {
        fields.insert(fields.end(), {{"setup.track.gauge", 1433}, {"setup.track.cant", 0.004}});
        fields.emplace_back("setup.track.roller_radius", 600);
    }
    const auto found = [&] {
        const WheelHandle w(here);
        set_rolling(w, 0);
        set_out_of_round(w);
        if (varies) set_slices(w);
        for (const auto& [path, value] : fields) set(w, path, value);
        return contactd_wheel_solve(w) == CONTACTD_OK ? solved(w) : Numbers{};
    };
    const Numbers first = found();
    CHECK(first.size() > 100);
    std::ranges::reverse(fields);
    CHECK(first == found());
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const auto kept = fields[k];
        INFO(kept.first);
        fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(k));
        CHECK_FALSE(first == found());
        fields.insert(fields.begin() + static_cast<std::ptrdiff_t>(k), kept);
    }
}

TEST_CASE("The wheels of a wheelset press their rails down, each by its force", "[c]") {
    Daemon daemon;
    const std::string where = GENERATE(as<std::string>(), "local", "daemon");
    const Place place(where == "local" ? where : daemon.endpoint());
    const WheelHandle right(place), left(place);
    for (contactd_wheel* w : {static_cast<contactd_wheel*>(right), static_cast<contactd_wheel*>(left)}) {
        set_rolling(w, 0);
        clear(w, "setup.track.springs.y");
        set(w, "setup.track.springs.z", 5e4);
    }
    set_word(left, "setup.side", "left");
    set(right, "state.Fz", 2e4);
    set(left, {{"state.rail.Fy", 0}, {"state.rail.Fz", 5e3}});
    require_ok(contactd_wheel_solve_wheelset(right, left), right);
    CHECK(get(right, "rail_deflection.z") == Approx(0.4).epsilon(1e-4));
    CHECK(get(left, "rail_deflection.z") == Approx(0.3).epsilon(1e-4));
    CHECK(get(right, "roll") > 0);

    set(left, "state.position.pitch", 0.1);
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
    set(w, "state.rail.Fy", 100);
    refused("state.rail.Fy");
    set(w, {{"setup.track.springs.y", 1e5}, {"state.rail.Fz", 100}});
    refused("state.rail.Fz");
    set(w, {{"state.rail.Fy", 0}, {"state.rail.Fz", 0}});
    CHECK(contactd_set(w, "setup.track.springs.y", -1) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(w) == std::string("setup.track.springs.y"));
    clear(w, "setup.track.springs");
    set(w, "setup.wheel_slices[0].angle", 0);
    refused("setup.wheel_slices");
    CHECK(contactd_set(w, "setup.wheel_slices[1].angle", 90) == CONTACTD_INVALID_ARGUMENT);  // degrees
    CHECK(contactd_last_field(w) == std::string("setup.wheel_slices[1].angle"));
    set(w, "setup.wheel_slices[1].angle", 1);
    set_cone(w, "setup.wheel_slices[1].profile", -0.05, 20);
    refused("setup.wheel_slices[1].profile");
    clear(w, "setup.wheel_slices");
    require_ok(contactd_wheel_solve(w), w);
}

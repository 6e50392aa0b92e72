// Tests wheels on rails with the C interface, in process and with a daemon to the last bit, and their use by threads.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "c_wheel.hpp"
#include "client/cpp/own_daemon.hpp"

using namespace std::chrono_literals;
using Catch::Approx;

namespace {

struct Case {
    const char* name;
    std::function<void(contactd_wheel*)> set;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"in the middle", [](contactd_wheel* w) { set_rolling(w, 0); }},
        {"two regions in one patch", [](contactd_wheel* w) { set_rolling(w, 5); }},
        {"a rail by its name",
         [](contactd_wheel* w) {
             set_rolling(w, 2);
             set_word(w, "setup.rail.standard.name", "54E1");
             set(w, "setup.rail.standard.inclination", 0.025);
         }},
        {"a left wheel with derivatives",
         [](contactd_wheel* w) {
             set_rolling(w, 2);
             set_word(w, "setup.side", "left");
             set(w, "state.derivatives", 1);
         }},
        {"fastsim, with a longitudinal force",
         [](contactd_wheel* w) {
             set_rolling(w, 1);
             set_word(w, "setup.model", "fastsim");
             set(w, "state.Fx", 500);
         }},
        {"friction by the angle, falling with slip",
         [](contactd_wheel* w) {
             set_rolling(w, 8);
             set_array(w, "setup.friction.mu", {-1.2, 0.1, -0.2, 0.35});
             set(w, {{"setup.friction.along_profile", 1}, {"setup.friction.kinetic.mu", 0.08}});
             set_word(w, "setup.friction.kinetic.law", "exponential");
             set(w, "setup.friction.kinetic.slip_velocity", 500);
         }},
        {"no contact",
         [](contactd_wheel* w) {
             set_rolling(w, 0);
             clear(w, "state.Fz");
             set(w, {{"state.position.y", 0},
                     {"state.position.z", -1},
                     {"state.position.roll", 0},
                     {"state.position.yaw", 0}});
         }},
        {"a cone on arcs that vary along the track",
         [](contactd_wheel* w) {
             set_rolling(w, 0);
             set_cone(w, "setup.wheel", -0.05);
             set(w, {{"setup.track.rail_origin.y", 750}, {"setup.track.rail_origin.z", 0}});
             set(w, "setup.rail_slices[0].x", -500);
             set_arc(w, "setup.rail_slices[0].profile", 300);
             set(w, "setup.rail_slices[1].x", 500);
             set_arc(w, "setup.rail_slices[1].profile", 200);
             set(w, "state.position.x", 100);
         }},
        {"a contact that is curved, found on a mesh",
         [](contactd_wheel* w) {
             set_rolling(w, 7.5);
             set_word(w, "setup.patches.search", "mesh");
             set_word(w, "setup.conformal", "half_space");
         }},
        {"a contact that turns from row to row",
         [](contactd_wheel* w) {
             set_rolling(w, 6.5);
             set_word(w, "setup.conformal", "rotated");
         }},
        {"a roller, of points, under a rigid wheel",
         [](contactd_wheel* w) {
             Numbers points;
             for (int k = -60; k <= 60; ++k)
                 points.insert(points.end(), {0.5 * k, 300 - std::sqrt(300 * 300 - 0.25 * k * k)});
             set_rolling(w, 0);
             set_array(w, "setup.rail.points", points);
             set(w, "setup.rail.smoothing_length", 3);
             set_cone(w, "setup.wheel", -0.025);
             set(w, {{"setup.track.rail_origin.y", 750}, {"setup.track.rail_origin.z", 0}});
             set(w, {{"setup.track.roller_radius", 500}, {"setup.bodies.lower.rigid", 1}});
             set_array(w, "state.velocity", {0, 0, 0, 0, 0, -4});
             set(w, "state.roller_pitch", 4 * 460.0 / 500);
         }},
    };
    return all;
}

struct Solving {
    explicit Solving(contactd_wheel* wheel)
        : thread([this, wheel] {
              do {  // the other thread may have its turn now
                  code = contactd_wheel_solve(wheel);
              } while (code == CONTACTD_FAILED_PRECONDITION);
              reason = contactd_last_error(wheel);
              ended = true;
          }) {}
    void join() { thread.join(); }
    std::int32_t code = -1;
    std::string reason;
    std::atomic<bool> ended = false;
    std::thread thread;
};

}  // namespace

TEST_CASE("In process and with a daemon wheels have the same answers to the last bit", "[c]") {
    Daemon daemon;
    const Place here("local"), there(daemon.endpoint());
    for (const Case& one : cases()) {
        INFO(one.name);
        const WheelHandle own(here), remote(there);
        one.set(own);
        one.set(remote);
        std::int32_t fresh = 0;
        require_ok(contactd_save(own, &fresh), own);
        const Numbers mine = solved(own);
        CHECK(mine.size() > 20);
        CHECK(mine == solved(remote));
        require_ok(contactd_restore(own, fresh), own);
        CHECK(mine == solved(own));
    }
}

TEST_CASE("A wheel on its rail is as the benchmark has it", "[c]") {
    const Place here("local");
    const WheelHandle w(here);
    set_array(w, "state.velocity", {2000, 0, 0, 0, 0, -4.2534857});  // case 17
    set(w, {{"state.position.y", 8},
            {"state.position.z", 0},
            {"state.position.roll", -0.008606},
            {"state.position.yaw", 0.0192}});
    set(w, "state.Fz", 1e4);
    require_ok(contactd_wheel_solve(w), w);
    CHECK(get(w, "z") == Approx(-6.2615).margin(1e-3));
    CHECK(get(w, "pitch_rate") == -4.2534857);
    CHECK(get(w, "forces.track.Fz") == Approx(1e4).epsilon(1e-5));
    CHECK(get(w, "patches[0].solution.forces.Fn") == Approx(12720).epsilon(1e-3));
    CHECK(get(w, "patches[0].solution.forces.Fx") == Approx(-2070).margin(4));
    CHECK(get(w, "patches[0].solution.forces.Fy") == Approx(-3195).margin(4));
    CHECK(get(w, "force.iterations") > 0);
    CHECK(get(w, "force.converged") == 1);
    CHECK(get(w, "force.residual") <= 1e-6);
    CHECK_FALSE(has(w, "pitch_search.residual"));
}

TEST_CASE("A profile of a file is that of its points", "[c]") {
    const Place here("local");
    const WheelHandle from_file(here), from_points(here);
    const auto file = std::filesystem::temp_directory_path() / ("wheel-" + std::to_string(::getpid()) + ".txt");
    Numbers points;
    {
        std::ofstream text(file);
        text.precision(17);
        for (int k = -60; k <= 60; ++k) {
            points.insert(points.end(), {0.5 * k, 0.25 * k * k / 600});
            text << 0.5 * k << ' ' << points.back() << '\n';
        }
    }
    for (contactd_wheel* w : {static_cast<contactd_wheel*>(from_file), static_cast<contactd_wheel*>(from_points)}) {
        set_rolling(w, 0);
        set_cone(w, "setup.wheel", -0.05);
        set(w, {{"setup.track.rail_origin.y", 750}, {"setup.track.rail_origin.z", 0}});
    }
    require_ok(contactd_read_profile(from_file, "setup.rail", file.c_str()), from_file);
    set_array(from_points, "setup.rail.points", points);
    std::filesystem::remove(file);
    CHECK(solved(from_file) == solved(from_points));
}

TEST_CASE("A file is read as what is set beside its text says, here and at the daemon", "[c]") {
    Daemon daemon;
    const Place here("local"), there(daemon.endpoint());
    const std::string file = std::filesystem::temp_directory_path() / ("contactd-head-" + std::to_string(getpid()));
    std::string text = "% z upwards\ny;z\n";
    std::vector<double> points;
    for (int k = -60; k <= 60; ++k) {
        points.insert(points.end(), {0.5 * k, 0.25 * k * k / 600});
        text += std::to_string(0.5 * k / 25.4) + ";" + std::to_string(-points.back() / 25.4) + "\n";
    }
    std::ofstream(file) << text;
    const WheelHandle from_file(there), from_text(here);
    for (contactd_wheel* w : {static_cast<contactd_wheel*>(from_file), static_cast<contactd_wheel*>(from_text)}) {
        set_rolling(w, 0);
        set_cone(w, "setup.wheel", -0.05);
        set(w, {{"setup.track.rail_origin.y", 750}, {"setup.track.rail_origin.z", 0}});
    }
    require_ok(contactd_read_profile(from_file, "setup.rail.file", file.c_str()), from_file);
    set_word(from_text, "setup.rail.file.name", "head.csv");
    set_word(from_text, "setup.rail.file.text", text.c_str());
    std::filesystem::remove(file);
    CHECK(contactd_wheel_solve(from_file) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(from_file) == std::string("setup.rail.file"));
    CHECK(std::string(contactd_last_error(from_file)).find("give unit") != std::string::npos);
    for (contactd_wheel* w : {static_cast<contactd_wheel*>(from_file), static_cast<contactd_wheel*>(from_text)})
        set(w, {{"setup.rail.file.unit", 25.4}, {"setup.rail.file.smoothing_length", 3}});
    const auto by_shape = solved(from_file);
    CHECK(by_shape == solved(from_text));
    set(from_file, "setup.rail.file.mirror_z", 1);
    CHECK(solved(from_file) == by_shape);
    require_ok(contactd_clear(from_file, "setup.rail.file.mirror_z"), from_file);
    set(from_file, {{"setup.rail.file.mirror_y", 1}, {"setup.rail.file.shift_z", 0.5}});
    set(from_file, "setup.track.rail_origin.z", -0.5);
    CHECK(solved(from_file)[0] == Approx(by_shape[0]));
}

TEST_CASE("What is not there to be read is said", "[c]") {
    const Place here("local");
    const WheelHandle w(here);
    double x[6];
    set(w, "state.position.y", 2000);
    require_ok(contactd_wheel_solve(w), w);
    for (const char* path : {"clearance", "derivatives.position.z.Fx", "patches[0].solution.pmax", "rail_deflection.y"})
        CHECK(contactd_get(w, path, x) == CONTACTD_NOT_FOUND);
    CHECK(contactd_get_array(w, "derivatives.position.z", x, 6) == CONTACTD_NOT_FOUND);
    CHECK(contactd_get_array(w, "forces.ground", x, 6) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_get_array(w, "forces.track", nullptr, 6) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(w) == std::string("values"));
    CHECK(contactd_get_array(w, "forces.track", x, 5) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(w) == std::string("count"));
    CHECK(get(w, "warnings") > 0);
    CHECK(contactd_get_word(w, "warnings[0]", nullptr, 0) == CONTACTD_INVALID_ARGUMENT);

    set(w, {{"setup.dx", 1}, {"setup.dy", 1}, {"state.position.y", 0}, {"state.position.z", 0.2}});
    require_ok(contactd_wheel_solve(w), w);
    const auto pressure = [&] { return contactd_get_array(w, "patches[0].solution.pressure", x, 6); };
    CHECK(pressure() == CONTACTD_FAILED_PRECONDITION);
    CHECK(std::string(contactd_last_error(w)).find("contactd_want") != std::string::npos);
    CHECK(contactd_get_array(w, "patches[0].gap", x, 6) == CONTACTD_FAILED_PRECONDITION);
    require_ok(contactd_want(w, "pressure", 1), w);
    CHECK(pressure() == CONTACTD_FAILED_PRECONDITION);
    require_ok(contactd_wheel_solve(w), w);
    CHECK(pressure() == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(w) == std::string("count"));

    set_array(w, "state.velocity", {2000, 0, 0, 0, 0, -4});
    require_ok(contactd_wheel_solve(w), w);
    CHECK(has(w, "patches[0].solution.frictional_power"));
    clear(w, "setup.friction");
    require_ok(contactd_want(w, "slip_x", 1), w);
    require_ok(contactd_wheel_solve(w), w);
    CHECK_FALSE(has(w, "patches[0].solution.frictional_power"));
    const Numbers slip = get_array(w, "patches[0].solution.slip_x");
    CHECK(slip == Numbers(get_array(w, "patches[0].solution.pressure").size()));
}

TEST_CASE("A solve that is refused leaves the results of the one before", "[c]") {
    Daemon daemon;
    const std::string where = GENERATE(as<std::string>(), "local", "daemon");
    const Place place(where == "local" ? where : daemon.endpoint());
    const WheelHandle w(place);
    set_rolling(w, 0);
    require_ok(contactd_wheel_solve(w), w);
    const Numbers before = get_array(w, "forces");
    set_array(w, "setup.rail.points", {0, 0});
    CHECK(contactd_wheel_solve(w) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(w) == std::string("setup.rail.points"));
    CHECK(get_array(w, "forces") == before);
    set(w, "setup.rail.rail_60e1.inclination", 0.025);
    clear(w, "state.Fz");
    set(w, {{"state.position.y", 0}, {"state.position.z", 20}, {"state.position.roll", 0}, {"state.position.yaw", 0}});
    CHECK(contactd_wheel_solve(w) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(w) == std::string("state.position.z"));
}

TEST_CASE("A wheel that a thread uses refuses every call of another, and is cancelled by it", "[c]") {
    Daemon daemon;
    const std::string where = GENERATE(as<std::string>(), "local", "daemon");
    const Place place(where == "local" ? where : daemon.endpoint());
    const WheelHandle w(place);
    set_rolling(w, 0);
    set(w, {{"setup.dx", 0.05}, {"setup.dy", 0.05}});
    set(w, "state.derivatives", 1);
    Solving solving(w);
    while (!solving.ended && (contactd_want(w, "gap", 1), contactd_last_reason(w) != std::string("CONCURRENT_USE")))
        std::this_thread::sleep_for(1ms);
    WheelArguments arguments;
    for (const auto& [name, call] : every_wheel_call(arguments)) {
        if (name == "contactd_wheel_cancel") continue;
        INFO(name);
        CHECK(call(w) == CONTACTD_FAILED_PRECONDITION);
        CHECK(contactd_last_reason(w) == std::string("CONCURRENT_USE"));
    }
    CHECK(contactd_wheel_cancel(w) == CONTACTD_OK);
    solving.join();
    INFO(solving.reason);
    CHECK(solving.code == CONTACTD_CANCELLED);

    require_ok(contactd_wheel_set_timeout(w, 0.05), w);
    CHECK(contactd_wheel_solve(w) == CONTACTD_DEADLINE_EXCEEDED);
    require_ok(contactd_wheel_set_timeout(w, 60), w);
    set(w, "state.derivatives", 0);
    set(w, {{"setup.dx", 1}, {"setup.dy", 1}});
    CHECK(contactd_wheel_cancel(w) == CONTACTD_OK);  // nothing runs: nothing happens
    require_ok(contactd_wheel_solve(w), w);
}

TEST_CASE("The log tells of the warnings of a wheel", "[c]") {
    const Place place("local");
    std::string told;
    require_ok(contactd_set_log(
                   place,
                   [](void* user, std::int32_t level, const char* text) {
                       if (level == CONTACTD_LOG_WARNING) *static_cast<std::string*>(user) += text;
                   },
                   &told),
               place);
    const WheelHandle w(place);
    set(w,
        {{"state.position.y", 2000}, {"state.position.z", 0}, {"state.position.roll", 0}, {"state.position.yaw", 0}});
    require_ok(contactd_wheel_solve(w), w);
    CHECK(told.starts_with("No part of the wheel is above the rail"));
}

TEST_CASE("Without a log warnings go to standard error, each once, and NULL silences them", "[c]") {
    const auto printed = [](bool silenced) {
        std::FILE* const file = std::tmpfile();
        REQUIRE(file != nullptr);
        std::fflush(stderr);
        const int before = ::dup(2);
        ::dup2(::fileno(file), 2);
        {
            const Place place("local");
            if (silenced) require_ok(contactd_set_log(place, nullptr, nullptr), place);
            const WheelHandle w(place);
            set(w, {{"state.position.y", 2000},
                    {"state.position.z", 0},
                    {"state.position.roll", 0},
                    {"state.position.yaw", 0}});
            require_ok(contactd_wheel_solve(w), w);
            require_ok(contactd_wheel_solve(w), w);
        }
        std::fflush(stderr);
        ::dup2(before, 2);
        ::close(before);
        std::rewind(file);
        std::string text(10'000, '\0');
        text.resize(std::fread(text.data(), 1, text.size(), file));
        std::fclose(file);
        return text;
    };

    const std::string text = printed(false);
    CHECK(text.starts_with("contactd: warning: No part of the wheel is above the rail"));
    CHECK(std::count(text.begin(), text.end(), '\n') == 1);
    CHECK(printed(true).empty());
}

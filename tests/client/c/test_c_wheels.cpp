// Wheels on rails of the C interface: in process and with a daemon to the last bit, and what threads may do with them.
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
    static const double angles[2] = {-1.2, -0.2}, mus[2] = {0.1, 0.35};
    static const std::vector<Case> all{
        {"in the middle", [](contactd_wheel* w) { set_rolling(w, 0); }},
        {"two regions in one patch", [](contactd_wheel* w) { set_rolling(w, 5); }},
        {"a left wheel with derivatives",
         [](contactd_wheel* w) {
             set_rolling(w, 2);
             require_ok(contactd_wheel_set_side(w, CONTACTD_LEFT), w);
             require_ok(contactd_wheel_want_derivatives(w, 1), w);
         }},
        {"fastsim, with a longitudinal force",
         [](contactd_wheel* w) {
             set_rolling(w, 1);
             require_ok(contactd_wheel_set_model(w, CONTACTD_FASTSIM), w);
             require_ok(contactd_wheel_set_Fx(w, 500), w);
         }},
        {"friction by the angle, falling with slip",
         [](contactd_wheel* w) {
             set_rolling(w, 8);
             require_ok(contactd_wheel_set_mu_by_angle(w, angles, mus, 2, 1), w);
             require_ok(contactd_wheel_set_kinetic(w, CONTACTD_EXPONENTIAL, 0.08, 500), w);
         }},
        {"no contact",
         [](contactd_wheel* w) {
             set_rolling(w, 0);
             require_ok(contactd_wheel_clear_forces(w), w);
             require_ok(contactd_wheel_set_position(w, 0, -1, 0, 0), w);
         }},
        {"a cone on arcs that vary along the track",
         [](contactd_wheel* w) {
             set_rolling(w, 0);
             require_ok(contactd_wheel_set_cone(w, CONTACTD_WHEEL, -0.05, -30, 30), w);
             require_ok(contactd_wheel_set_rail_origin(w, 750, 0), w);
             require_ok(contactd_wheel_set_arc(w, CONTACTD_RAIL, 300, 0, -30, 30), w);
             require_ok(contactd_wheel_add_slice(w, -500), w);
             require_ok(contactd_wheel_set_arc(w, CONTACTD_RAIL, 200, 0, -30, 30), w);
             require_ok(contactd_wheel_add_slice(w, 500), w);
             require_ok(contactd_wheel_set_x(w, 100), w);
         }},
        {"a contact that is curved, found on a mesh",
         [](contactd_wheel* w) {
             set_rolling(w, 7.5);
             require_ok(contactd_wheel_set_mesh_search(w, 1), w);
             require_ok(contactd_wheel_set_conformal(w, 1), w);
         }},
        {"a contact that turns from row to row",
         [](contactd_wheel* w) {
             set_rolling(w, 6.5);
             require_ok(contactd_wheel_set_conformal(w, 2), w);
         }},
        {"a roller, of points, under a rigid wheel",
         [](contactd_wheel* w) {
             Numbers y, z;
             for (int k = -60; k <= 60; ++k) {
                 y.push_back(0.5 * k);
                 z.push_back(300 - std::sqrt(300 * 300 - 0.25 * k * k));
             }
             set_rolling(w, 0);
             require_ok(contactd_wheel_set_points(w, CONTACTD_RAIL, y.data(), z.data(), 121, 3), w);
             require_ok(contactd_wheel_set_cone(w, CONTACTD_WHEEL, -0.025, -30, 30), w);
             require_ok(contactd_wheel_set_rail_origin(w, 750, 0), w);
             require_ok(contactd_wheel_set_roller(w, 500), w);
             require_ok(contactd_wheel_set_rigid(w, CONTACTD_WHEEL), w);
             require_ok(contactd_wheel_set_velocity(w, 0, 0, 0, 0, 0, -4), w);
             require_ok(contactd_wheel_set_roller_pitch(w, 4 * 460.0 / 500), w);
         }},
    };
    return all;
}

struct Solving {
    explicit Solving(contactd_wheel* wheel)
        : thread([this, wheel] {
              do {  // the other thread may have its turn just now
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
        const Numbers mine = solved(own);
        CHECK(mine.size() > 20);
        CHECK(mine == solved(remote));
        CHECK(mine == solved(own));
    }
}

TEST_CASE("A wheel on its rail is as the benchmark has it", "[c]") {
    const Place here("local");
    const WheelHandle w(here);
    require_ok(contactd_wheel_set_velocity(w, 2000, 0, 0, 0, 0, -4.2534857), w);  // case 17
    require_ok(contactd_wheel_set_position(w, 8, 0, -0.008606, 0.0192), w);
    require_ok(contactd_wheel_set_Fz(w, 1e4), w);
    require_ok(contactd_wheel_solve(w), w);
    double forces[6], z, pitch, Fn, Fx, Fs, Mn;
    std::int32_t iterations = 0, converged = 0;
    double residual = 1;
    require_ok(contactd_wheel_get_motion(w, &z, &pitch), w);
    require_ok(contactd_wheel_get_forces(w, CONTACTD_IN_TRACK, forces), w);
    require_ok(contactd_wheel_get_contact_forces(w, 0, &Fn, &Fx, &Fs, &Mn), w);
    require_ok(contactd_wheel_get_evidence(w, CONTACTD_FORCE, &iterations, &residual, &converged), w);
    CHECK(z == Approx(-6.2615).margin(1e-3));
    CHECK(pitch == -4.2534857);
    CHECK(forces[2] == Approx(1e4).epsilon(1e-5));
    CHECK(Fn == Approx(12720).epsilon(1e-3));
    CHECK(Fx == Approx(-2070).margin(4));
    CHECK(Fs == Approx(-3195).margin(4));
    CHECK(iterations > 0);
    CHECK(converged == 1);
    CHECK(residual <= 1e-6);
    CHECK(contactd_wheel_get_evidence(w, CONTACTD_PITCH, &iterations, &residual, &converged) == CONTACTD_NOT_FOUND);
    CHECK(contactd_wheel_get_evidence(w, CONTACTD_NORMAL, &iterations, &residual, &converged) ==
          CONTACTD_INVALID_ARGUMENT);
}

TEST_CASE("A profile of a file is that of its points", "[c]") {
    const Place here("local");
    const WheelHandle from_file(here), from_points(here);
    const auto file = std::filesystem::temp_directory_path() / ("wheel-" + std::to_string(::getpid()) + ".txt");
    Numbers y, z;
    {
        std::ofstream text(file);
        text.precision(17);
        for (int k = -60; k <= 60; ++k) {
            y.push_back(0.5 * k);
            z.push_back(0.25 * k * k / 600);
            text << y.back() << ' ' << z.back() << '\n';
        }
    }
    for (contactd_wheel* w : {static_cast<contactd_wheel*>(from_file), static_cast<contactd_wheel*>(from_points)}) {
        set_rolling(w, 0);
        require_ok(contactd_wheel_set_cone(w, CONTACTD_WHEEL, -0.05, -30, 30), w);
        require_ok(contactd_wheel_set_rail_origin(w, 750, 0), w);
    }
    require_ok(contactd_wheel_set_file(from_file, CONTACTD_RAIL, file.c_str(), 0), from_file);
    require_ok(contactd_wheel_set_points(from_points, CONTACTD_RAIL, y.data(), z.data(), 121, 0), from_points);
    std::filesystem::remove(file);
    CHECK(solved(from_file) == solved(from_points));
}

TEST_CASE("What is not there to be read is said", "[c]") {
    const Place here("local");
    const WheelHandle w(here);
    double x[6];
    std::int32_t n = 0;
    require_ok(contactd_wheel_set_position(w, 2000, 0, 0, 0), w);
    require_ok(contactd_wheel_solve(w), w);
    CHECK(contactd_wheel_get_clearance(w, x) == CONTACTD_NOT_FOUND);
    CHECK(contactd_wheel_get_derivative(w, CONTACTD_BY_POSITION_Z, x) == CONTACTD_NOT_FOUND);
    CHECK(contactd_wheel_get_pressure(w, 0, x, x + 1) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(w) == std::string("patch"));
    CHECK(contactd_wheel_get_forces(w, 3, x) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_wheel_get_forces(w, CONTACTD_IN_TRACK, nullptr) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_wheel_get_derivative(w, 10, x) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_wheel_get_warnings(w, &n) == CONTACTD_OK);
    CHECK(n > 0);
    CHECK(contactd_wheel_get_warning(w, n, nullptr, 0) == CONTACTD_INVALID_ARGUMENT);

    require_ok(contactd_wheel_set_elements(w, 1, 1, 0), w);
    require_ok(contactd_wheel_set_position(w, 0, 0.2, 0, 0), w);
    require_ok(contactd_wheel_solve(w), w);
    CHECK(contactd_wheel_get_array(w, 0, CONTACTD_PRESSURE, x, 6) == CONTACTD_FAILED_PRECONDITION);
    CHECK(std::string(contactd_last_error(w)).find("contactd_wheel_want") != std::string::npos);
    CHECK(contactd_wheel_get_array(w, 0, CONTACTD_GAP, x, 6) == CONTACTD_FAILED_PRECONDITION);
    require_ok(contactd_wheel_want(w, CONTACTD_PRESSURE, 1), w);
    CHECK(contactd_wheel_get_array(w, 0, CONTACTD_PRESSURE, x, 6) == CONTACTD_FAILED_PRECONDITION);
    require_ok(contactd_wheel_solve(w), w);
    CHECK(contactd_wheel_get_array(w, 0, CONTACTD_PRESSURE, x, 6) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(w) == std::string("length"));
    CHECK(contactd_wheel_get_array(w, 0, CONTACTD_DIVISION, x, 6) == CONTACTD_INVALID_ARGUMENT);

    require_ok(contactd_wheel_set_velocity(w, 2000, 0, 0, 0, 0, -4), w);
    require_ok(contactd_wheel_solve(w), w);
    CHECK(contactd_wheel_get_frictional_power(w, 0, x) == CONTACTD_OK);
    require_ok(contactd_wheel_set_frictionless(w), w);
    require_ok(contactd_wheel_solve(w), w);
    CHECK(contactd_wheel_get_frictional_power(w, 0, x) == CONTACTD_NOT_FOUND);
}

TEST_CASE("A solve that is refused leaves the results of the one before", "[c]") {
    Daemon daemon;
    const std::string where = GENERATE(as<std::string>(), "local", "daemon");
    const Place place(where == "local" ? where : daemon.endpoint());
    const WheelHandle w(place);
    set_rolling(w, 0);
    require_ok(contactd_wheel_solve(w), w);
    double before[6], after[6];
    require_ok(contactd_wheel_get_forces(w, CONTACTD_IN_TRACK, before), w);
    const double points[2] = {0, 1};
    require_ok(contactd_wheel_set_points(w, CONTACTD_RAIL, points, points, 1, 0), w);
    CHECK(contactd_wheel_solve(w) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(w) == std::string("setup.rail.points"));
    require_ok(contactd_wheel_get_forces(w, CONTACTD_IN_TRACK, after), w);
    CHECK(before[1] == after[1]);
    require_ok(contactd_wheel_set_rail_60e1(w, 0.025), w);
    require_ok(contactd_wheel_clear_forces(w), w);
    require_ok(contactd_wheel_set_position(w, 0, 20, 0, 0), w);
    CHECK(contactd_wheel_solve(w) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(w) == std::string("state.position.z"));
}

TEST_CASE("A wheel that a thread uses refuses every call of another, and is cancelled by it", "[c]") {
    Daemon daemon;
    const std::string where = GENERATE(as<std::string>(), "local", "daemon");
    const Place place(where == "local" ? where : daemon.endpoint());
    const WheelHandle w(place);
    set_rolling(w, 0);
    require_ok(contactd_wheel_set_elements(w, 0.05, 0.05, 0), w);
    require_ok(contactd_wheel_want_derivatives(w, 1), w);
    Solving solving(w);
    std::int32_t n = 0;
    while (!solving.ended &&
           (contactd_wheel_get_patches(w, &n), contactd_last_reason(w) != std::string("CONCURRENT_USE")))
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
    require_ok(contactd_wheel_want_derivatives(w, 0), w);
    require_ok(contactd_wheel_set_elements(w, 1, 1, 0), w);
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
    require_ok(contactd_wheel_set_position(w, 2000, 0, 0, 0), w);
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
            require_ok(contactd_wheel_set_position(w, 2000, 0, 0, 0), w);
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

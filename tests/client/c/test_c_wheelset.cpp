// Tests both wheels of a wheelset with the C interface, in process and with a daemon, against separate wheels to the
// last bit, and invalid combinations.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "c_wheel.hpp"
#include "client/cpp/own_daemon.hpp"

using namespace std::chrono_literals;
using Catch::Approx;

namespace {

constexpr double velocity = 2000, radius = 460;

/// Creates a right and a left wheel that roll under separate forces.
struct Wheelset {
    explicit Wheelset(contactd_connection* place, double y = 4) : right(place), left(place) {
        set_word(left, "setup.side", "left");
        for (contactd_wheel* w : {static_cast<contactd_wheel*>(right), static_cast<contactd_wheel*>(left)}) {
            set(w, {{"setup.dx", 1}, {"setup.dy", 1}});
            set_array(w, "state.velocity", {velocity, 0, 0, 0, 0, -velocity / radius});
            set(w, {{"state.position.y", y}, {"state.position.yaw", 2.4e-3 * y}});
        }
        set(right, "state.Fz", 1.2e4);
        set(left, "state.Fz", 0.9e4);
    }
    std::int32_t solve() const { return contactd_wheel_solve_wheelset(right, left); }

    WheelHandle right, left;
};

/// Returns the results of a wheel's last solve.
Numbers results(contactd_wheel* w) {
    Numbers all;
    const auto take = [&](const std::string& path) {
        const Numbers more = get_array(w, path);
        all.insert(all.end(), more.begin(), more.end());
    };
    for (const char* path : {"z", "pitch_rate", "roll", "converged", "forces"}) take(path);
    all.insert(all.end(), {get(w, "roll_search.iterations"), get(w, "roll_search.residual")});
    for (int k = 0; k < get(w, "patches"); ++k) {
        const std::string patch = "patches[" + std::to_string(k) + "].", pressure = patch + "solution.pressure";
        take(patch + "place.creepages");
        std::int32_t elements = 0;
        if (contactd_length(w, pressure.c_str(), &elements) == CONTACTD_OK) take(pressure);
    }
    return all;
}

double vertical_force(contactd_wheel* w) {
    return get(w, "forces.track.Fz");
}

void refuses(const Wheelset& wheelset, const std::string& field) {
    INFO(field);
    CHECK(wheelset.solve() == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(wheelset.right) == field);
}

}  // namespace

TEST_CASE("In process and with a daemon wheelsets have the same answers to the last bit", "[c]") {
    Daemon daemon;
    const Place here("local"), there(daemon.endpoint());
    for (const double y : {0.0, 4.0}) {
        const Wheelset own(here, y), remote(there, y);
        for (const Wheelset* one : {&own, &remote}) {
            require_ok(contactd_want(one->left, "pressure", 1), one->left);
            set(one->left, "setup.friction.mu", 0.2);
            require_ok(one->solve(), one->right);
        }
        CHECK(results(own.right) == results(remote.right));
        CHECK(results(own.left) == results(remote.left));
        double pressure = 0;
        CHECK(contactd_get_array(own.right, "patches[0].solution.pressure", &pressure, 1) ==
              CONTACTD_FAILED_PRECONDITION);  // only the left wheel requested it
    }
}

TEST_CASE("Each wheel of a wheelset presses as told, and is as by itself where the wheelset is", "[c]") {
    const Place here("local");
    const Wheelset wheelset(here);
    require_ok(wheelset.solve(), wheelset.right);
    CHECK(vertical_force(wheelset.right) == Approx(1.2e4).epsilon(1e-5));
    CHECK(vertical_force(wheelset.left) == Approx(0.9e4).epsilon(1e-5));
    const double roll = get(wheelset.right, "roll"), z = get(wheelset.right, "z");
    CHECK(roll != 0);
    CHECK(get(wheelset.left, "roll_search.iterations") > 1);
    CHECK(get(wheelset.left, "roll_search.converged") == 1);

    for (contactd_wheel* w :
         {static_cast<contactd_wheel*>(wheelset.right), static_cast<contactd_wheel*>(wheelset.left)}) {
        set(w, {{"state.position.y", 4},
                {"state.position.z", z},
                {"state.position.roll", roll},
                {"state.position.yaw", 2.4e-3 * 4}});
        const double together = vertical_force(w);
        require_ok(contactd_wheel_solve(w), w);
        CHECK(vertical_force(w) == Approx(together).epsilon(1e-5));
        CHECK(get(w, "z") == Approx(z).margin(1e-4));
        CHECK_FALSE(has(w, "roll_search.residual"));
        CHECK(get(w, "roll") == roll);
    }
}

TEST_CASE("A wheelset goes on from where it ended, and anew with another set-up", "[c]") {
    const Daemon daemon;
    const Place here(GENERATE(true, false) ? "local" : daemon.endpoint());
    const Wheelset series(here);
    const auto place = [](const Wheelset& wheelset, double y) {
        for (contactd_wheel* w :
             {static_cast<contactd_wheel*>(wheelset.right), static_cast<contactd_wheel*>(wheelset.left)})
            set(w, {{"state.position.y", y}, {"state.position.yaw", 2.4e-3 * y}});
    };
    for (const double y : {3.7, 3.8, 3.9, 4.0}) {
        place(series, y);
        require_ok(series.solve(), series.right);
    }
    const Wheelset fresh(here);
    require_ok(fresh.solve(), fresh.right);
    CHECK(get(series.right, "roll_search.iterations") <= get(fresh.right, "roll_search.iterations"));
    CHECK(get(series.right, "roll") != get(fresh.right, "roll"));  // but nearly
    CHECK(get(series.right, "roll") == Approx(get(fresh.right, "roll")).margin(3e-9));
    for (const bool of_right : {true, false}) {
        contactd_wheel* const one = of_right ? series.right : series.left;
        contactd_wheel* const other = of_right ? fresh.right : fresh.left;
        CHECK(get(one, "converged") == 1);
        for (const char* force : {"forces.track.Fx", "forces.track.Fy", "forces.track.Fz"})
            CHECK(get(one, force) == Approx(get(other, force)).margin(2e-5 * vertical_force(other)));
    }

    const Wheelset other(here);
    for (const Wheelset* wheelset : {&series, &other}) {
        set(wheelset->left, "setup.friction.mu", 0.2);
        require_ok(wheelset->solve(), wheelset->right);
    }
    CHECK(results(series.right) == results(other.right));
    CHECK(results(series.left) == results(other.left));
}

TEST_CASE("Wheels that make no wheelset are refused by the field that is wrong", "[c]") {
    const Place here("local"), elsewhere("local");
    const Wheelset wheelset(here);
    contactd_wheel* const left = wheelset.left;
    CHECK(contactd_wheel_solve_wheelset(left, wheelset.right) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(left) == std::string("setup.side"));
    CHECK(contactd_wheel_solve_wheelset(wheelset.right, wheelset.right) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(wheelset.right) == std::string("left"));
    CHECK(contactd_wheel_solve_wheelset(wheelset.right, nullptr) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_reason(wheelset.right) == std::string("NO_HANDLE"));
    const Wheelset other(elsewhere);
    CHECK(contactd_wheel_solve_wheelset(wheelset.right, other.left) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(wheelset.right) == std::string("left"));

    set(left, {{"state.position.y", 4},
               {"state.position.z", -3},
               {"state.position.roll", 0.01},
               {"state.position.yaw", 2.4e-3 * 4}});  // initial values, which may differ
    require_ok(wheelset.solve(), wheelset.right);
    set(left, {{"state.position.y", 3}, {"state.position.yaw", 2.4e-3 * 4}});
    refuses(wheelset, "state.position");
    set(left, {{"state.position.y", 4}, {"state.position.yaw", 2.4e-3 * 4}});
    set(left, "state.roller_pitch", 1);
    refuses(wheelset, "state.roller_pitch");
    set(left, "state.roller_pitch", 0);
    set(left, "state.Fx", 10);
    refuses(wheelset, "state.Fx");
    clear(left, "state.Fx");
    clear(left, "state.Fz");
    refuses(wheelset, "state.Fz_left");
    set(left, "state.Fz", 1e4);
    set(left, "state.derivatives", 1);
    refuses(wheelset, "state.derivatives");
    set(left, "state.derivatives", 0);
    set_array(left, "state.velocity", {1, 0, 0, 0, 0, 0});
    refuses(wheelset, "state.velocity");
}

TEST_CASE("A wheelset is cancelled by either of its wheels, and holds both meanwhile", "[c]") {
    const Place here("local");
    const Wheelset wheelset(here);
    for (contactd_wheel* w :
         {static_cast<contactd_wheel*>(wheelset.left), static_cast<contactd_wheel*>(wheelset.right)}) {
        set(w, {{"setup.dx", 0.05}, {"setup.dy", 0.05}});
        std::atomic<bool> ended = false;
        std::int32_t code = -1;
        std::jthread solving([&] {
            do {  // the other thread may have its turn now
                code = wheelset.solve();
            } while (code == CONTACTD_FAILED_PRECONDITION);
            ended = true;
        });
        std::int32_t of_left = CONTACTD_OK;
        while (!ended && of_left != CONTACTD_FAILED_PRECONDITION) {  // until the solve has its turn
            of_left = contactd_set_word(wheelset.left, "setup.side", "left");
            std::this_thread::sleep_for(1ms);
        }
        CHECK(of_left == CONTACTD_FAILED_PRECONDITION);
        while (!ended) {
            CHECK(contactd_wheel_cancel(w) == CONTACTD_OK);
            std::this_thread::sleep_for(1ms);
        }
        solving.join();
        CHECK(code == CONTACTD_CANCELLED);
    }
}

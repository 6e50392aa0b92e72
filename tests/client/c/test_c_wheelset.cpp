// Both wheels of a wheelset by the C interface: in process and with a daemon to the last bit, as each wheel by itself
// has them, and what does not go together.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "client/cpp/own_daemon.hpp"
#include "every_wheel_call.hpp"

using namespace std::chrono_literals;
using Catch::Approx;
using Numbers = std::vector<double>;

namespace {

constexpr double velocity = 2000, radius = 460;

/// A right and a left wheel that roll under forces of their own.
struct Wheelset {
    explicit Wheelset(contactd_connection* place, double y = 4) : right(place), left(place) {
        require_ok(contactd_wheel_set_side(left, CONTACTD_LEFT), left);
        for (contactd_wheel* w : {static_cast<contactd_wheel*>(right), static_cast<contactd_wheel*>(left)}) {
            require_ok(contactd_wheel_set_elements(w, 1, 1, 0), w);
            require_ok(contactd_wheel_set_velocity(w, velocity, 0, 0, 0, 0, -velocity / radius), w);
            require_ok(contactd_wheel_set_position(w, y, 0, 0, 2.4e-3 * y), w);
        }
        require_ok(contactd_wheel_set_Fz(right, 1.2e4), right);
        require_ok(contactd_wheel_set_Fz(left, 0.9e4), left);
    }
    std::int32_t solve() const { return contactd_wheel_solve_wheelset(right, left); }

    WheelHandle right, left;
};

/// What a wheel has of the last solve.
Numbers results(contactd_wheel* w) {
    Numbers all(5);
    double x[6] = {};
    std::int32_t n[3] = {}, patches = 0;
    require_ok(contactd_wheel_get_motion(w, &all[0], &all[1]), w);
    require_ok(contactd_wheel_get_roll(w, &all[2]), w);
    require_ok(contactd_wheel_get_evidence(w, CONTACTD_ROLL, n, &all[3], n + 1), w);
    require_ok(contactd_wheel_get_converged(w, n + 2), w);
    require_ok(contactd_wheel_get_patches(w, &patches), w);
    all.insert(all.end(), n, n + 3);
    for (const std::int32_t coordinates : {CONTACTD_IN_TRACK, CONTACTD_IN_RAIL, CONTACTD_IN_WHEELSET}) {
        require_ok(contactd_wheel_get_forces(w, coordinates, x), w);
        all.insert(all.end(), x, x + 6);
    }
    for (std::int32_t patch = 0; patch < patches; ++patch) {
        require_ok(contactd_wheel_get_grid(w, patch, n, n + 1, x, x + 1, x + 2, x + 3), w);
        require_ok(contactd_wheel_get_creepages(w, patch, x, x + 1, x + 2, x + 3), w);
        all.insert(all.end(), x, x + 4);
        Numbers values(static_cast<std::size_t>(n[0] * n[1]));
        if (contactd_wheel_get_array(w, patch, CONTACTD_PRESSURE, values.data(), n[0] * n[1]) == CONTACTD_OK)
            all.insert(all.end(), values.begin(), values.end());
    }
    return all;
}

double vertical_force(contactd_wheel* w) {
    double forces[6] = {};
    require_ok(contactd_wheel_get_forces(w, CONTACTD_IN_TRACK, forces), w);
    return forces[2];
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
            require_ok(contactd_wheel_want(one->left, CONTACTD_PRESSURE, 1), one->left);
            require_ok(contactd_wheel_set_mu(one->left, 0.2), one->left);
            require_ok(one->solve(), one->right);
        }
        CHECK(results(own.right) == results(remote.right));
        CHECK(results(own.left) == results(remote.left));
        double pressure = 0;
        CHECK(contactd_wheel_get_array(own.right, 0, CONTACTD_PRESSURE, &pressure, 1) ==
              CONTACTD_FAILED_PRECONDITION);  // only the left wheel wanted it
    }
}

TEST_CASE("Each wheel of a wheelset presses as told, and is as by itself where the wheelset is", "[c]") {
    const Place here("local");
    const Wheelset wheelset(here);
    require_ok(wheelset.solve(), wheelset.right);
    CHECK(vertical_force(wheelset.right) == Approx(1.2e4).epsilon(1e-5));
    CHECK(vertical_force(wheelset.left) == Approx(0.9e4).epsilon(1e-5));
    double roll = 1, z = 1, pitch = 0, again = 0, residual = 1;
    std::int32_t solves = 0, converged = 0;
    require_ok(contactd_wheel_get_roll(wheelset.right, &roll), wheelset.right);
    require_ok(contactd_wheel_get_motion(wheelset.right, &z, &pitch), wheelset.right);
    require_ok(contactd_wheel_get_evidence(wheelset.left, CONTACTD_ROLL, &solves, &residual, &converged),
               wheelset.left);
    CHECK(roll != 0);
    CHECK(solves > 1);
    CHECK(converged == 1);

    for (contactd_wheel* w :
         {static_cast<contactd_wheel*>(wheelset.right), static_cast<contactd_wheel*>(wheelset.left)}) {
        require_ok(contactd_wheel_set_position(w, 4, z, roll, 2.4e-3 * 4), w);
        const double together = vertical_force(w);
        require_ok(contactd_wheel_solve(w), w);
        CHECK(vertical_force(w) == Approx(together).epsilon(1e-5));
        require_ok(contactd_wheel_get_motion(w, &again, &pitch), w);
        CHECK(again == Approx(z).margin(1e-4));
        CHECK(contactd_wheel_get_evidence(w, CONTACTD_ROLL, &solves, &residual, &converged) == CONTACTD_NOT_FOUND);
        require_ok(contactd_wheel_get_roll(w, &again), w);
        CHECK(again == roll);
    }
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

    require_ok(contactd_wheel_set_position(left, 4, -3, 0.01, 2.4e-3 * 4), left);  // where to start: may differ
    require_ok(wheelset.solve(), wheelset.right);
    require_ok(contactd_wheel_set_position(left, 3, 0, 0, 2.4e-3 * 4), left);
    refuses(wheelset, "state.position");
    require_ok(contactd_wheel_set_position(left, 4, 0, 0, 2.4e-3 * 4), left);
    require_ok(contactd_wheel_set_roller_pitch(left, 1), left);
    refuses(wheelset, "state.roller_pitch");
    require_ok(contactd_wheel_set_roller_pitch(left, 0), left);
    require_ok(contactd_wheel_set_Fx(left, 10), left);
    refuses(wheelset, "state.Fx");
    require_ok(contactd_wheel_clear_forces(left), left);
    refuses(wheelset, "state.Fz_left");
    require_ok(contactd_wheel_set_Fz(left, -1), left);
    refuses(wheelset, "state.Fz_left");
    require_ok(contactd_wheel_set_Fz(left, 1e4), left);
    require_ok(contactd_wheel_want_derivatives(left, 1), left);
    refuses(wheelset, "state.derivatives");
    require_ok(contactd_wheel_want_derivatives(left, 0), left);
    require_ok(contactd_wheel_set_velocity(left, 1, 0, 0, 0, 0, 0), left);
    refuses(wheelset, "state.velocity");
}

TEST_CASE("A wheelset is cancelled by either of its wheels, and holds both meanwhile", "[c]") {
    const Place here("local");
    const Wheelset wheelset(here);
    for (contactd_wheel* w :
         {static_cast<contactd_wheel*>(wheelset.left), static_cast<contactd_wheel*>(wheelset.right)}) {
        require_ok(contactd_wheel_set_elements(w, 0.05, 0.05, 0), w);
        std::atomic<bool> ended = false;
        std::int32_t code = -1;
        std::jthread solving([&] {
            do {  // the other thread may have its turn just now
                code = wheelset.solve();
            } while (code == CONTACTD_FAILED_PRECONDITION);
            ended = true;
        });
        std::int32_t of_left = CONTACTD_OK;
        while (!ended && of_left != CONTACTD_FAILED_PRECONDITION) {  // until the solve has its turn
            of_left = contactd_wheel_set_side(wheelset.left, CONTACTD_LEFT);
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

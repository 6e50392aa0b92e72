// Tests the wheels of a vehicle with a daemon, which take one message per step.
#include <catch2/catch_test_macros.hpp>

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "c_wheel.hpp"
#include "client/cpp/own_daemon.hpp"
#include "contactd/client/client.hpp"

using namespace std::chrono_literals;

namespace {

constexpr int count = 3;

/// Holds a daemon, the wheels of a vehicle, and an observing client.
struct Vehicle {
    Vehicle() {
        for (int i = 0; i < count; ++i) {
            wheels.push_back(std::make_unique<WheelHandle>(place));
            handles[i] = *wheels.back();
            set_rolling(handles[i], 0.5 * i);
        }
    }
    std::int32_t solve() { return contactd_wheel_solve_many(handles, count, 0); }
    long long requests() { return static_cast<long long>(client.info().counters.requests); }

    Daemon daemon;
    contactd::client::Client client{daemon.endpoint(), {.connect_timeout = 20s}};
    Place place{daemon.endpoint()};
    std::vector<std::unique_ptr<WheelHandle>> wheels;
    contactd_wheel* handles[count];
};

}  // namespace

TEST_CASE("The wheels of a vehicle send a daemon one message a step", "[c]") {
    Vehicle vehicle;
    REQUIRE(vehicle.solve() == CONTACTD_OK);  // opens sessions
    const long long before = vehicle.requests();
    for (contactd_wheel* w : vehicle.handles) set(w, "state.Fz", 1.1e4);
    REQUIRE(vehicle.solve() == CONTACTD_OK);
    CHECK(vehicle.requests() - before == 2);  // and one of the observer
    for (contactd_wheel* w : vehicle.handles) CHECK(std::abs(get(w, "forces.track.Fz") - 1.1e4) < 0.1);
}

TEST_CASE("A wheel of a message that fails, or is used by another thread, does not keep the others from being solved",
          "[c]") {
    Vehicle vehicle;
    REQUIRE(vehicle.solve() == CONTACTD_OK);
    contactd_wheel* bad = vehicle.handles[1];
    clear(bad, "state.Fz");
    set(bad, "state.position.z", 50);
    for (contactd_wheel* w : vehicle.handles)
        if (w != bad) set(w, "state.Fz", 1.1e4);
    CHECK(vehicle.solve() == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(bad) == std::string("state.position.z"));
    CHECK(contactd_last_code(vehicle.handles[0]) == CONTACTD_OK);
    CHECK(std::abs(get(vehicle.handles[2], "forces.track.Fz") - 1.1e4) < 0.1);
    CHECK(std::abs(get(bad, "forces.track.Fz") - 1e4) < 0.1);  // as it was
}

TEST_CASE("Wheels whose sessions have ended are solved all the same, and transient ones say so", "[c]") {
    Vehicle vehicle;
    REQUIRE(vehicle.solve() == CONTACTD_OK);
    const double force = get(vehicle.handles[0], "forces.track.Fx");
    contactd_wheel* transient = vehicle.handles[2];
    set_word(transient, "state.motion", "transient_rolling");
    set(transient, "state.time_step", 1e-4);
    vehicle.daemon.restart();
    CHECK(vehicle.solve() == CONTACTD_NOT_FOUND);
    CHECK(contactd_last_code(transient) == CONTACTD_NOT_FOUND);
    CHECK(contactd_last_code(vehicle.handles[0]) == CONTACTD_OK);
    CHECK(std::abs(get(vehicle.handles[0], "forces.track.Fx") - force) < 1e-4 * 1e4);
}

TEST_CASE("The message of a vehicle ends when one of its wheels is cancelled, and at the shortest timeout", "[c]") {
    Vehicle vehicle;
    for (contactd_wheel* w : vehicle.handles) set(w, {{"setup.dx", 0.04}, {"setup.dy", 0.04}});
    SECTION("cancelled") {
        std::atomic<bool> ended = false;
        std::int32_t code = -1;
        std::jthread solving([&] {
            code = vehicle.solve();
            ended = true;
        });
        std::this_thread::sleep_for(300ms);
        while (!ended) {
            contactd_wheel_cancel(vehicle.handles[1]);
            std::this_thread::sleep_for(5ms);
        }
        solving.join();
        CHECK(code == CONTACTD_CANCELLED);
    }
    SECTION("out of time") {
        require_ok(contactd_wheel_set_timeout(vehicle.handles[2], 0.3), vehicle.handles[2]);
        CHECK(vehicle.solve() == CONTACTD_DEADLINE_EXCEEDED);
    }
    for (contactd_wheel* w : vehicle.handles) CHECK(contactd_last_code(w) != CONTACTD_OK);
    for (contactd_wheel* w : vehicle.handles) {
        set(w, {{"setup.dx", 1}, {"setup.dy", 1}});
        require_ok(contactd_wheel_set_timeout(w, 60), w);
    }
    CHECK(vehicle.solve() == CONTACTD_OK);
}

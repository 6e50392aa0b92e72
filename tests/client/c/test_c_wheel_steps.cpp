// Tests sequences of steps of wheels with the C interface.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <iterator>
#include <string>

#include "c_wheel.hpp"
#include "client/cpp/own_daemon.hpp"

using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Makes a step of 1 ms of a wheel at 2 m/s.
void set_transient(contactd_wheel* w, const char* motion, double y) {
    set_rolling(w, y);
    set_word(w, "state.motion", motion);
    set(w, "state.time_step", 1e-3);
}

/// Describes where solves take place: in process, or in a separate daemon.
class Somewhere {
   public:
    explicit Somewhere(bool inside) : place_(inside ? "local" : daemon_.endpoint()) {}
    operator contactd_connection*() const { return place_; }

   private:
    Daemon daemon_;
    Place place_;
};

}  // namespace

TEST_CASE("A solve that starts where the one before ended has the answer of a fresh wheel", "[c]") {
    const Place here("local");
    const WheelHandle w(here);
    double solves = 0, fresh_solves = 0;
    for (int k = 0; k < 20; ++k) {
        const WheelHandle fresh(here);
        for (contactd_wheel* each : {static_cast<contactd_wheel*>(w), static_cast<contactd_wheel*>(fresh)}) {
            set_rolling(each, 0.3 * k);
            require_ok(contactd_wheel_solve(each), each);
        }
        INFO("y " << 0.3 * k);
        CHECK(get(w, "z") == Approx(get(fresh, "z")).margin(1e-7));
        for (const char* force : {"forces.track.Fx", "forces.track.Fy", "forces.track.Fz"})
            CHECK(get(w, force) == Approx(get(fresh, force)).margin(0.02));  // of 10 kN
        CHECK(get(w, "patches") == get(fresh, "patches"));
        CHECK(get(w, "converged") == 1);
        solves += get(w, "force.iterations");
        fresh_solves += get(fresh, "force.iterations");
    }
    CHECK(solves < fresh_solves);
}

TEST_CASE("Transient steps of a wheel go on from the tractions of the one before", "[c]") {
    const Somewhere place(GENERATE(true, false));
    const WheelHandle w(place), alone(place);
    std::int32_t start = 0, middle = 0;
    set_transient(w, "transient_rolling", 3);
    require_ok(contactd_save(w, &start), w);
    const Numbers first = solved(w);
    require_ok(contactd_save(w, &middle), w);
    const double force = get(w, "forces.track.Fx");
    const Numbers second = solved(w);
    CHECK(second != first);
    CHECK(std::abs(get(w, "forces.track.Fx")) > std::abs(force));  // tractions build up

    require_ok(contactd_step_again(w), w);
    CHECK(found_of(w) == second);
    require_ok(contactd_restore(w, middle), w);
    CHECK(get(w, "forces.track.Fx") == force);
    CHECK(solved(w) == second);
    require_ok(contactd_restore(w, start), w);
    CHECK(solved(w) == first);
    require_ok(contactd_forget(w, middle), w);
    CHECK(contactd_restore(w, middle) == CONTACTD_NOT_FOUND);
    CHECK(contactd_forget(w, 77) == CONTACTD_NOT_FOUND);

    set_transient(alone, "transient_rolling", 3);
    CHECK(solved(alone) == first);
}

TEST_CASE("Many transient steps of a wheel end as steady rolling", "[c]") {
    const Place here("local");
    const WheelHandle w(here), steady(here);
    set_transient(w, "transient_rolling", 3);
    for (int k = 0; k < 30; ++k) require_ok(contactd_wheel_solve(w), w);
    set_rolling(steady, 3);
    require_ok(contactd_wheel_solve(steady), steady);
    CHECK(get(w, "forces.track.Fx") == Approx(get(steady, "forces.track.Fx")).epsilon(0.02));
    CHECK(get(w, "forces.track.Fy") == Approx(get(steady, "forces.track.Fy")).epsilon(0.02));
}

TEST_CASE("With another set-up a wheel starts anew, and loses no tractions without a word", "[c]") {
    const Somewhere place(GENERATE(true, false));
    const WheelHandle w(place);
    std::int32_t state = 0;
    set_transient(w, "transient_rolling", 0);
    require_ok(contactd_wheel_solve(w), w);
    require_ok(contactd_save(w, &state), w);
    set(w, "setup.dx", 1.5);
    CHECK(contactd_wheel_solve(w) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(w) == std::string("setup"));
    set_word(w, "state.motion", "steady_rolling");
    clear(w, "state.time_step");
    require_ok(contactd_wheel_solve(w), w);
    CHECK(contactd_restore(w, state) == CONTACTD_NOT_FOUND);
    set_transient(w, "transient_rolling", 0);
    set(w, "setup.dx", 1.5);
    require_ok(contactd_wheel_solve(w), w);
}

TEST_CASE("A wheel that another set-up is refused for keeps its session, its tractions and no states", "[c]") {
    const Somewhere place(GENERATE(true, false));
    const WheelHandle w(place);
    std::int32_t state = 0;
    set_transient(w, "transient_rolling", 3);
    const Numbers first = solved(w), second = solved(w);
    require_ok(contactd_save(w, &state), w);
    set_word(w, "state.motion", "steady_rolling");
    clear(w, "state.time_step");
    set_array(w, "setup.rail.points", {0, 0});
    CHECK(contactd_wheel_solve(w) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_restore(w, state) == CONTACTD_NOT_FOUND);
    CHECK(contactd_forget(w, state) == CONTACTD_NOT_FOUND);
    set(w, "setup.rail.rail_60e1.inclination", 0.025);
    set_transient(w, "transient_rolling", 3);
    const Numbers third = solved(w);
    CHECK(third != first);  // it goes on
    CHECK(third != second);
}

TEST_CASE("Wheels of a vehicle have the same answers on any number of threads, to the last bit", "[c]") {
    const Somewhere place(GENERATE(true, false));
    constexpr int count = 4;
    const WheelHandle together[count] = {WheelHandle(place), WheelHandle(place), WheelHandle(place),
                                         WheelHandle(place)};
    const WheelHandle alone[count] = {WheelHandle(place), WheelHandle(place), WheelHandle(place), WheelHandle(place)};
    contactd_wheel* handles[count];
    std::copy(std::begin(together), std::end(together), handles);
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < count; ++i) {
            set_rolling(together[i], 0.5 * i + 0.02 * k);
            set_rolling(alone[i], 0.5 * i + 0.02 * k);
            require_ok(contactd_wheel_solve(alone[i]), alone[i]);
        }
        REQUIRE(contactd_wheel_solve_many(handles, count, k) == CONTACTD_OK);
        for (int i = 0; i < count; ++i)
            for (const char* result : {"z", "forces.track.Fx", "forces.track.Fy", "forces.track.Mz"})
                CHECK(get(together[i], result) == get(alone[i], result));
    }
}

#ifndef __SANITIZE_THREAD__  // which ends a forked process that starts threads
TEST_CASE("A forked process solves wheels on threads of its own", "[c]") {
    const Place place("local");
    const WheelHandle one(place), other(place);
    contactd_wheel* handles[] = {one, other};
    const auto solve = [&](double y) {
        for (const WheelHandle* wheel : {&one, &other}) set_rolling(*wheel, y);
        return contactd_wheel_solve_many(handles, 2, 2);
    };
    REQUIRE(solve(0.5) == CONTACTD_OK);
    const pid_t child = ::fork();
    if (child == 0) ::_exit(solve(0.52) == CONTACTD_OK && get(one, "z") == get(other, "z") ? 0 : 1);
    int status = -1;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    CHECK(solve(0.52) == CONTACTD_OK);
}
#endif

TEST_CASE("A wheel of a vehicle that fails does not keep the others from being solved", "[c]") {
    const Place here("local");
    const WheelHandle good(here), bad(here);
    set_rolling(good, 0);
    set_rolling(bad, 0);
    require_ok(contactd_clear(bad, "state.Fz"), bad);
    set(bad, "state.position.z", 50);
    contactd_wheel* both[] = {bad, good};
    CHECK(contactd_wheel_solve_many(both, 2, 2) == CONTACTD_INVALID_ARGUMENT);
    CHECK(std::string(contactd_last_field(bad)) == "state.position.z");
    CHECK(get(good, "converged") == 1);
    contactd_wheel* twice[] = {good, good};
    CHECK(contactd_wheel_solve_many(twice, 2, 1) == CONTACTD_INVALID_ARGUMENT);
    CHECK_THAT(contactd_last_error(good), ContainsSubstring("wheels[1]"));
    CHECK(contactd_wheel_solve_many(nullptr, 1, 1) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_wheel_solve_many(both, -1, 1) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_wheel_solve_many(both, 1, -1) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_wheel_solve_many(nullptr, 0, 0) == CONTACTD_OK);
}

// Tests functions for implicit integrators, repeated steps and derivatives, in process and with a daemon.
#include <catch2/catch_test_macros.hpp>

#include <cmath>

#include "c_contact.hpp"
#include "client/cpp/own_daemon.hpp"

namespace {

void set_rolling(contactd_contact* contact) {
    set_sphere(contact);
    set(contact, {{"friction.mu", 0.4}, {"friction.rolling.xi", 0.002}, {"friction.rolling.eta", 0.001}});
    set(contact, "settings.tangential.tolerance", 1e-10);
}

std::vector<double> derivatives(contactd_contact* contact) {
    std::vector<double> all;
    for (const std::string of : {"Fx", "Fy", "Mz"})
        for (const char* by : {"xi", "eta", "phi", "approach", "mu"})
            all.push_back(get(contact, "derivatives." + of + "." + by));
    all.push_back(get(contact, "derivatives.Fn.approach"));
    return all;
}

/// Returns Fx for a creepage, each solved without an estimate.
double force(contactd_connection* place, double xi) {
    const Handle contact(place);
    set_rolling(contact);
    set(contact, "friction.rolling.xi", xi);
    require_ok(contactd_start(contact), contact);
    return stepped(contact).Fx;
}

}  // namespace

TEST_CASE("Derivatives are the same in process and behind a daemon, and those of the force", "[c]") {
    const Daemon daemon;
    const Place remote(daemon.endpoint()), local("local");
    std::vector<std::vector<double>> found;
    for (contactd_connection* place :
         {static_cast<contactd_connection*>(remote), static_cast<contactd_connection*>(local)}) {
        const Handle contact(place);
        set_rolling(contact);
        set(contact, "derivatives", 1);
        require_ok(contactd_start(contact), contact);
        stepped(contact);
        found.push_back(derivatives(contact));
    }
    CHECK(found[0] == found[1]);
    const double step = 1e-7, slope = (force(local, 0.002 + step) - force(local, 0.002 - step)) / (2 * step);
    CHECK(std::abs(found[1][0] - slope) < 1e-3 * std::abs(slope));
}

TEST_CASE("What has no derivative says so", "[c]") {
    const Place local("local");
    const Handle contact(local);
    set_rolling(contact);
    double value = -1;
    CHECK(contactd_get(contact, "derivatives.Fx.xi", &value) == CONTACTD_FAILED_PRECONDITION);
    require_ok(contactd_start(contact), contact);
    stepped(contact);
    CHECK(contactd_get(contact, "derivatives.Fx.xi", &value) == CONTACTD_NOT_FOUND);
    set(contact, "derivatives", 1);
    stepped(contact);
    CHECK(contactd_get(contact, "derivatives.approach.xi", &value) == CONTACTD_NOT_FOUND);
    CHECK(contactd_get(contact, "derivatives.Fx.rotation", &value) == CONTACTD_NOT_FOUND);
    CHECK(contactd_get(contact, "derivatives.power.xi", &value) == CONTACTD_INVALID_ARGUMENT);
    CHECK(value == -1);
}

TEST_CASE("A step that is tried again starts where it started, in process and behind a daemon", "[c]") {
    const Daemon daemon;
    for (const std::string& where : {daemon.endpoint(), std::string("local")}) {
        INFO(where);
        const Place place(where);
        const Handle tried(place), straight(place);
        for (contactd_contact* contact :
             {static_cast<contactd_contact*>(tried), static_cast<contactd_contact*>(straight)}) {
            set_sphere(contact);
            set(contact, {{"friction.mu", 0.4}, {"friction.rigid_shift.x", 0.004}});
            require_ok(contactd_start(contact), contact);
            stepped(contact);
        }
        set(tried, "friction.rigid_shift.x", -0.01);
        stepped(tried);
        set(tried, "friction.rigid_shift.x", 0.001);
        require_ok(contactd_step_again(tried), tried);
        set(straight, "friction.rigid_shift.x", 0.001);
        const Read expected = stepped(straight);
        CHECK(read(tried) == expected);
        CHECK(get(tried, "step") == 2);
    }
}

TEST_CASE("A step that failed is tried again without taking the one before back", "[c]") {
    const Daemon daemon;
    for (const std::string& where : {daemon.endpoint(), std::string("local")}) {
        INFO(where);
        const Place place(where);
        const Handle contact(place);
        set_rolling(contact);
        require_ok(contactd_start(contact), contact);
        stepped(contact);
        set(contact, "friction.rolling.force.Fx", 1e9);  // more than friction carries
        REQUIRE(contactd_step(contact) != CONTACTD_OK);
        clear(contact, "friction.rolling.force");
        require_ok(contactd_step_again(contact), contact);
        CHECK(get(contact, "step") == 2);
    }
}

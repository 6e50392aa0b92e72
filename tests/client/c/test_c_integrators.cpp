// What an implicit integrator asks for: steps tried again, and derivatives; in process and behind a daemon.
#include <catch2/catch_test_macros.hpp>

#include <cmath>

#include "c_contact.hpp"
#include "client/cpp/own_daemon.hpp"

namespace {

void set_rolling(contactd_contact* contact) {
    set_sphere(contact);
    require_ok(contactd_set_mu(contact, 0.4), contact);
    require_ok(contactd_set_rolling(contact, CONTACTD_STEADY, 0.002, 0.001, 0), contact);
    require_ok(contactd_set_tolerance(contact, CONTACTD_TANGENTIAL, 1e-10, 1000), contact);
}

double derivative(contactd_contact* contact, std::int32_t of, std::int32_t by) {
    double value = 0;
    require_ok(contactd_get_derivative(contact, of, by, &value), contact);
    return value;
}

std::vector<double> derivatives(contactd_contact* contact) {
    std::vector<double> all;
    for (const std::int32_t of : {CONTACTD_OF_FX, CONTACTD_OF_FY, CONTACTD_OF_MZ})
        for (std::int32_t by = CONTACTD_BY_X; by <= CONTACTD_BY_MU; ++by) all.push_back(derivative(contact, of, by));
    all.push_back(derivative(contact, CONTACTD_OF_FN, CONTACTD_BY_LOAD));
    return all;
}

/// Fx for a creepage, each solved from nothing.
double force(contactd_connection* place, double xi) {
    const Handle contact(place);
    set_rolling(contact);
    require_ok(contactd_set_rolling(contact, CONTACTD_STEADY, xi, 0.001, 0), contact);
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
        require_ok(contactd_want_derivatives(contact, 1), contact);
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
    CHECK(contactd_get_derivative(contact, CONTACTD_OF_FX, CONTACTD_BY_X, &value) == CONTACTD_FAILED_PRECONDITION);
    require_ok(contactd_start(contact), contact);
    stepped(contact);
    CHECK(contactd_get_derivative(contact, CONTACTD_OF_FX, CONTACTD_BY_X, &value) == CONTACTD_NOT_FOUND);
    require_ok(contactd_want_derivatives(contact, 1), contact);
    stepped(contact);
    CHECK(contactd_get_derivative(contact, CONTACTD_OF_APPROACH, CONTACTD_BY_X, &value) == CONTACTD_NOT_FOUND);
    CHECK(contactd_get_derivative(contact, 5, CONTACTD_BY_X, &value) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_get_derivative(contact, CONTACTD_OF_FX, -1, &value) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_get_derivative(contact, CONTACTD_OF_FX, CONTACTD_BY_X, nullptr) == CONTACTD_INVALID_ARGUMENT);
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
            require_ok(contactd_set_mu(contact, 0.4), contact);
            require_ok(contactd_set_shift(contact, 0.004, 0, 0), contact);
            require_ok(contactd_start(contact), contact);
            stepped(contact);
        }
        require_ok(contactd_set_shift(tried, -0.01, 0, 0), tried);
        stepped(tried);
        require_ok(contactd_set_shift(tried, 0.001, 0, 0), tried);
        require_ok(contactd_step_again(tried), tried);
        require_ok(contactd_set_shift(straight, 0.001, 0, 0), straight);
        const Read expected = stepped(straight);
        CHECK(read(tried) == expected);
        std::int32_t step = 0;
        contactd_get_step(tried, &step);
        CHECK(step == 2);
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
        require_ok(contactd_set_Fx(contact, 1e9), contact);  // more than friction carries
        REQUIRE(contactd_step(contact) != CONTACTD_OK);
        require_ok(contactd_clear_forces(contact), contact);
        require_ok(contactd_step_again(contact), contact);
        std::int32_t step = 0;
        contactd_get_step(contact, &step);
        CHECK(step == 2);
    }
}

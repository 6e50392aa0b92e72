// Fields by their paths: what is set so is what the functions of its own set, what is read is what they read, and what
// is wrong is refused at once.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "c_wheel.hpp"

namespace {

/// A wheel in process.
struct LocalWheel {
    contactd_connection* place = nullptr;
    contactd_wheel* wheel = nullptr;

    LocalWheel() {
        REQUIRE(contactd_open("local", &place) == CONTACTD_OK);
        REQUIRE(contactd_wheel_new(place, &wheel) == CONTACTD_OK);
        set_rolling(wheel, 2);
    }
    LocalWheel(const LocalWheel&) = delete;
    LocalWheel& operator=(const LocalWheel&) = delete;
    ~LocalWheel() {
        contactd_wheel_free(wheel);
        contactd_close(place);
    }
};

double get(contactd_wheel* wheel, const std::string& path) {
    double value = 0;
    require_ok(contactd_get(wheel, path.c_str(), &value), wheel);
    return value;
}

std::array<double, 6> forces_of(contactd_wheel* wheel) {
    std::array<double, 6> forces{};
    require_ok(contactd_wheel_get_forces(wheel, CONTACTD_IN_TRACK, forces.data()), wheel);
    return forces;
}

void refused(std::int32_t code, contactd_wheel* wheel, const std::string& field, const std::string& sentence) {
    CHECK(code == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(wheel) == field);
    CHECK(std::string(contactd_last_error(wheel)).find(sentence) != std::string::npos);
}

}  // namespace

TEST_CASE("What is set by its path is what its function sets", "[c]") {
    using Setting = std::function<void(contactd_wheel*)>;
    const auto set = [](const char* path, double value) -> Setting {
        return [=](contactd_wheel* w) { require_ok(contactd_set(w, path, value), w); };
    };
    const auto word = [](const char* path, const char* keyword) -> Setting {
        return [=](contactd_wheel* w) { require_ok(contactd_set_word(w, path, keyword), w); };
    };
    const auto both = [](const Setting& first, const Setting& second) -> Setting {
        return [=](contactd_wheel* w) { first(w), second(w); };
    };
    const auto [by_path, by_function] = GENERATE_COPY(table<Setting, Setting>(
        {{set("state.position.y", 3), [](contactd_wheel* w) { contactd_wheel_set_position(w, 3, 0, 0, 4.8e-3); }},
         {set("setup.track.springs.z", 1e5), [](contactd_wheel* w) { contactd_wheel_set_springs(w, 0, 1e5); }},
         {set("setup.track.roller_radius", 400), [](contactd_wheel* w) { contactd_wheel_set_roller(w, 400); }},
         {word("setup.side", "left"), [](contactd_wheel* w) { contactd_wheel_set_side(w, CONTACTD_LEFT); }},
         {word("setup.model", "fastsim"), [](contactd_wheel* w) { contactd_wheel_set_model(w, CONTACTD_FASTSIM); }},
         {word("setup.conformal", "auto"), [](contactd_wheel* w) { contactd_wheel_set_conformal(w, 4); }},
         {both(set("setup.friction.kinetic.slip_velocity", 100), set("setup.friction.kinetic.mu", 0.1)),
          [](contactd_wheel* w) { contactd_wheel_set_kinetic(w, CONTACTD_EXPONENTIAL, 0.1, 100); }}}));
    const LocalWheel one, other;
    by_path(one.wheel);
    by_function(other.wheel);
    require_ok(contactd_wheel_solve(one.wheel), one.wheel);
    require_ok(contactd_wheel_solve(other.wheel), other.wheel);
    CHECK(forces_of(one.wheel) == forces_of(other.wheel));
}

TEST_CASE("What is read by its path is what its function reads", "[c]") {
    const LocalWheel local;
    contactd_wheel* const w = local.wheel;
    require_ok(contactd_set(w, "setup.track.springs.y", 1e5), w);
    require_ok(contactd_wheel_solve(w), w);
    const std::array<double, 6> forces = forces_of(w);
    CHECK(get(w, "forces.track.Fx") == forces[0]);
    CHECK(get(w, "forces.track.Mz") == forces[5]);
    CHECK(get(w, "patches") == 1);
    CHECK(get(w, "converged") == 1);
    double xi = 0, eta = 0, phi = 0, velocity = 0, power = 0, y = 0, z = 0;
    require_ok(contactd_wheel_get_creepages(w, 0, &xi, &eta, &phi, &velocity), w);
    CHECK(get(w, "patches[0].place.creepages.phi") == phi);
    require_ok(contactd_wheel_get_frictional_power(w, 0, &power), w);
    CHECK(get(w, "frictional_power") == power);
    require_ok(contactd_wheel_get_rail_shift(w, &y, &z), w);
    CHECK(get(w, "rail_shift.y") == y);
    CHECK(get(w, "patches[0].solution.evidence.normal.converged") == 1);
}

TEST_CASE("What was set can be left out again", "[c]") {
    const LocalWheel local;
    contactd_wheel* const w = local.wheel;
    require_ok(contactd_clear(w, "setup.friction"), w);
    require_ok(contactd_wheel_solve(w), w);
    CHECK(forces_of(w)[0] == 0);
    double power = 0;
    CHECK(contactd_get(w, "frictional_power", &power) == CONTACTD_NOT_FOUND);
    require_ok(contactd_set(w, "setup.friction.along_profile", 0), w);
    require_ok(contactd_wheel_solve(w), w);
    CHECK(forces_of(w)[0] != 0);
}

TEST_CASE("A path or a value that is wrong is refused at once, and changes nothing", "[c]") {
    const LocalWheel local;
    contactd_wheel* const w = local.wheel;
    double value = 0;
    char text[8] = {};
    refused(contactd_set(w, "setup.track.spring.z", 1), w, "setup.track.spring.z", "springs");
    refused(contactd_set(w, "", 1), w, "", "setup, state");
    refused(contactd_set(w, "setup.track.cant", 3), w, "setup.track.cant", "it must lie in [-0.5, 0.5] rad");
    refused(contactd_set(w, "setup.track.cant", NAN), w, "setup.track.cant", "is nan");
    refused(contactd_set(w, "setup.track", 1), w, "setup.track", "name one of its fields");
    refused(contactd_set(w, "setup.friction.mu", 0.3), w, "setup.friction.mu", "is a list");
    refused(contactd_set(w, "setup.wheel", 1), w, "setup.wheel", "a function of its own");
    refused(contactd_set(w, "setup.model", 1), w, "setup.model", "takes a word");
    refused(contactd_set(w, "setup.force.max_iterations", 1.5), w, "setup.force.max_iterations", "a whole number");
    refused(contactd_set(w, "state.derivatives", 2), w, "state.derivatives", "0 or 1");
    refused(contactd_set(w, "setup.rail_slices[3].x", 1), w, "setup.rail_slices[3].x", "has 0");
    refused(contactd_set(w, "setup.rail_slices[x].x", 1), w, "setup.rail_slices[x].x", "is no path");
    refused(contactd_set(w, "setup.side[0]", 1), w, "setup.side[0]", "is no list");
    refused(contactd_set(w, nullptr, 1), w, "path", "is NULL");
    refused(contactd_set_word(w, "setup.model", "Hertz"), w, "setup.model", "one of full, hertz, fastsim");
    refused(contactd_set_word(w, "setup.dx", "hertz"), w, "setup.dx", "takes a number");
    refused(contactd_set_word(w, "setup.model", nullptr), w, "word", "is NULL");
    refused(contactd_clear(w, "setup.dx"), w, "setup.dx", "is always there");
    CHECK(contactd_get(w, "forces.track.Fx", &value) == CONTACTD_FAILED_PRECONDITION);
    require_ok(contactd_wheel_solve(w), w);
    refused(contactd_get(w, "forces.track", &value), w, "forces.track", "name one of its fields");
    refused(contactd_get(w, "forces.trac.Fx", &value), w, "forces.trac.Fx", "track, rail, wheelset");
    refused(contactd_get(w, "pitch", nullptr), w, "value", "is NULL");
    refused(contactd_get_word(w, "pitch", text, 8), w, "pitch", "is not a word");
    CHECK(contactd_get(w, "patches[7].place.approach", &value) == CONTACTD_NOT_FOUND);
}

TEST_CASE("Results of a contact are read by their paths, its inputs are not set so", "[c]") {
    contactd_connection* place = nullptr;
    contactd_contact* contact = nullptr;
    REQUIRE(contactd_open("local", &place) == CONTACTD_OK);
    REQUIRE(contactd_new(place, &contact) == CONTACTD_OK);
    contactd_set_grid_centred(contact, 12, 12, 0.5, 0.5);
    contactd_set_material(contact, CONTACTD_BOTH, 82000, 0.28);
    contactd_set_paraboloid(contact, 300, 300);
    contactd_set_Fn(contact, 5000);
    REQUIRE(contactd_start(contact) == CONTACTD_OK);
    REQUIRE(contactd_step(contact) == CONTACTD_OK);
    double pmax = 0, value = 0;
    char text[16] = {};
    REQUIRE(contactd_get_pmax(contact, &pmax) == CONTACTD_OK);
    REQUIRE(contactd_get(contact, "pmax", &value) == CONTACTD_OK);
    CHECK(value == pmax);
    REQUIRE(contactd_get(contact, "converged", &value) == CONTACTD_OK);
    CHECK(value == 1);
    REQUIRE(contactd_get_word(contact, "evidence.discretisation.source", text, 16) == CONTACTD_OK);
    CHECK(std::string(text) == "hertz");
    CHECK(contactd_set(contact, "Fn", 1) == CONTACTD_UNIMPLEMENTED);
    CHECK(contactd_get(nullptr, "pmax", &value) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_free(contact) == CONTACTD_OK);
    CHECK(contactd_get(contact, "pmax", &value) == CONTACTD_INVALID_ARGUMENT);
    contactd_close(place);
}

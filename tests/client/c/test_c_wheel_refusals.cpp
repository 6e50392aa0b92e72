// What the C interface refuses of wheels on rails, whatever comes in. No daemon: nothing here gets as far.
#include <catch2/catch_test_macros.hpp>

#include <fstream>
#include <limits>
#include <regex>
#include <set>
#include <sstream>

#include "every_wheel_call.hpp"

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

/// Nobody listens there.
struct Nowhere {
    Place place{"ipc:///nowhere/contactd", 0.05};
    WheelHandle wheel{place};
};

std::string field() {
    return contactd_last_field(nullptr);
}

std::set<std::string> declared_calls() {
    std::ifstream file(HEADER);
    std::stringstream text;
    text << file.rdbuf();
    const std::string header = text.str();
    const std::regex declaration(R"((contactd_\w+)\(contactd_wheel\* (?:wheel|right))");
    std::set<std::string> names;
    for (std::sregex_iterator at(header.begin(), header.end(), declaration), end; at != end; ++at)
        names.insert((*at)[1]);
    return names;
}

}  // namespace

TEST_CASE("Every function that takes a wheel is called by these tests", "[c]") {
    WheelArguments arguments;
    std::set<std::string> called;
    for (const auto& [name, call] : every_wheel_call(arguments)) called.insert(name);
    CHECK(called == declared_calls());
    CHECK(called.size() > 50);
}

TEST_CASE("A handle that is no wheel is refused by every function", "[c]") {
    Nowhere nowhere;
    const Handle contact(nowhere.place);
    contactd_wheel* freed = nullptr;
    REQUIRE(contactd_wheel_new(nowhere.place, &freed) == CONTACTD_OK);
    REQUIRE(contactd_wheel_free(freed) == CONTACTD_OK);
    contactd_contact* const other = contact;
    int elsewhere = 0;
    WheelArguments arguments;
    for (void* handle : {static_cast<void*>(nullptr), static_cast<void*>(freed), static_cast<void*>(other),
                         static_cast<void*>(&elsewhere)})
        for (const auto& [name, call] : every_wheel_call(arguments)) {
            INFO(name);
            CHECK(call(static_cast<contactd_wheel*>(handle)) == CONTACTD_INVALID_ARGUMENT);
            CHECK(field() == "wheel");
            CHECK(contactd_last_reason(nullptr) == std::string("NO_HANDLE"));
            CHECK(contactd_last_error(handle) != std::string());
        }
    CHECK(contactd_wheel_new(nullptr, &freed) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_wheel_new(nowhere.place, nullptr) == CONTACTD_INVALID_ARGUMENT);
}

TEST_CASE("There are no results before a solve, and none of a solve that failed", "[c]") {
    Nowhere nowhere;
    WheelArguments arguments;
    const auto nothing_to_read = [&] {
        for (const auto& [name, call] : every_wheel_call(arguments)) {
            if (!name.starts_with("contactd_wheel_get")) continue;
            INFO(name);
            CHECK(call(nowhere.wheel) == CONTACTD_FAILED_PRECONDITION);
            CHECK(contactd_last_reason(nowhere.wheel) == std::string("NO_RESULT"));
        }
    };
    nothing_to_read();
    CHECK(contactd_wheel_solve(nowhere.wheel) == CONTACTD_UNAVAILABLE);
    CHECK(contactd_last_code(nowhere.wheel) == CONTACTD_UNAVAILABLE);
    nothing_to_read();
}

TEST_CASE("Of a wheel, pointers that are NULL are refused by name", "[c]") {
    Nowhere nowhere;
    contactd_wheel* const w = nowhere.wheel;
    const double one[3] = {1, 2, 3};
    CHECK(contactd_wheel_set_points(w, CONTACTD_RAIL, nullptr, one, 3, 0) == CONTACTD_INVALID_ARGUMENT);
    CHECK(field() == "y");
    CHECK(contactd_wheel_set_points(w, CONTACTD_RAIL, one, nullptr, 3, 0) == CONTACTD_INVALID_ARGUMENT);
    CHECK(field() == "z");
    CHECK(contactd_wheel_set_points(w, CONTACTD_RAIL, one, one, 0, 0) == CONTACTD_INVALID_ARGUMENT);
    CHECK(field() == "count");
    CHECK(contactd_wheel_set_mu_by_angle(w, nullptr, one, 3, 0) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_wheel_set_mu_by_angle(w, one, nullptr, 3, 0) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_wheel_set_file(w, CONTACTD_RAIL, nullptr, 0) == CONTACTD_INVALID_ARGUMENT);
    CHECK(field() == "path");
}

TEST_CASE("Of a wheel, what is no number is refused by the name that it has on the wire", "[c]") {
    Nowhere nowhere;
    contactd_wheel* const w = nowhere.wheel;
    const auto refused = [&](std::int32_t code, const std::string& name) {
        CHECK(code == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_last_field(w) == name);
    };
    for (const double bad : {nan, infinite, -infinite}) {
        const double points[2] = {0, bad};
        refused(contactd_wheel_set_rail_60e1(w, bad), "setup.rail.rail_60e1.inclination");
        refused(contactd_wheel_set_arc(w, CONTACTD_WHEEL, bad, 0, -1, 1), "setup.wheel.arc.radius");
        refused(contactd_wheel_set_cone(w, CONTACTD_RAIL, 0, bad, 1), "setup.rail.cone.ends");
        refused(contactd_wheel_set_points(w, CONTACTD_RAIL, points, points, 2, 0), "setup.rail.points");
        refused(contactd_wheel_add_slice(w, bad), "setup.rail_slices.x");
        refused(contactd_wheel_add_wheel_slice(w, bad), "setup.wheel_slices.angle");
        refused(contactd_wheel_set_track(w, bad, 14, 0), "setup.track.gauge");
        refused(contactd_wheel_set_rail_origin(w, 0, bad), "setup.track.rail_origin.z");
        refused(contactd_wheel_set_roller(w, bad), "setup.track.roller_radius");
        refused(contactd_wheel_set_springs(w, bad, 1), "setup.track.springs.y");
        refused(contactd_wheel_set_springs(w, 1, bad), "setup.track.springs.z");
        refused(contactd_wheel_set_wheelset(w, 1, 1, bad), "setup.wheelset.nominal_radius");
        refused(contactd_wheel_set_material(w, CONTACTD_WHEEL, bad, 0.3), "G");
        refused(contactd_wheel_set_mu(w, bad), "setup.friction.mu");
        refused(contactd_wheel_set_mu_by_angle(w, points, points, 2, 0), "setup.friction.mu");
        refused(contactd_wheel_set_kinetic(w, 0, bad, 1), "setup.friction.kinetic.mu");
        refused(contactd_wheel_set_elements(w, 1, bad, 0), "setup.dy");
        refused(contactd_wheel_set_patch_rules(w, 1, bad, 4, 12, 0.3), "setup.patches.distance_separate");
        refused(contactd_wheel_set_tolerance(w, CONTACTD_FORCE, bad, 9), "tolerance");
        refused(contactd_wheel_set_position(w, 0, 0, bad, 0), "state.position.roll");
        refused(contactd_wheel_set_x(w, bad), "state.position.x");
        refused(contactd_wheel_set_pitch_angle(w, bad), "state.position.pitch");
        refused(contactd_wheel_set_velocity(w, 0, 0, 0, 0, 0, bad), "state.velocity.pitch");
        refused(contactd_wheel_set_deviation(w, bad, 0, 0), "state.rail.y");
        refused(contactd_wheel_set_deviation_rate(w, 0, bad, 0), "state.rail.z_velocity");
        refused(contactd_wheel_set_rail_forces(w, bad, 0), "state.rail.Fy");
        refused(contactd_wheel_set_rail_forces(w, 0, bad), "state.rail.Fz");
        refused(contactd_wheel_set_roller_pitch(w, bad), "state.roller_pitch");
        refused(contactd_wheel_set_Fz(w, bad), "state.Fz");
        refused(contactd_wheel_set_Fx(w, bad), "state.Fx");
        refused(contactd_wheel_set_timeout(w, bad), "seconds");
    }
}

TEST_CASE("Of a wheel, words that are none are refused", "[c]") {
    Nowhere nowhere;
    contactd_wheel* const w = nowhere.wheel;
    for (const std::int32_t bad : {-1, 77, std::numeric_limits<std::int32_t>::min()}) {
        CHECK(contactd_wheel_set_side(w, bad) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_wheel_set_arc(w, bad, 1, 0, -1, 1) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_wheel_set_rigid(w, bad) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_wheel_set_model(w, bad) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_wheel_set_kinetic(w, bad, 0.1, 1) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_wheel_set_conformal(w, bad) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_wheel_set_tolerance(w, bad, 1e-6, 9) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_wheel_want(w, bad, 1) == CONTACTD_INVALID_ARGUMENT);
        CHECK(field() == "array");
    }
}

TEST_CASE("What makes no sense together is refused before anything is sent", "[c]") {
    Nowhere nowhere;
    contactd_wheel* const w = nowhere.wheel;
    const auto refused = [&](const std::string& name) {
        CHECK(contactd_wheel_solve(w) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_last_field(w) == name);
    };
    require_ok(contactd_wheel_set_track(w, -3, 14, 0), w);
    refused("setup.track.gauge");
    require_ok(contactd_wheel_set_track(w, 1435, 14, 0), w);
    require_ok(contactd_wheel_set_position(w, 0, 0, 3, 0), w);
    refused("state.position.roll");
    require_ok(contactd_wheel_set_position(w, 0, 0, 0, 0), w);
    require_ok(contactd_wheel_add_slice(w, 0), w);
    refused("setup.rail_slices");
    require_ok(contactd_wheel_clear_slices(w), w);
    require_ok(contactd_wheel_add_wheel_slice(w, 1), w);
    refused("setup.wheel_slices");
    require_ok(contactd_wheel_add_wheel_slice(w, 0), w);
    refused("setup.wheel_slices[1].angle");
    require_ok(contactd_wheel_clear_wheel_slices(w), w);
    require_ok(contactd_wheel_set_springs(w, 0, -1), w);
    refused("setup.track.springs.z");
    require_ok(contactd_wheel_set_springs(w, 0, 0), w);
    require_ok(contactd_wheel_set_Fz(w, -1), w);
    refused("state.Fz");
}

TEST_CASE("A file that is no profile is refused, and what was set stays", "[c]") {
    Nowhere nowhere;
    contactd_wheel* const w = nowhere.wheel;
    CHECK(contactd_wheel_set_file(w, CONTACTD_RAIL, "/nowhere/rail.prr", 0) == CONTACTD_INVALID_ARGUMENT);
    CHECK(std::string(contactd_last_error(w)).find("/nowhere/rail.prr") != std::string::npos);
    CHECK(contactd_wheel_set_file(w, CONTACTD_RAIL, HEADER, 0) == CONTACTD_INVALID_ARGUMENT);
}

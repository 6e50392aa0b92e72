// Tests refusals of wheels on rails by the C interface for any input, without a daemon.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

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
    const std::regex declaration(R"((contactd_\w+)\((?:contactd_wheel\* (?:wheel|right)|contactd_handle handle))");
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
    CHECK(called.size() > 15);
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
            if (handle == other && !name.starts_with("contactd_wheel")) continue;  // fields of contacts are read, too
            INFO(name);
            CHECK(call(static_cast<contactd_wheel*>(handle)) == CONTACTD_INVALID_ARGUMENT);
            CHECK(field() == (name.starts_with("contactd_wheel") ? "wheel" : "handle"));
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
            if (!name.starts_with("contactd_get") && name != "contactd_length") continue;
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
    std::int32_t id = 0;
    const auto refused = [&](std::int32_t code, const std::string& name) {
        CHECK(code == CONTACTD_INVALID_ARGUMENT);
        CHECK(field() == name);
    };
    refused(contactd_set(w, nullptr, 1), "path");
    refused(contactd_set_word(w, "setup.side", nullptr), "keyword");
    refused(contactd_set_array(w, nullptr, one, 3), "path");
    refused(contactd_set_array(w, "setup.friction.mu", nullptr, 2), "values");
    refused(contactd_set_array(w, "setup.friction.mu", one, 0), "count");
    refused(contactd_want(w, nullptr, 1), "array");
    refused(contactd_path(w, nullptr, &id), "path");
    refused(contactd_path(w, "state.Fz", nullptr), "id");
    refused(contactd_read_profile(w, nullptr, "none.prr"), "path");
    refused(contactd_read_profile(w, "setup.rail", nullptr), "file");
}

TEST_CASE("Of a wheel, what is no number is refused by the path that it has", "[c]") {
    Nowhere nowhere;
    contactd_wheel* const w = nowhere.wheel;
    const auto refused = [&](std::int32_t code, const std::string& name) {
        CHECK(code == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_last_field(w) == name);
    };
    for (const double bad : {nan, infinite, -infinite}) {
        const double last[6] = {0, 0.1, 0, 0.1, 0, bad};
        for (const char* path : {"setup.rail.rail_60e1.inclination",
                                 "setup.wheel.arc.radius",
                                 "setup.rail.cone.ends.to",
                                 "setup.wheel.smoothing_length",
                                 "setup.rail_slices[0].x",
                                 "setup.wheel_slices[0].angle",
                                 "setup.rail_slices[0].profile.arc.slope",
                                 "setup.track.gauge",
                                 "setup.track.rail_origin.z",
                                 "setup.track.springs.y",
                                 "setup.bodies.upper.G",
                                 "setup.bodies.lower.nu",
                                 "setup.friction.kinetic.mu",
                                 "setup.dy",
                                 "setup.patches.distance_separate",
                                 "setup.settings.normal.tolerance",
                                 "state.position.roll",
                                 "state.velocity.pitch",
                                 "state.rail.z_velocity",
                                 "state.rail.Fz",
                                 "state.Fx"})
            refused(contactd_set(w, path, bad), path);
        refused(contactd_set(w, "setup.friction.mu", bad), "setup.friction.mu");
        refused(contactd_set_array(w, "setup.friction.mu", last, 6), "setup.friction.mu[2].mu");
        refused(contactd_set_array(w, "setup.rail.points", last, 6), "setup.rail.points[2].z");
        refused(contactd_set_array(w, "state.velocity", last, 6), "state.velocity.pitch");
        refused(contactd_wheel_set_timeout(w, bad), "seconds");
    }
    CHECK(contactd_wheel_solve(w) == CONTACTD_UNAVAILABLE);  // as created: no slice and no shape remains
}

TEST_CASE("Of a wheel, arrays and keywords that do not fit are refused", "[c]") {
    Nowhere nowhere;
    contactd_wheel* const w = nowhere.wheel;
    const double some[6] = {1, 2, 3, 4, 5, 6};
    const auto refused = [&](std::int32_t code, const std::string& name, const std::string& sentence) {
        CHECK(code == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_last_field(w) == name);
        CHECK_THAT(contactd_last_error(w), Catch::Matchers::ContainsSubstring(sentence));
    };
    refused(contactd_set_array(w, "state.velocity", some, 5), "count", "state.velocity has 6 numbers");
    refused(contactd_set_array(w, "setup.rail.points", some, 3), "count", "2 numbers for each entry");
    refused(contactd_set_array(w, "setup.rail", some, 6), "setup.rail", "is not an array");
    refused(contactd_set_array(w, "setup.side", some, 1), "setup.side", "is not an array");
    refused(contactd_set(w, "setup.wheel.s1002", 0), "setup.wheel.s1002", "is 0");
    refused(contactd_want(w, "presure", 1), "array", "element_division, pressure");
    refused(contactd_want(w, "pressure", 2), "requested", "is 2");
    refused(contactd_read_profile(w, "setup.track", "none.prr"), "setup.track", "is not a profile");
    std::int32_t input = 0, result = 0;
    REQUIRE(contactd_path(w, "state.Fz", &input) == CONTACTD_OK);
    REQUIRE(contactd_path(w, "forces.track.Fz", &result) == CONTACTD_OK);
    refused(contactd_path(w, "state.Fzz", &input), "state.Fzz", "Fz");
    refused(contactd_set_at(w, result, 1), "forces.track.Fz", "a result that cannot be set");
    refused(contactd_set_at(w, 77, 1), "id", "contactd_path");
    refused(contactd_set_at(w, -1, 1), "id", "contactd_path");
}

TEST_CASE("What makes no sense together is refused before anything is sent", "[c]") {
    Nowhere nowhere;
    contactd_wheel* const w = nowhere.wheel;
    const auto set = [&](const char* path, double value) { REQUIRE(contactd_set(w, path, value) == CONTACTD_OK); };
    const auto refused = [&](const std::string& name) {
        CHECK(contactd_wheel_solve(w) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_last_field(w) == name);
    };
    set("setup.rail_slices[0].x", 0);
    refused("setup.rail_slices");
    REQUIRE(contactd_clear(w, "setup.rail_slices") == CONTACTD_OK);
    set("setup.wheel_slices[0].angle", 1);
    refused("setup.wheel_slices");
    set("setup.wheel_slices[1].angle", 0);
    refused("setup.wheel_slices[1].angle");
    REQUIRE(contactd_clear(w, "setup.wheel_slices") == CONTACTD_OK);
    set("setup.bodies.lower.rigid", 1);
    set("setup.bodies.lower.nu", 0.3);
    refused("setup.bodies.lower.G");
}

TEST_CASE("A file that is no profile is refused, and what was set stays", "[c]") {
    Nowhere nowhere;
    contactd_wheel* const w = nowhere.wheel;
    CHECK(contactd_read_profile(w, "setup.rail", "/nowhere/rail.prr") == CONTACTD_INVALID_ARGUMENT);
    CHECK(std::string(contactd_last_error(w)).find("/nowhere/rail.prr") != std::string::npos);
    CHECK(contactd_read_profile(w, "setup.rail_slices[0].profile", HEADER) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_wheel_solve(w) == CONTACTD_UNAVAILABLE);  // without a slice
}

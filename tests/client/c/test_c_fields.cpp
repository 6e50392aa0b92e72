// Tests fields by their paths: texts, ids and bulk access are equivalent, and errors are reported immediately.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

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

void refused(std::int32_t code, contactd_wheel* wheel, const std::string& field, const std::string& sentence) {
    CHECK(code == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(wheel) == field);
    CHECK(std::string(contactd_last_error(wheel)).find(sentence) != std::string::npos);
}

}  // namespace

TEST_CASE("What is set means the same, whichever way it is named", "[c]") {
    using Setting = std::function<void(contactd_wheel*)>;
    const auto by_id = [](const char* path, double value) -> Setting {
        return [=](contactd_wheel* w) {
            std::int32_t id = -1;
            require_ok(contactd_path(w, path, &id), w);
            require_ok(contactd_set_at(w, id, value), w);
        };
    };
    const auto field = [](const char* path, double value) -> Setting {
        return [=](contactd_wheel* w) { set(w, path, value); };
    };
    const auto array = [](const char* path, const Numbers& values) -> Setting {
        return [=](contactd_wheel* w) { set_array(w, path, values); };
    };
    const auto fields = [](std::vector<std::pair<std::string, double>> all) -> Setting {
        return [=](contactd_wheel* w) {
            for (const auto& [path, value] : all) set(w, path, value);
        };
    };
    const auto [one_way, other_way] = GENERATE_COPY(table<Setting, Setting>(
        {{by_id("state.position.y", 3), field("state.position.y", 3)},
         {array("setup.track.springs", {1e5, 2e5}),
          fields({{"setup.track.springs.z", 2e5}, {"setup.track.springs.y", 1e5}})},
         {array("setup.friction.mu", {-0.2, 0.1, 0.1, 0.4}), fields({{"setup.friction.mu[0].angle", -0.2},
                                                                     {"setup.friction.mu[0].mu", 0.1},
                                                                     {"setup.friction.mu[1].angle", 0.1},
                                                                     {"setup.friction.mu[1].mu", 0.4}})},
         {field("setup.friction.mu", 0.2), array("setup.friction.mu", {0, 0.2})},
         {array("setup.wheel.cone", {-0.05, -30, 30}), fields({{"setup.wheel.cone.ends.from", -30},
                                                               {"setup.wheel.cone.ends.to", 30},
                                                               {"setup.wheel.cone.slope", -0.05}})},
         {array("setup.bodies.lower", {60000, 0.3, 0}),
          fields({{"setup.bodies.lower.rigid", 1}, {"setup.bodies.lower.nu", 0.3}, {"setup.bodies.lower.G", 60000}})},
         {fields({{"setup.wheel.arc.radius", -300}, {"setup.wheel.s1002", 1}, {"setup.dx", 0.8}}),
          field("setup.dx", 0.8)}}));
    const LocalWheel one, other, without;
    one_way(one.wheel);
    other_way(other.wheel);
    CHECK(solved(one.wheel) == solved(other.wheel));
    CHECK(solved(one.wheel) != solved(without.wheel));
}

TEST_CASE("What is read is the same, whichever way it is named", "[c]") {
    const LocalWheel local;
    contactd_wheel* const w = local.wheel;
    set(w, "setup.track.springs.y", 1e5);
    require_ok(contactd_wheel_solve(w), w);
    const Numbers forces = get_array(w, "forces"), track = get_array(w, "forces.track");
    CHECK(get(w, "forces.track.Fx") == track[0]);
    CHECK(get(w, "forces.track.Mz") == track[5]);
    CHECK(std::equal(track.begin(), track.end(), forces.begin()));
    CHECK(get(w, "patches") == 1);
    CHECK(get(w, "converged") == 1);
    CHECK(get_array(w, "patches[0].place.creepages")[2] == get(w, "patches[0].place.creepages.phi"));
    CHECK(get(w, "frictional_power") == get(w, "patches[0].solution.frictional_power"));
    CHECK(get_array(w, "rail_deflection")[0] == get(w, "rail_deflection.y"));
    CHECK(get(w, "patches[0].solution.evidence.normal.converged") == 1);
    const Numbers pressure = get_array(w, "patches[0].solution.pressure");
    CHECK(*std::ranges::max_element(pressure) == get(w, "patches[0].solution.pmax"));
    const Numbers division = get_array(w, "patches[0].solution.element_division");
    CHECK(static_cast<double>(std::ranges::count(division, CONTACTD_SLIP)) ==
          get(w, "patches[0].solution.elements.slip"));
    std::int32_t id = -1;
    double value = 0;
    require_ok(contactd_path(w, "rail_deflection.y", &id), w);
    for (const double springs : {1e5, 2e5}) {
        set(w, "setup.track.springs.y", springs);
        require_ok(contactd_wheel_solve(w), w);
        require_ok(contactd_get_at(w, id, &value), w);
        CHECK(value == get(w, "rail_deflection.y"));
    }
}

TEST_CASE("An id stays that of its path, however many paths there are", "[c]") {
    const LocalWheel local;
    contactd_wheel* const w = local.wheel;
    std::int32_t first = -1, last = -1, again = -1;
    require_ok(contactd_path(w, "state.position.yaw", &first), w);
    require_ok(contactd_wheel_solve(w), w);
    double value = 0;
    for (int k = 0; k < 1500; ++k)
        CHECK(contactd_get(w, ("patches[" + std::to_string(k + 1) + "].gap").c_str(), &value) != CONTACTD_OK);
    require_ok(contactd_path(w, "state.position.roll", &last), w);
    require_ok(contactd_path(w, "state.position.yaw", &again), w);
    CHECK(again == first);
    CHECK(last != first);
    require_ok(contactd_set_at(w, first, 0.01), w);
    require_ok(contactd_set_at(w, last, 0.001), w);
    const LocalWheel other;
    require_ok(contactd_wheel_solve(other.wheel), other.wheel);
    set(other.wheel, {{"state.position.yaw", 0.01}, {"state.position.roll", 0.001}});
    CHECK(solved(w) == solved(other.wheel));
}

TEST_CASE("What was set can be left out again", "[c]") {
    const LocalWheel local;
    contactd_wheel* const w = local.wheel;
    require_ok(contactd_clear(w, "setup.friction"), w);
    require_ok(contactd_wheel_solve(w), w);
    CHECK(get(w, "forces.track.Fx") == 0);
    double power = 0;
    CHECK(contactd_get(w, "frictional_power", &power) == CONTACTD_NOT_FOUND);
    require_ok(contactd_set(w, "setup.friction.along_profile", 0), w);
    require_ok(contactd_wheel_solve(w), w);
    CHECK(get(w, "forces.track.Fx") != 0);
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
    refused(contactd_set(w, "setup.friction.mu", -0.3), w, "setup.friction.mu", "is -0.3");
    refused(contactd_set(w, "setup.wheel_slices", 1), w, "setup.wheel_slices", "is a list");
    refused(contactd_set(w, "setup.wheel", 1), w, "setup.wheel", "name one of its fields");
    refused(contactd_set(w, "setup.wheel.circle", 1), w, "setup.wheel.circle", "s1002, rail_60e1, arc");
    refused(contactd_set(w, "setup.model", 1), w, "setup.model", "expects a word");
    refused(contactd_set(w, "setup.force.max_iterations", 1.5), w, "setup.force.max_iterations", "a whole number");
    refused(contactd_set(w, "state.derivatives", 2), w, "state.derivatives", "0 or 1");
    refused(contactd_set(w, "setup.rail_slices[3].x", 1), w, "setup.rail_slices[3].x", "has 0");
    refused(contactd_set(w, "setup.rail_slices[x].x", 1), w, "setup.rail_slices[x].x", "is not a path");
    refused(contactd_set(w, "setup.side[0]", 1), w, "setup.side[0]", "is not a list");
    refused(contactd_set(w, nullptr, 1), w, "path", "is NULL");
    refused(contactd_set_word(w, "setup.model", "Hertz"), w, "setup.model", "one of full, hertz, fastsim");
    refused(contactd_set_word(w, "setup.dx", "hertz"), w, "setup.dx", "expects a number");
    refused(contactd_set_word(w, "setup.model", nullptr), w, "keyword", "is NULL");
    refused(contactd_clear(w, "setup.dx"), w, "setup.dx", "is required");
    CHECK(contactd_get(w, "forces.track.Fx", &value) == CONTACTD_FAILED_PRECONDITION);
    require_ok(contactd_wheel_solve(w), w);
    refused(contactd_get(w, "forces.track", &value), w, "forces.track", "name one of its fields");
    refused(contactd_get(w, "forces.trac.Fx", &value), w, "forces.trac.Fx", "track, rail, wheelset");
    refused(contactd_get(w, "pitch_rate", nullptr), w, "value", "is NULL");
    refused(contactd_get_word(w, "pitch_rate", text, 8), w, "pitch_rate", "is not a word");
    CHECK(contactd_get(w, "patches[7].place.approach", &value) == CONTACTD_NOT_FOUND);
}

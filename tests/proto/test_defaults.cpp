// Tests that the defaults documented in the schemas are those of the C++ values.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <string>

#include "contactd/fields/conicity.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/proto/session.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using nlohmann::json;

namespace {

/// Returns `value` with all defaults of its schema stated.
json filled(const json& schema, json value) {
    if (value.is_array() && schema.contains("items"))
        for (json& item : value) item = filled(schema["items"], item);
    if (!value.is_object() || !schema.contains("properties")) return value;
    for (const auto& [name, property] : schema["properties"].items()) {
        if (!value.contains(name) && property.contains("default")) value[name] = property["default"];
        if (value.contains(name)) value[name] = filled(property, value[name]);
    }
    return value;
}

json filled_params(const std::string& method, const json& params) {
    json all = filled(schema(method + ".params"), params);
    CHECK(all != params);
    // Fields for points have no meaning for a formula.
    for (const char* body : {"wheel", "rail"})
        if (all.contains("setup") && all["setup"].contains(body) && !all["setup"][body].contains("points"))
            for (const char* name : {"unit", "mirror_y", "mirror_z", "smoothing_length"})
                all["setup"][body].erase(name);
    return all;
}

/// A problem, written down whole.
json written(const json& params) {
    ArrayWriter arrays(ArrayEncoding::list);
    return encode_problem(decode_problem(params, {}), arrays);
}

json profile_params(const char* wheel, const char* rail) {
    return {{"setup", {{"wheel", json::parse(wheel)}, {"rail", json::parse(rail)}}}, {"state", json::object()}};
}

}  // namespace

TEST_CASE("A wheel on its rail starts with the defaults of its schema", "[defaults]") {
    const json nothing{{"setup", json::object()}, {"state", json::object()}};
    const json all = filled_params("wheelrail.solve", nothing);
    CHECK(all["setup"]["friction"]["mu"] == 0.3);
    CHECK_NOTHROW(check_params("wheelrail.solve", all));
    CHECK(decode_wheel_rail_setup(all, {}) == WheelRailSetup{});
    CHECK(decode_wheel_rail_setup(nothing, {}) == WheelRailSetup{});
    CHECK(decode_wheel_rail_setup(json::object(), {}) == WheelRailSetup{});
    CHECK(read_value<WheelRailState>(all["state"], "state") == WheelRailState{});
    CHECK(read_value<WheelRailState>(json::object(), "state") == WheelRailState{});
    CHECK(decode_patch_fields(all).gap == PatchFields{}.gap);
}

TEST_CASE("Parts of a wheel's friction start with the defaults of the schema", "[defaults]") {
    const json some{{"setup", {{"friction", {{"kinetic", {{"mu", 0.1}, {"slip_velocity", 100}}}}}}},
                    {"state", json::object()}};
    CHECK_NOTHROW(check_params("wheelrail.solve", some));
    WheelRailSetup setup;
    setup.friction->kinetic.emplace();
    setup.friction->kinetic->mu = 0.1;
    setup.friction->kinetic->slip_velocity = 100;
    CHECK(decode_wheel_rail_setup(some, {}) == setup);
    CHECK(decode_wheel_rail_setup(filled_params("wheelrail.solve", some), {}) == setup);
}

TEST_CASE("Profiles start with the defaults of the schema", "[defaults]") {
    const json given = GENERATE(profile_params(R"({"s1002": true})", R"({"rail_60e1": {}})"),
                                profile_params(R"({"cone": {"slope": -0.05}})", R"({"arc": {"radius": 300}})"),
                                profile_params(R"({"points": [[0, 0], [1, 0]]})", R"({"points": [[0, 0], [1, 0]]})"));
    CHECK(decode_wheel_rail_setup(given, {}) == decode_wheel_rail_setup(filled_params("wheelrail.solve", given), {}));
}

TEST_CASE("A wheelset starts with the defaults of its schema", "[defaults]") {
    const json nothing{
        {"setup", json::object()}, {"left", json::object()}, {"state", {{"Fz_left", 1}, {"Fz_right", 1}}}};
    const json all = filled_params("wheelrail.wheelset", nothing);
    const WheelsetSetup setup{{}, WheelRailSetup{}};
    CHECK(decode_wheelset_setup(nothing, {}) == setup);
    CHECK(decode_wheelset_setup(all, {}) == setup);
    WheelsetState state;
    state.Fz_left = state.Fz_right = 1;
    CHECK(read_value<WheelsetState>(nothing["state"], "state") == state);
    CHECK(read_value<WheelsetState>(all["state"], "state") == state);
}

TEST_CASE("A contact starts with the defaults of its schema", "[defaults]") {
    json params = wire::solve_params();
    params["friction"] =
        GENERATE(json{{"mu", 0.4}, {"rigid_shift", {0.1, 0}}}, json{{"mu", 0.4}, {"rolling", json::object()}},
                 json{{"mu", 0.4}, {"rigid_shift", {0.1, 0}}, {"kinetic", {{"mu", 0.1}, {"slip_velocity", 3}}}});
    json all = filled_params("contact.solve", params);
    if (all["friction"].contains("rolling"))
        for (const char* of_shifts : {"rotation", "duration"}) all["friction"].erase(of_shifts);
    CHECK(written(all) == written(params));
}

TEST_CASE("Finite elements start with the defaults of their schema", "[defaults]") {
    json params = wire::ic_params();
    params["ics"] = {{"source", "fem"}, {"mesh", "hex"}};
    CHECK(decode_ic_spec(filled_params("ic.get", params)) == decode_ic_spec(params));
    params["ics"] = {{"source", "fem"}, {"body", "longitudinally_uniform"}};
    params["ics"]["section"] = GENERATE(json::parse(R"({"rail_60e1": {}})"), json::parse(R"({"rim_s1002": {}})"),
                                        json::parse(R"({"edge_block": {"width": 100, "height": 50}})"));
    const json all = filled_params("ic.get", params);
    json section_filled = params;
    section_filled["ics"]["section"] = all["ics"]["section"];
    CHECK(decode_ic_spec(section_filled) == decode_ic_spec(params));
}

TEST_CASE("Sessions, stresses and conicities start with the defaults of their schemas", "[defaults]") {
    const json opening{{"wheelrail", json::object()}}, all = filled_params("session.open", opening);
    const WheelRailSessionSpec spec = decode_wheel_rail_session_spec(all, {});
    CHECK(spec.setup == WheelRailSetup{});
    CHECK(decode_wheel_rail_session_spec(opening, {}).setup == WheelRailSetup{});
    CHECK(spec.accept_unconverged == WheelRailSessionSpec{}.accept_unconverged);

    const json step{{"session", "s"}, {"step", 1}, {"wheelrail", {{"state", json::object()}}}};
    const WheelRailStepInput input = decode_wheel_rail_step(filled_params("session.step", step));
    CHECK(input.state == WheelRailState{});
    CHECK((input.again == WheelRailStepInput{}.again && input.gap == WheelRailStepInput{}.gap));
    CHECK(input.patches == WheelRailStepInput{}.patches);

    const json stresses = filled_params("contact.subsurface", wire::subsurface_params());
    CHECK(decode_subsurface_request(stresses, {}).body == SubsurfaceRequest{}.body);

    const json heat = filled_params("contact.temperature", wire::temperature_params());
    CHECK(decode_temperature_request(heat, {}).chi == TemperatureRequest{}.chi);

    const json conicity{{"amplitudes", {3}}}, contacts{{"shifts", {0}}};
    const json& geometry = schema("wheelrail.geometry.params")["properties"];
    CHECK(read_value<ConicityRequest>(filled(geometry["conicity"], conicity), "conicity") ==
          read_value<ConicityRequest>(conicity, "conicity"));
    CHECK(read_value<ConicityRequest>(conicity, "conicity").settings == ConicityRequest{}.settings);
    CHECK(read_value<ContactsRequest>(filled(geometry["contacts"], contacts), "contacts").roll ==
          ContactsRequest{}.roll);
}

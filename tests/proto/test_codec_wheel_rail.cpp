// Tests wheelrail.solve and wheelrail.geometry.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <limits>

#include "contactd/error.hpp"
#include "contactd/fields/conicity.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

json sent(const json& message) {
    return json::parse(dump(message));
}

/// Sets every field to a value other than its default.
WheelRailSetup unusual_setup() {
    WheelRailSetup setup;
    setup.side = Side::left;
    setup.wheel = {ProfileKind::wheel, ConeProfile{-0.05, -30, 30.5}};
    setup.rail = {ProfileKind::rail, ProfilePoints{{{-10, 0.1 + 0.2}, {0, 0}, {10, 0.17}}, 1000, true, true, 5}};
    setup.rail_slices = {
        {-5, {ProfileKind::rail, Rail60E1{0.05}}},
        {5, {ProfileKind::rail, ProfilePoints{{{-1, 0}, {1, 0.5}}}}},
        {6, {ProfileKind::rail, ProfileFile{"a.csv", "0 0\n\t1 \"0.5\"\n", 25.4, true, false, 1, -2, 5}}},
        {7, {ProfileKind::rail, ProfileFile{"a.ban", "0 0\n1 -1\n"}}}};
    setup.wheel_slices = {{-0.1, {ProfileKind::wheel, S1002{}}},
                          {0.2, {ProfileKind::wheel, ProfilePoints{{{-1, 0}, {1, 0.25}}}}}};
    setup.rigid_slip = RigidSlipKind::surfaces;
    setup.conformal = Conformal::half_space;
    setup.track = {1520, 13, 0.05, ProfilePoint{760.5, -1}, 500, true, RailSprings{2e4, 1e5}};
    setup.wheelset = {1440, -69, 475};
    setup.bodies = Bodies::of({{80000, 0.3}, Material::rigid()});
    setup.friction = WheelRailFriction{{{-1.2, 0.1}, {0, 0.4}}, true, KineticFriction{SlipLaw::linear, 0.05, 900}};
    setup.dx = 0.5;
    setup.dy = 0.25;
    setup.dq = 0.4;
    setup.patches = {1, 7, 3, 11, 0.5, ContactSearch::mesh};
    setup.wheel_surface = WheelSurfaceKind::bilinear;
    setup.settings.tangential = {1e-7, 12};
    setup.force = {1e-5, 30};
    return setup;
}

WheelRailState unusual_state() {
    WheelRailState state;
    state.position = {1, 2, 0.1, 0.2, 77, -300};
    state.velocity = {3, 4, 5, 6, 7, 8};
    state.rail = {9, 10, 0.3, 12, 13, 14, 18, -19};
    state.roller_pitch = 15;
    state.Fz = 16;
    state.Fx = -17;
    state.derivatives = true;
    return state;
}

ContactPlace place() {
    ContactPlace place;
    place.reference = {1, 2, 3, -0.1};
    place.regions = {{{4, 5, 6, 0.2}, {-1, 1}, {-2, 3}, {0, 0.5}, 0.01, 1e-5}, {{7, 8, 9, 0}, {}, {}, {}, 0.02, 2e-5}};
    place.shares = {1, 0.4, 0.4, 1};
    place.grid = {2, 1, 0.5, 0.5, -0.75, 0.25};
    place.approach = 0.1 + 0.2;
    place.penetration = 0.25;
    place.creepages = {1e-3, -2e-3, 3e-4, 0, 2000};
    place.radii = {460, -330, infinite, 300};
    place.rows = {{751, 0.1, -0.2}};
    return place;
}

WheelRailSolution solution() {
    WheelRailSolution solution;
    solution.z = 0.2;
    solution.pitch_rate = -4.3;
    solution.clearance = -0.02;
    solution.forces.track = {1, 2, 3, 4, 5, 6};
    solution.forces.rail = {7, 8, 9, 10, 11, 12};
    solution.forces.wheelset = {13, 14, 15, 16, 17, 18};
    solution.force = SolverEvidence{3, 1e-9, true, 0.1};
    solution.pitch_search = SolverEvidence{4, 1e-8, false, 0.2};
    solution.rail_deflection = {0.3, 0.7};
    solution.rail_search = SolverEvidence{5, 1e-7, true, 0.3};
    solution.derivatives.emplace().position.roll = {31, 32, 33, 34, 35, 36};
    solution.derivatives->velocity.pitch = {41, 42, 43, 44, 45, 46};
    solution.warnings = {"The contact reaches the end of a profile."};
    WheelRailPatch& patch = solution.patches.emplace_back();
    patch.place = place();
    patch.gap = {0, 0.5};
    patch.solution.pressure = {1, 2};
    patch.solution.traction_x = {-0.1, 0.2};
    patch.solution.traction_y = {0, 0};
    patch.solution.element_division = {ElementState::adhesion, ElementState::slip};
    patch.solution.forces = {3, 0.1, 0, 0};
    patch.solution.evidence.normal = {2, 1e-10, true, 0};
    patch.forces.track = {21, 22, 23, 24, 25, 26};
    return solution;
}

std::string refusal_of(const json& params, const Frames& frames = {}) {
    const auto status = wire::status_thrown_by([&] {
        check_params("wheelrail.solve", params);
        decode_wheel_rail_setup(params, frames);
    });
    return status ? status->reason + ": " + status->message : "taken";
}

json minimal() {
    return {{"setup", json::object()}, {"state", json::object()}};
}

}  // namespace

TEST_CASE("A wheel on a rail arrives as it was sent", "[codec]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    const WheelRailSetup setup = unusual_setup();
    const WheelRailState state = unusual_state();
    const PatchFields fields{{SolutionField::pressure}, true};
    ArrayWriter arrays(encoding);

    const json params = sent(encode_wheel_rail_request(setup, state, fields, arrays));
    const auto frames = arrays.take_frames();
    CHECK_NOTHROW(check_params("wheelrail.solve", params));
    CHECK_NOTHROW(check_frames_used(params, frames));

    CHECK(decode_wheel_rail_setup(params, frames) == setup);
    CHECK(read_value<WheelRailState>(params["state"], "state") == state);
    CHECK(decode_patch_fields(params).solution == fields.solution);
    CHECK(decode_patch_fields(params).gap);
}

TEST_CASE("A wheelset arrives as it was sent", "[codec]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    WheelsetSetup setup{unusual_setup()};
    const bool own = GENERATE(false, true);
    if (own) setup.left = WheelRailSetup{};
    const WheelsetState state{{1, 2, 0.1, 0.2, 77},
                              {3, 4, 5, 6, 7, 8},
                              {24, 25, 26, 0.1, 0.2, 29, 30, 31, 32, 33, 34, 35},
                              {36, 37, 38, 0.3, 0.4, 41, 42, 43, 44, 45, 46, 47},
                              {9, 10, 0.3, 12, 13, 14},
                              {15, 16, 0.4, 18, 19, 20},
                              21,
                              22,
                              23};
    ArrayWriter arrays(encoding);
    const json params = sent(encode_wheelset_request(setup, state, {{SolutionField::pressure}, true}, arrays));
    const auto frames = arrays.take_frames();
    CHECK_NOTHROW(check_params("wheelrail.wheelset", params));
    CHECK_NOTHROW(check_frames_used(params, frames));
    CHECK(decode_wheelset_setup(params, frames) == setup);
    CHECK(read_value<WheelsetState>(params["state"], "state") == state);
    CHECK(decode_patch_fields(params).gap);
}

TEST_CASE("The fields of a left wheel are named as such", "[codec]") {
    const json params = {{"left", {{"rail", {{"points", json::array({{0, 0, 1}, {1, 0, 1}})}}}}}};
    const auto status = wire::status_thrown_by([&] { decode_wheelset_setup(params, {}); });
    REQUIRE(status);
    REQUIRE_FALSE(status->violations.empty());
    CHECK(status->violations[0].field == "left.rail.points");
}

TEST_CASE("The solution of a wheelset comes back exactly", "[codec]") {
    WheelsetSolution original;
    original.z = 0.1 + 0.2;
    original.roll = -1e-3;
    original.left = original.right = solution();
    original.right.pitch_rate = 5;
    original.roll_search = {3, 1e-7, true, 0.5};
    original.warnings = {"No roll."};
    ArrayWriter arrays(ArrayEncoding::frame);
    const json result = sent(encode_wheelset_solution(original, {all_solution_fields, true}, arrays));
    CHECK(violations_of("wheelrail.wheelset.result", result).empty());
    const WheelsetSolution read = decode_wheelset_solution(result, arrays.take_frames());
    CHECK(read.z == original.z);
    CHECK(read.roll == original.roll);
    CHECK(read.roll_search.residual == 1e-7);
    CHECK(read.warnings == original.warnings);
    CHECK(read.right.pitch_rate == 5);
    CHECK(read.left.pitch_rate == original.left.pitch_rate);
    REQUIRE(read.right.patches.size() == 1);
    CHECK(read.right.patches[0].solution.pressure == original.right.patches[0].solution.pressure);
    CHECK(read.left.patches[0].gap == original.left.patches[0].gap);
}

TEST_CASE("Each profile arrives as it was sent", "[codec]") {
    const ProfileShape shape =
        GENERATE(ProfileShape(S1002{}), ProfileShape(Rail60E1{0.05}), ProfileShape(ArcProfile{-300, 0.1, -20, 21}),
                 ProfileShape(ConeProfile{0.025, -7, 8}), ProfileShape(StandardProfile{StandardName::n54E1, 0.05}));
    WheelRailSetup setup;
    setup.wheel.shape = shape;
    ArrayWriter arrays(ArrayEncoding::frame);
    const json params = sent(encode_wheel_rail_request(setup, {}, {}, arrays));
    CHECK_NOTHROW(check_params("wheelrail.solve", params));
    CHECK(decode_wheel_rail_setup(params, {}) == setup);
}

TEST_CASE("What is not said of a wheel on a rail is as in C++, and no friction is said", "[codec]") {
    CHECK(decode_wheel_rail_setup(minimal(), {}) == WheelRailSetup{});
    CHECK(decode_patch_fields(minimal()).solution == all_solution_fields);
    CHECK_FALSE(decode_patch_fields(minimal()).gap);
    WheelRailSetup frictionless;
    frictionless.friction.reset();
    ArrayWriter arrays(ArrayEncoding::frame);
    const json params = sent(encode_wheel_rail_request(frictionless, {}, {}, arrays));
    CHECK(params["setup"]["friction"].is_null());
    CHECK_NOTHROW(check_params("wheelrail.solve", params));
    CHECK(decode_wheel_rail_setup(params, {}) == frictionless);
}

TEST_CASE("The states of a search arrive as they were sent", "[codec]") {
    const std::vector<WheelRailState> states{unusual_state(), {}};
    ArrayWriter arrays(ArrayEncoding::frame);
    const json params = sent(encode_geometry_request(unusual_setup(), states, arrays));
    CHECK_NOTHROW(check_params("wheelrail.geometry", params));
    REQUIRE(params["states"].size() == 2);
    CHECK(read_value<WheelRailState>(params["states"][0], "state") == states[0]);
    CHECK(read_value<WheelRailState>(params["states"][1], "state") == states[1]);
}

TEST_CASE("The solution of a wheel on a rail comes back exactly", "[codec]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    const WheelRailSolution original = solution();
    ArrayWriter arrays(encoding);
    const json result = sent(encode_wheel_rail_solution(original, {all_solution_fields, true}, arrays));
    CHECK(violations_of("wheelrail.solve.result", result).empty());
    CHECK(result["converged"] == false);

    const WheelRailSolution read = decode_wheel_rail_solution(result, arrays.take_frames());

    CHECK(read.z == original.z);
    CHECK(read.pitch_rate == original.pitch_rate);
    CHECK(read.clearance == original.clearance);
    CHECK(read.warnings == original.warnings);
    CHECK(read.forces.track == original.forces.track);
    CHECK(read.forces.rail == original.forces.rail);
    CHECK(read.forces.wheelset == original.forces.wheelset);
    REQUIRE(read.force);
    CHECK(read.force->iterations == 3);
    REQUIRE(read.pitch_search);
    CHECK(read.pitch_search->residual == 1e-8);
    CHECK(read.rail_deflection == original.rail_deflection);
    REQUIRE(read.rail_search);
    CHECK(read.rail_search->residual == 1e-7);
    CHECK(read.derivatives == original.derivatives);
    REQUIRE(read.patches.size() == 1);
    const WheelRailPatch &patch = read.patches[0], &expected = original.patches[0];
    CHECK(patch.place.reference == expected.place.reference);
    CHECK(patch.place.regions == expected.place.regions);
    CHECK(patch.place.shares == expected.place.shares);
    CHECK(patch.place.grid == expected.place.grid);
    CHECK(patch.place.approach == expected.place.approach);
    CHECK(patch.place.penetration == expected.place.penetration);
    CHECK(patch.place.creepages == expected.place.creepages);
    CHECK(patch.place.radii == expected.place.radii);
    CHECK(patch.gap == expected.gap);
    CHECK(patch.solution.pressure == expected.solution.pressure);
    CHECK(patch.solution.traction_x == expected.solution.traction_x);
    CHECK(patch.solution.element_division == expected.solution.element_division);
    CHECK(patch.solution.forces.Fn == 3);
    CHECK(patch.solution.evidence.normal.iterations == 2);
    CHECK(patch.forces.track == expected.forces.track);
}

TEST_CASE("Arrays of patches come where they are asked for", "[codec]") {
    ArrayWriter arrays(ArrayEncoding::list);
    const json result = encode_wheel_rail_solution(solution(), {{SolutionField::traction_y}, false}, arrays);
    const json& patch = result["patches"][0];
    CHECK_FALSE(patch.contains("gap"));
    CHECK_FALSE(patch["solution"].contains("pressure"));
    CHECK(patch["solution"].contains("traction_y"));
}

TEST_CASE("No contact is an answer", "[codec]") {
    ArrayWriter arrays(ArrayEncoding::frame);
    WheelRailSolution none;
    const json result = sent(encode_wheel_rail_solution(none, {}, arrays));
    CHECK(violations_of("wheelrail.solve.result", result).empty());
    CHECK(result["converged"] == true);
    const WheelRailSolution read = decode_wheel_rail_solution(result, {});
    CHECK_FALSE(read.in_contact());
    CHECK_FALSE(read.clearance);
    CHECK_FALSE(read.force);
}

TEST_CASE("Geometries come back exactly", "[codec]") {
    WheelRailGeometry geometry;
    geometry.z = 0.3;
    geometry.clearance = -0.1;
    geometry.places = {place()};
    geometry.warnings = {"One."};
    const std::vector<WheelRailGeometry> geometries{geometry, {}};
    const json result = sent(encode_wheel_rail_geometries(geometries));
    CHECK(violations_of("wheelrail.geometry.result", result).empty());

    const std::vector<WheelRailGeometry> read = decode_wheel_rail_geometries(result);

    REQUIRE(read.size() == 2);
    CHECK(read[0].z == 0.3);
    CHECK(read[0].clearance == -0.1);
    CHECK(read[0].warnings == geometry.warnings);
    REQUIRE(read[0].places.size() == 1);
    CHECK(read[0].places[0].regions == geometry.places[0].regions);
    CHECK(read[0].places[0].radii == geometry.places[0].radii);
    CHECK(read[1].places.empty());
    CHECK_FALSE(read[1].clearance);
}

TEST_CASE("Conicities are asked for and come back", "[codec]") {
    const ConicityRequest expected{{1, 2.5}, {WheelsetRoll::demanded, 1510, 1e-2}};
    ArrayWriter arrays(ArrayEncoding::frame);
    const json params = sent(encode_conicity_request({unusual_setup()}, expected, arrays));
    CHECK_NOTHROW(check_params("wheelrail.geometry", params));
    CHECK(read_value<ConicityRequest>(params["conicity"], "conicity") == expected);
    CHECK(read_value<ConicityRequest>({{"amplitudes", {3}}}, "conicity") == ConicityRequest{{3}});

    const double none = std::numeric_limits<double>::quiet_NaN();
    const std::vector<EquivalentConicity> conicities{{1, 0.2, 0.21, 30e3}, {2, none, 0.3, infinite}};
    const json result = sent({{"geometries", json::array()}, {"conicities", encode_conicities(conicities)}});
    CHECK(violations_of("wheelrail.geometry.result", result).empty());
    const auto read = decode_conicities(result["conicities"]);
    REQUIRE(read.size() == 2);
    CHECK(read[0].integrated == 0.2);
    CHECK(read[0].wavelength == 30e3);
    CHECK(std::isnan(read[1].integrated));
    CHECK(read[1].harmonic == 0.3);
}

TEST_CASE("A force that is not finite is not sent", "[codec]") {
    WheelRailSolution bad = solution();
    bad.patches[0].forces.rail.My = infinite;
    ArrayWriter arrays(ArrayEncoding::frame);
    CHECK_THROWS_AS(encode_wheel_rail_solution(bad, {}, arrays), Error);
}

TEST_CASE("Bodies that the daemon has no grid for are refused before they are sent", "[codec]") {
    WheelRailSetup setup;
    Ics ics;
    ics.source = IcSource::fem;
    setup.bodies.lower.ics = ics;
    ArrayWriter arrays(ArrayEncoding::frame);
    CHECK_THROWS_AS(encode_wheel_rail_request(setup, {}, {}, arrays), InvalidArgument);
}

TEST_CASE("A bad field of a wheel on a rail is named", "[codec]") {
    struct Case {
        const char* pointer;
        const char* value;
        const char* says;
    };
    const auto c = GENERATE(
        Case{"/setup/side", "\"both\"", R"(setup.side is "both"; it must be one of "left", "right")"},
        Case{"/setup/track", R"({"gauge": 0})", "setup.track.gauge is 0"},
        Case{"/setup/track", R"({"width": 0})", "setup.track.width is not a field of setup.track"},
        Case{"/setup/track", R"({"rail_origin": {"y": 1}})", "setup.track.rail_origin.z is missing"},
        Case{"/setup/wheel", "{}", "setup.wheel.s1002 is missing"},
        Case{"/setup/wheel", R"({"s1002": true, "unit": 1})", "setup.wheel.unit cannot be combined with s1002"},
        Case{"/setup/wheel", R"({"s1002": true, "cone": {"slope": 0}})", "cone cannot be combined with s1002"},
        Case{"/setup/wheel", R"({"cone": {}})", "setup.wheel.cone.slope is missing"},
        Case{"/setup/wheel", R"({"cone": {"slope": 0.1, "ends": [5, 5.5]}})",
             "setup.wheel.cone.ends are [5,5.5]; the second must be at least 1 mm above the first"},
        Case{"/setup/rail", R"({"arc": {"radius": 300, "ends": [5]}})", "setup.rail.arc.ends has 1 values"},
        Case{"/setup/rail", R"({"points": [1, 2]})",
             "ARRAY_INVALID: setup.rail.points has shape [2]; it must be [n,2]"},
        Case{"/setup/rail", R"({"points": [[1, 2, 3]]})", "setup.rail.points has shape [1,3]; it must be [n,2]"},
        Case{"/setup/rail", R"({"points": [[1, 2], [3]]})", "setup.rail.points has 1 values at [1]; it must have 2"},
        Case{"/setup/bodies", R"({"upper": {"G": 1, "nu": 0, "ics": {}}})", "setup.bodies.upper.ics is not a field"},
        Case{"/setup/friction", "0.3", "setup.friction is 0.3; it must be an object with"},
        Case{"/setup/friction", R"({"mu": [{"angle": 0}]})", "setup.friction.mu[0].mu is missing"},
        Case{"/setup/friction", R"({"mu": []})", "setup.friction.mu has 0 values"},
        Case{"/setup/rail_slices", R"([{"x": 0, "profile": {"s1002": true}}])", "setup.rail_slices has 1 values"},
        Case{"/setup/rail_slices", R"([{"x": 0, "profile": {"points": [1]}}, {"x": 1, "profile": {"s1002": true}}])",
             "setup.rail_slices[0].profile.points has shape [1]"},
        Case{"/setup/rigid_slip", "\"flat\"", "setup.rigid_slip is \"flat\""}, Case{"/setup/dx", "0", "setup.dx is 0"},
        Case{"/state/Fz", "0", "state.Fz is 0"},
        Case{"/state/position", R"({"roll": 3})", "state.position.roll is 3; it must lie in [-0.5, 0.5]"},
        Case{"/state/speed", "1", "state.speed is not a field of state"});
    CAPTURE(c.pointer, c.value);
    json params = minimal();
    params[json::json_pointer(c.pointer)] = json::parse(c.value);
    CHECK_THAT(refusal_of(params), ContainsSubstring(c.says));
}

TEST_CASE("Points of a profile are limited before they take memory", "[codec]") {
    json params = minimal();
    params["setup"]["rail"]["points"]["$array"] = {{"frame", 1}, {"dtype", "<f8"}, {"shape", {4'000'000, 2}}};
    CHECK_THAT(
        refusal_of(params, {""}),
        ContainsSubstring("LIMIT_EXCEEDED: setup.rail.points has 4000000 entries, but at most 20000 are allowed"));
}

TEST_CASE("Points of many slices are limited, though they come in one frame", "[codec]") {
    json params = minimal();
    json slice{{"x", 0}};
    slice["profile"]["points"]["$array"] = {{"frame", 1}, {"dtype", "<f8"}, {"shape", {20'000, 2}}};
    params["setup"]["rail_slices"] = json(11, slice);
    CHECK_THAT(refusal_of(params, {std::string(320'000, '\0')}),
               ContainsSubstring("LIMIT_EXCEEDED: setup.rail_slices have more than 200000 points together"));
}

TEST_CASE("Contacts of a wheelset are asked for and come back exactly", "[codec]") {
    const ContactsRequest expected{{-1, 0.1 + 0.2}, WheelsetRoll::demanded};
    const WheelsetSetup setup{WheelRailSetup{}, unusual_setup()};
    ArrayWriter asked(ArrayEncoding::frame);
    const json params = sent(encode_contacts_request(setup, expected, asked));
    CHECK_NOTHROW(check_params("wheelrail.geometry", params));
    CHECK(decode_wheelset_setup(params, asked.take_frames()) == setup);
    CHECK(read_value<ContactsRequest>(params["contacts"], "contacts") == expected);
    CHECK(read_value<ContactsRequest>({{"shifts", {3}}}, "contacts") == ContactsRequest{{3}});

    const std::vector<WheelsetContacts> contacts{
        {1, -0.1, {-750, 0.1, 0.02, 459, 0.2, 1, -1, true}, {751, 0.3, -0.05, 461.5, 0.4, 2, -2, false}}};
    const json result = sent({{"geometries", json::array()}, {"contacts", encode_contacts(contacts)}});
    CHECK(violations_of("wheelrail.geometry.result", result).empty());
    CHECK(result["contacts"][0]["radius_difference"] == 2.5);
    CHECK(decode_contacts(result["contacts"]) == contacts);
}

TEST_CASE("Placed profiles are asked for and come back exactly", "[codec]") {
    ArrayWriter asked(ArrayEncoding::list);
    CHECK_NOTHROW(check_params("wheelrail.geometry", sent(encode_profiles_request({}, asked))));

    const ProfilesOfSides profiles{{{{0, 1}, {2, 3}}, {{4, 5}}, 750, {751, 0.5}}, {{{6, 7}}, {{8, 9}}, 8, {9, 10}}};
    ArrayWriter arrays(GENERATE(ArrayEncoding::frame, ArrayEncoding::list));
    const json result = sent({{"geometries", json::array()}, {"profiles", encode_profiles(profiles, arrays)}});
    CHECK(violations_of("wheelrail.geometry.result", result).empty());
    CHECK(decode_profiles(result["profiles"], arrays.take_frames()) == profiles);
}

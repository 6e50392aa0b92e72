// Tests messages for a wheel on a rail, and the reading of answers.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <chrono>

#include "contactd/client/client.hpp"
#include "contactd/client/session.hpp"
#include "contactd/fields/conicity.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/session.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "fake_solver.hpp"

using namespace contactd;
using namespace contactd::client;
using namespace std::chrono_literals;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using fake::Frames, fake::message_of;
using nlohmann::json;

namespace {

WheelRailPatch patch_with(std::size_t pressures) {
    WheelRailPatch patch;
    patch.place.grid = Grid::of_elements(2, 1, 0.2, 0.2);
    patch.place.reference.y = 750;
    patch.solution.pressure.assign(pressures, 3);
    return patch;
}

}  // namespace

TEST_CASE("Calls that may need tables of sections wait as long as builds do", "[client]") {
    std::vector<std::string> heard;
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> {
        heard.push_back(request["method"].get<std::string>() + " " + request["timeout_ms"].dump());
        if (request["method"] != "session.open")
            return {{fake::failure(request, {{"code", 5}, {"name", "NOT_FOUND"}, {"message", "No."}})}};
        const SessionReply told{std::string(32, 's'), 60, 0, {}};
        return {{fake::reply(request, proto::encode_session_reply(told))}};
    });
    Client client(daemon.endpoint(), {.timeout = 5000ms, .build_timeout = 7000ms});
    WheelRailSessionSpec spec;
    spec.setup.conformal = Conformal::fem;
    WheelRailSession session(client, spec);
    WheelRailStepInput input;
    input.state.Fz = 7;
    WheelsetState state;
    state.Fz_left = state.Fz_right = 7;
    const std::vector<AnySessionStep> steps{WheelRailSessionStep{session, input}};

    CHECK_THROWS_AS(client.wheel_rail(spec.setup, input.state), StatusError);
    CHECK_THROWS_AS(client.wheelset({.setup = {}, .left = spec.setup}, state), StatusError);
    CHECK_THROWS_AS(client.wheel_rail_geometry(spec.setup, std::vector{input.state}), StatusError);
    CHECK_THROWS_AS(session.step(input), StatusError);
    CHECK_THROWS_AS(step_many(steps), StatusError);
    static_cast<void>(session.release());

    CHECK(heard == std::vector<std::string>{"session.open 5000", "wheelrail.solve 7000", "wheelrail.wheelset 7000",
                                            "wheelrail.geometry 5000", "session.step 7000", "session.step_many 7000"});
}

TEST_CASE("A wheel on a rail is asked for and read", "[client]") {
    std::size_t pressures = 2;
    WheelRailSetup setup;
    setup.side = Side::left;
    WheelRailState state;
    state.Fz = 7;
    fake::Daemon daemon([&](const json& request, const Frames& frames) -> std::vector<Frames> {
        CHECK(request["method"] == "wheelrail.solve");
        CHECK(proto::decode_wheel_rail_setup(request["params"], frames) == setup);
        WheelRailSolution solution;
        solution.z = *proto::read_value<WheelRailState>(request["params"]["state"], "state").Fz;
        solution.patches = {patch_with(pressures)};
        proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
        const json result = proto::encode_wheel_rail_solution(
            solution, {pressures == 2 ? SolutionFields{SolutionField::pressure} : SolutionFields{}, false}, arrays);
        return message_of(request, result, arrays);
    });
    Client client(daemon.endpoint());

    SECTION("as it comes") {
        const WheelRailSolution solution = client.wheel_rail(setup, state, {}, {SolutionField::pressure});
        CHECK(solution.z == 7);
        REQUIRE(solution.patches.size() == 1);
        CHECK(solution.patches[0].solution.pressure == std::vector<double>{3, 3});
    }
    SECTION("an array that was asked for and did not come is the daemon's fault") {
        pressures = 0;
        CHECK_THROWS_AS(client.wheel_rail(setup, state), ProtocolError);
    }
    SECTION("a bad field is named before anything is sent") {
        state.position.roll = 3;
        CHECK_THROWS_MATCHES(client.wheel_rail(setup, state), InvalidArgument,
                             MessageMatches(ContainsSubstring("state.position.roll is 3")));
        setup.track.gauge = -1;
        CHECK_THROWS_MATCHES(client.wheel_rail(setup, state), InvalidArgument,
                             MessageMatches(ContainsSubstring("setup.track.gauge is -1")));
    }
}

TEST_CASE("A wheelset is asked for and read", "[client]") {
    WheelsetSetup setup;
    setup.left = WheelRailSetup{};
    setup.left->rail.shape = Rail60E1{1.0 / 20};
    WheelsetState state;
    state.Fz_left = 7;
    state.Fz_right = 8;
    std::size_t pressures = 2;
    fake::Daemon daemon([&](const json& request, const Frames& frames) -> std::vector<Frames> {
        CHECK(request["method"] == "wheelrail.wheelset");
        CHECK(proto::decode_wheelset_setup(request["params"], frames) == setup);
        CHECK(proto::read_value<WheelsetState>(request["params"]["state"], "state") == state);
        WheelsetSolution solution;
        solution.roll = -0.01;
        solution.right.patches = {patch_with(pressures)};
        proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
        const SolutionFields sent = pressures == 2 ? SolutionFields{SolutionField::pressure} : SolutionFields{};
        return message_of(request, proto::encode_wheelset_solution(solution, {sent, false}, arrays), arrays);
    });
    Client client(daemon.endpoint());

    SECTION("as it comes") {
        const WheelsetSolution solution = client.wheelset(setup, state, {}, {SolutionField::pressure});
        CHECK(solution.roll == -0.01);
        REQUIRE(solution.right.patches.size() == 1);
        CHECK(solution.right.patches[0].solution.pressure == std::vector<double>{3, 3});
    }
    SECTION("an array that was asked for and did not come is the daemon's fault") {
        pressures = 0;
        CHECK_THROWS_AS(client.wheelset(setup, state), ProtocolError);
    }
    SECTION("a bad field is named before anything is sent") {
        state.left_rail.y = 1e9;
        CHECK_THROWS_MATCHES(client.wheelset(setup, state), InvalidArgument,
                             MessageMatches(ContainsSubstring("state.left_rail.y is 1e+09")));
        setup.left->dx = -1;
        CHECK_THROWS_MATCHES(client.wheelset(setup, state), InvalidArgument,
                             MessageMatches(ContainsSubstring("left.dx is -1")));
    }
}

TEST_CASE("Geometries are asked for and read", "[client]") {
    std::vector<WheelRailGeometry> found(2);
    found[1].z = 0.5;
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> {
        CHECK(request["method"] == "wheelrail.geometry");
        return {{fake::reply(request, proto::encode_wheel_rail_geometries(found))}};
    });
    Client client(daemon.endpoint());
    std::vector<WheelRailState> states(2);

    SECTION("one for each state") {
        const auto geometries = client.wheel_rail_geometry({}, states);
        REQUIRE(geometries.size() == 2);
        CHECK(geometries[1].z == 0.5);
    }
    SECTION("none of none, without asking") {
        CHECK(client.wheel_rail_geometry({}, {}).empty());
    }
    SECTION("too few are the daemon's fault") {
        found.pop_back();
        CHECK_THROWS_AS(client.wheel_rail_geometry({}, states), ProtocolError);
    }
    SECTION("a bad state is named") {
        states[1].Fz = -1;
        CHECK_THROWS_MATCHES(client.wheel_rail_geometry({}, states), InvalidArgument,
                             MessageMatches(ContainsSubstring("states[1].Fz is -1")));
    }
}

TEST_CASE("Conicities are asked for and read", "[client]") {
    const ConicityRequest wanted{{1, 3}, {WheelsetRoll::demanded, 1510, 1e-2}};
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> {
        CHECK(proto::read_value<ConicityRequest>(request["params"]["conicity"], "conicity") == wanted);
        const std::vector<EquivalentConicity> conicities{{1, 0.2, 0.21, 30e3}};
        return {{fake::reply(request,
                             {{"geometries", json::array()}, {"conicities", proto::encode_conicities(conicities)}})}};
    });
    Client client(daemon.endpoint());
    const auto conicities = client.equivalent_conicities({}, wanted);
    REQUIRE(conicities.size() == 1);
    CHECK(conicities[0].harmonic == 0.21);
}

TEST_CASE("Contacts and profiles of a wheelset are asked for and read", "[client]") {
    WheelsetSetup setup;
    setup.left = WheelRailSetup{};
    setup.left->dx = 0.7;
    bool answers = true;
    const std::vector<WheelsetContacts> contacts{{1, 0.1, {}, {750}}};
    const ProfilesOfSides profiles{{{{1, 2}}, {{3, 4}}, 5, {6, 7}}, {}};
    fake::Daemon daemon([&](const json& request, const Frames& frames) -> std::vector<Frames> {
        CHECK(request["method"] == "wheelrail.geometry");
        CHECK(proto::decode_wheelset_setup(request["params"], frames) == setup);
        proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
        json result = {{"geometries", json::array()}};
        if (answers && request["params"].contains("contacts")) result["contacts"] = proto::encode_contacts(contacts);
        if (answers && request["params"].contains("profiles"))
            result["profiles"] = proto::encode_profiles(profiles, arrays);
        return message_of(request, result, arrays);
    });
    Client client(daemon.endpoint());
    CHECK(client.wheelset_contacts(setup, {{1}}) == contacts);
    CHECK(client.placed_profiles(setup) == profiles);
    answers = false;
    CHECK_THROWS_AS(client.wheelset_contacts(setup, {{1}}), ProtocolError);
    CHECK_THROWS_AS(client.placed_profiles(setup), ProtocolError);
}

#include <catch2/catch_test_macros.hpp>
#include <limits>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/proto/session.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using nlohmann::json;

namespace {

SessionSpec spec() {
    SessionSpec spec{};
    spec.setup.grid = Grid{3, 2, 0.1, 0.2, -7, 0.3};
    spec.setup.bodies = {{200, 0.42}, {100, 0.3}};
    spec.load.gap = std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
    spec.load.approach = 0.02;
    Rolling rolling;
    rolling.xi = 1e-3;
    rolling.dq = 0.05;
    rolling.kind = RollingKind::transient;
    rolling.force.Fy = 2;
    spec.setup.friction = FrictionLaw{{0.1, 0.2, 0.3, 0.4, 0.5, 0.6}};
    spec.load.motion = rolling;
    spec.load.previous.pressure = {1, 2, 3, 4, 5, 6};
    spec.load.derivatives = true;
    spec.lease_seconds = 7;
    spec.accept_unconverged = true;
    return spec;
}

SessionSpec arrived(const SessionSpec& original) {
    ArrayWriter arrays(ArrayEncoding::frame);
    const json params = json::parse(dump(encode_session_spec(original, arrays)));
    CAPTURE(params.dump());
    CHECK(violations_of("session.open.params", params).empty());
    const Frames frames = arrays.take_frames();
    CHECK_NOTHROW(check_frames_used(params, frames));
    return decode_session_spec(params, frames);
}

/// Returns the problem of `opened` after a step with `input`.
ContactProblem stepped(const SessionSpec& opened, const json& input, const std::optional<Motion>& last = {}) {
    json params = input;
    params["session"] = "s";
    params["step"] = 1;
    CAPTURE(params.dump());
    REQUIRE(violations_of("session.step.params", params).empty());
    ContactProblem problem{opened.setup, opened.load};
    apply_step(params, {}, last, problem);
    return problem;
}

Rolling rolling_of(const ContactProblem& problem) {
    return std::get<Rolling>(problem.motion);
}

std::string refused_field(const SessionSpec& opened, const json& input) {
    const auto status = wire::status_thrown_by([&] { stepped(opened, input); });
    REQUIRE(status);
    return status->violations.at(0).field;
}

}  // namespace

TEST_CASE("What a session is opened with arrives as it was sent") {
    const SessionSpec original = spec();
    const SessionSpec read = arrived(original);

    CHECK(read.setup.grid == original.setup.grid);
    CHECK(read.load.gap == original.load.gap);
    CHECK(read.load.approach == original.load.approach);
    CHECK(read.setup.friction == original.setup.friction);
    CHECK(read.load.previous == original.load.previous);
    CHECK(read.lease_seconds == 7.0);
    CHECK(read.accept_unconverged);
    CHECK(read.load.derivatives);
}

TEST_CASE("What a session leaves to its steps arrives as left out, and can be validated all the same") {
    SessionSpec original = spec();
    original.load.gap.reset();
    original.load.approach.reset();
    original.lease_seconds.reset();
    original.accept_unconverged = false;
    const SessionSpec read = arrived(original);

    CHECK_FALSE(read.load.gap);
    CHECK_FALSE(read.load.approach);
    CHECK_FALSE(read.load.Fn);
    CHECK_FALSE(read.lease_seconds);
    CHECK_FALSE(read.accept_unconverged);
    CHECK_NOTHROW(validate_opening({read.setup, read.load}));
    CHECK(refused_field(read, {{"gap", {{"paraboloid", {{"Rx", 1}}}}}}) == "approach");
    CHECK(refused_field(read, {{"Fn", 1}}) == "gap");
}

TEST_CASE("A step changes what it names and nothing else") {
    const ContactProblem problem =
        stepped(spec(), {{"Fn", 9}, {"friction", {{"rolling", {{"xi", -2e-3}, {"force", {nullptr, nullptr}}}}}}});

    CHECK(problem.Fn == 9.0);
    CHECK(problem.gap == spec().load.gap);
    CHECK(problem.friction->mu == spec().setup.friction->mu);
    Rolling expected = rolling_of({spec().setup, spec().load});
    expected.xi = -2e-3;
    expected.force.Fy.reset();
    CHECK(rolling_of(problem) == expected);
}

TEST_CASE("A step has derivatives as the session was opened, unless it says otherwise") {
    SessionSpec opened = spec();
    CHECK(stepped(opened, json::object()).derivatives);
    CHECK_FALSE(stepped(opened, {{"derivatives", false}}).derivatives);
    opened.load.derivatives = false;
    CHECK_FALSE(stepped(opened, json::object()).derivatives);
    CHECK(stepped(opened, {{"Fn", 1}, {"derivatives", true}}).derivatives);
}

TEST_CASE("An approach takes the place of the force that the session was opened with") {
    SessionSpec opened = spec();
    opened.load.approach.reset();
    opened.load.Fn = 5;
    const ContactProblem problem = stepped(opened, {{"approach", 0.01}});

    CHECK_FALSE(problem.Fn);
    CHECK(problem.approach == 0.01);
    CHECK(stepped(opened, json::object()).Fn == 5.0);
}

TEST_CASE("A step may shift where the session was opened to roll") {
    const ContactProblem problem = stepped(spec(), {{"friction", {{"rigid_shift", {1, 2}}}}});

    CHECK(std::get<Shift>(problem.motion).rigid_shift.y == 2);
}

TEST_CASE(
    "The creepage that the last step found for a force is the estimate, unless the step names one or prescribes none") {
    Rolling last;
    last.xi = 7;
    last.eta = 8;
    last.force.Fy = 1;

    CHECK(rolling_of(stepped(spec(), json::object(), last)).eta == 8);
    CHECK(rolling_of(stepped(spec(), json::object(), last)).xi == 1e-3);  // not found, but given
    CHECK(rolling_of(stepped(spec(), {{"friction", {{"rolling", {{"eta", 3}}}}}}, last)).eta == 3);
    CHECK(rolling_of(stepped(spec(), {{"friction", {{"rolling", {{"force", {1, nullptr}}}}}}}, last)).eta == 0);
    CHECK(rolling_of(stepped(spec(), json::object(), Shift{})).eta == 0);
}

TEST_CASE("Friction needs its coefficient from the session or the step") {
    SessionSpec opened = spec();
    opened.setup.friction.reset();

    CHECK(refused_field(opened, {{"friction", {{"rigid_shift", {0, 0}}}}}) == "friction.mu");
    CHECK(stepped(opened, {{"friction", {{"mu", 0.3}}}}).friction->mu_of(0) == 0.3);
}

TEST_CASE("A step of the client arrives whole: nothing that session.open said stays by accident") {
    StepInput input;
    input.approach = 0.5;
    input.gap = Paraboloid{2, 3};
    Rolling rolling;
    rolling.eta = 4;
    input.friction = FrictionLaw{{0.9}};
    input.motion = rolling;
    input.rigid_slip = {{1, 2, 3, 4, 5, 6}, {0, 0, 0, 0, 0, 7}};
    input.fields = {SolutionField::slip_x, SolutionField::pressure};
    input.derivatives = false;
    ArrayWriter arrays(ArrayEncoding::frame);
    const json params = encode_step("abc", 12, input, spec().setup.grid, arrays);
    REQUIRE(violations_of("session.step.params", params).empty());
    ContactProblem problem{spec().setup, spec().load};
    apply_step(params, arrays.take_frames(), {}, problem);

    CHECK(params["session"] == "abc");
    CHECK(params["step"] == 12);
    CHECK(problem.approach == 0.5);
    CHECK(problem.gap == Gap(Paraboloid{2, 3}));
    CHECK(problem.friction->mu == std::vector<double>{0.9});
    rolling.dq = 0.05;  // 0 selects the value of the session
    CHECK(rolling_of(problem) == rolling);
    CHECK(problem.rigid_slip == input.rigid_slip);
    CHECK(decode_fields(params, {}) == input.fields);
    CHECK_FALSE(problem.derivatives);
}

TEST_CASE("An answer holds the arrays that were asked for") {
    const Grid grid{2, 1, 1, 1, 0, 0};
    ContactSolution solution;
    solution.forces.Fn = 3;
    solution.pressure = {1, 2};
    solution.traction_x = {3, 4};
    solution.element_division = {ElementState::slip, ElementState::adhesion};
    solution.evidence.normal = {4, 1e-9, true, 0.1};
    ArrayWriter arrays(ArrayEncoding::list);
    using enum SolutionField;
    const json result = encode_step_reply(5, solution, grid, {pressure, element_division, pressure, slip_x}, arrays);
    CAPTURE(result.dump());
    REQUIRE(violations_of("session.step.result", result).empty());
    const StepReply reply = decode_step_reply(result, {}, grid);

    CHECK(reply.step == 5);
    CHECK(reply.solution.forces.Fn == 3);
    CHECK(reply.solution.pressure == solution.pressure);
    CHECK(reply.solution.element_division == solution.element_division);
    CHECK(reply.solution.traction_x.empty());
    CHECK(reply.solution.slip_x.empty());
    CHECK(reply.solution.evidence.normal.iterations == 4);
}

TEST_CASE("An opened session arrives as it was told") {
    SessionReply reported{"name", 60, 3, {}};
    reported.ics.upper = IcUse{"closed_form", std::string(64, 'a'), {}};
    const SessionReply read = decode_session_reply(encode_session_reply(reported));

    CHECK(read.session == "name");
    CHECK(read.lease_seconds == 60);
    CHECK(read.bytes == 3);
    REQUIRE(read.ics.upper);
    CHECK(read.ics.upper->origin == "closed_form");
}

TEST_CASE("Where a session is arrives as it was told") {
    SessionInfo reported;
    reported.step = 7;
    reported.lease_seconds = 60;
    reported.states = 2;
    reported.bytes = 3;
    reported.grid = Grid{2, 1, 0.5, 1, -1, 4};
    reported.ics.lower = IcUse{"memory", std::string(64, 'a'), {}};
    reported.ics.lower->evidence.source = "analytic";
    for (const auto& motion :
         {std::optional<MotionKind>(), std::optional(MotionKind::shift), std::optional(MotionKind::rolling)}) {
        reported.motion = motion;
        const json result = encode_session_info(reported);
        CAPTURE(result.dump());
        REQUIRE(violations_of("session.info.result", result).empty());
        const SessionInfo info = decode_session_info(result);

        CHECK(info.step == 7);
        CHECK(info.lease_seconds == 60);
        CHECK(info.states == 2);
        CHECK(info.bytes == 3);
        CHECK(info.grid == reported.grid);
        REQUIRE(info.ics.lower);
        CHECK(info.ics.lower->key == reported.ics.lower->key);
        CHECK_FALSE(info.ics.upper);
        CHECK(info.motion == motion);
    }
}

TEST_CASE("A step with a number that is not finite is refused by its field") {
    const auto refused = [](const auto& say) -> std::string {
        StepInput input;
        say(input);
        ArrayWriter arrays(ArrayEncoding::frame);
        try {
            encode_step("abc", 1, input, spec().setup.grid, arrays);
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return "";
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(refused([&](StepInput& input) { input.Fn = nan; }) == "Fn");
    CHECK(refused([&](StepInput& input) { input.gap = SemiAxes{1, nan}; }) == "gap.semi_axes.b");
    CHECK(refused([&](StepInput& input) { input.friction = FrictionLaw{{nan}, {}}; }) == "friction.mu");
    CHECK(refused([&](StepInput& input) { input.motion = Rolling{.xi = nan}; }) == "friction.rolling.xi");
}

TEST_CASE("A session of a wheel on its rail arrives as it was sent") {
    WheelRailSessionSpec sent;
    sent.setup.side = Side::left;
    sent.setup.wheel.shape = ProfilePoints{{{-20, 1}, {0, 0}, {20, -1}}};
    sent.lease_seconds = 7;
    sent.accept_unconverged = true;
    ArrayWriter arrays(ArrayEncoding::frame);
    const json params = json::parse(dump(encode_session_spec(sent, arrays)));
    CHECK(violations_of("session.open.params", params).empty());
    CHECK(is_of_wheel_rail(params));
    const WheelRailSessionSpec arrived = decode_wheel_rail_session_spec(params, arrays.take_frames());
    CHECK(arrived.setup == sent.setup);
    CHECK(arrived.lease_seconds == 7);
    CHECK(arrived.accept_unconverged);
}

TEST_CASE("A step of a wheel on its rail arrives as it was sent, and so does its answer") {
    WheelRailStepInput sent;
    sent.state.position.y = 3;
    sent.state.Fz = 5;
    sent.friction = WheelRailFriction{{{-1, 0.1}, {0, 0.3}}, true, {}};
    sent.again = sent.gap = true;
    sent.fields = {SolutionField::pressure};
    const json params = json::parse(dump(encode_step("s", 4, sent)));
    CHECK(violations_of("session.step.params", params).empty());
    const WheelRailStepInput arrived = decode_wheel_rail_step(params);
    CHECK(arrived.state == sent.state);
    CHECK(arrived.friction == sent.friction);
    CHECK(arrived.fields == sent.fields);
    CHECK((arrived.again && arrived.gap));

    WheelRailSolution solution;
    solution.z = 0.5;
    ArrayWriter arrays(ArrayEncoding::frame);
    const json result = json::parse(write_step_reply(4, solution, PatchFields{{}, false}, arrays));
    CHECK(violations_of("session.step.result", result).empty());
    const WheelRailStepReply reply = decode_wheel_rail_step_reply(result, {});
    CHECK(reply.step == 4);
    CHECK(reply.solution.z == 0.5);
}

TEST_CASE("An answer without patches tells how many there are, and what of them belongs to the whole") {
    WheelRailStepInput sent;
    sent.patches = false;
    CHECK_FALSE(decode_wheel_rail_step(json::parse(dump(encode_step("s", 4, sent)))).patches);
    CHECK(decode_wheel_rail_step(encode_step("s", 4, WheelRailStepInput{})).patches);
    sent.gap = true;
    CHECK_THROWS_AS(decode_wheel_rail_step(encode_step("s", 4, sent)), StatusError);

    WheelRailSolution solution;
    solution.patches.resize(2);
    solution.patches[0].solution.frictional_power = 3.0;
    solution.patches[1].solution.frictional_power = 4.0;
    solution.patches[1].solution.evidence.normal.converged = false;
    ArrayWriter arrays(ArrayEncoding::frame);
    const json result = json::parse(write_step_reply(4, solution, PatchFields{{}, false, false}, arrays));
    CHECK(violations_of("session.step.result", result).empty());
    CHECK_FALSE(result["wheelrail"].contains("patches"));
    const WheelRailSolution arrived = decode_wheel_rail_step_reply(result, {}).solution;
    CHECK(arrived.patches.empty());
    CHECK(arrived.in_contact());
    CHECK(arrived.contacts() == 2);
    CHECK(arrived.frictional_power() == 7.0);
    CHECK_FALSE(arrived.converged());

    json neither = result;
    neither["wheelrail"].erase("contacts");
    CHECK_THROWS_AS(decode_wheel_rail_step_reply(neither, {}), StatusError);
}

TEST_CASE("Openings and steps are of a contact or of a wheel on its rail, and not of both") {
    const json grid{{"nx", 1}, {"ny", 1}, {"dx", 1}, {"dy", 1}};
    CHECK_FALSE(violations_of("session.open.params", {{"wheelrail", json::object()}, {"grid", grid}}).empty());
    CHECK_FALSE(violations_of("session.open.params", json::object()).empty());
    const json wheel{{"state", json::object()}};
    CHECK(violations_of("session.step.params", {{"session", "s"}, {"step", 1}, {"wheelrail", wheel}}).empty());
    CHECK_FALSE(
        violations_of("session.step.params", {{"session", "s"}, {"step", 1}, {"wheelrail", wheel}, {"Fn", 1}}).empty());
    CHECK_FALSE(violations_of("session.step.result", {{"step", 1}}).empty());
    CHECK_FALSE(violations_of("session.info.result",
                              {{"step", 1}, {"lease_seconds", 1}, {"states", 0}, {"bytes", 0}, {"ics", json::object()}})
                    .empty());
}

TEST_CASE("What a wheel on its rail refuses is named below its member") {
    const Status status = below_wheel_rail(invalid_field("setup.dx", "is 0; it must be more").status());
    CHECK(status.message == "wheelrail.setup.dx is 0; it must be more");
    CHECK(status.violations.at(0).field == "wheelrail.setup.dx");
    CHECK(below_wheel_rail({StatusCode::aborted, "It failed.", "X", {}, 0}).message == "It failed.");
}

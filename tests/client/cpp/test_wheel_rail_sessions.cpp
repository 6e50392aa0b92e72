// Tests sessions of wheels on rails, with a real daemon.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "contactd/client/session.hpp"
#include "contactd/error.hpp"
#include "own_daemon.hpp"

using namespace contactd;
using namespace contactd::client;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;
using Catch::Matchers::WithinAbs;

namespace {

WheelRailSessionSpec coarse() {
    WheelRailSessionSpec spec;
    spec.setup.dx = spec.setup.dy = 1;
    return spec;
}

WheelRailStepInput rolling_at(double y) {
    WheelRailStepInput input;
    input.state.position.y = y;
    input.state.velocity.x = 2000;
    input.state.velocity.pitch = -2000 / 460.0;
    input.state.Fz = 1e4;
    return input;
}

SessionSpec ball_on_plate() {
    SessionSpec spec;
    spec.setup.grid = Grid::of_elements(10, 8, 0.5, 0.5);
    spec.setup.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    spec.load.gap = Paraboloid{400, 400};
    spec.load.Fn = 5000;
    return spec;
}

}  // namespace

TEST_CASE("A step of a wheel answers what the client does without a session, and goes back") {
    const Daemon daemon;
    Client client(daemon.endpoint());
    WheelRailSession wheel(client, coarse());
    WheelRailStepInput input = rolling_at(1);
    input.fields = {SolutionField::pressure};
    const WheelRailStepReply first = wheel.step(input);
    const WheelRailSolution alone = client.wheel_rail(coarse().setup, input.state);
    CHECK(first.step == 1);
    CHECK_THAT(first.solution.forces.track.Fy, WithinAbs(alone.forces.track.Fy, 0.05));
    CHECK(first.solution.patches.at(0).solution.pressure.size() == alone.patches.at(0).solution.pressure.size());
    CHECK(first.solution.patches.at(0).solution.traction_x.empty());

    const SavedState state = wheel.save();
    const Wrench second = wheel.step(rolling_at(1.2)).solution.forces.track;
    wheel.restore(state);
    CHECK(wheel.step(rolling_at(1.2)).solution.forces.track == second);
    WheelRailStepInput again = rolling_at(1.4);
    again.again = true;
    CHECK(wheel.step(again).step == 2);
    CHECK(wheel.step_number() == 2);
}

TEST_CASE("A step without patches tells all else") {
    const Daemon daemon;
    Client client(daemon.endpoint());
    WheelRailSession one(client, coarse()), other(client, coarse());
    for (const double y : {1.0, 6.8}) {
        const WheelRailSolution whole = one.step(rolling_at(y)).solution;
        WheelRailStepInput input = rolling_at(y);
        input.patches = false;
        const WheelRailSolution without = other.step(input).solution;
        CHECK(without.patches.empty());
        CHECK(without.in_contact());
        CHECK(without.contacts() == whole.contacts());
        CHECK(without.converged() == whole.converged());
        CHECK(without.forces.track == whole.forces.track);
        CHECK(without.frictional_power() == whole.frictional_power());
        input.gap = true;
        CHECK_THROWS_WITH(other.step(input), ContainsSubstring("wheelrail.patches excludes them"));
    }
}

TEST_CASE("A wheel's session is joined as what it is") {
    const Daemon daemon;
    Client client(daemon.endpoint());
    WheelRailSession wheel(client, coarse());
    wheel.step(rolling_at(0));
    WheelRailSession joined = WheelRailSession::join(client, wheel.name());
    CHECK(joined.step_number() == 1);
    CHECK(joined.step(rolling_at(1)).step == 2);
    CHECK_THROWS_WITH(Session::join(client, wheel.name()), StartsWith("name belongs to the session of a wheel"));
    Session contact(client, ball_on_plate());
    CHECK_THROWS_WITH(WheelRailSession::join(client, contact.name()),
                      StartsWith("name belongs to the session of a contact"));
    static_cast<void>(joined.release());
}

TEST_CASE("Wheels and contacts step in one message") {
    const Daemon daemon;
    Client client(daemon.endpoint());
    WheelRailSession one(client, coarse()), two(client, coarse()), alone(client, coarse());
    Session contact(client, ball_on_plate());
    WheelRailStepInput deep = rolling_at(0);
    deep.state.Fz.reset();
    deep.state.position.z = 30;
    const std::vector<AnySessionStep> steps{WheelRailSessionStep{one, rolling_at(1)}, SessionStep{contact, {}},
                                            WheelRailSessionStep{two, deep}};
    const auto replies = step_many(steps);
    REQUIRE(replies.size() == 3);
    CHECK(std::get<WheelRailStepReply>(replies[0]).solution.forces.track ==
          alone.step(rolling_at(1)).solution.forces.track);
    CHECK_THAT(std::get<StepReply>(replies[1]).solution.forces.Fn, WithinAbs(5000, 1));
    CHECK(std::get<Status>(replies[2]).violations.at(0).field == "wheelrail.state.position.z");
    CHECK(two.step_number() == 0);
}

TEST_CASE("What a wheel cannot use is named before anything is sent") {
    const Daemon daemon;
    Client client(daemon.endpoint());
    WheelRailSessionSpec spec = coarse();
    spec.setup.track.gauge = -1;
    CHECK_THROWS_WITH(WheelRailSession(client, spec), StartsWith("wheelrail.setup.track.gauge "));
    WheelRailSession wheel(client, coarse());
    WheelRailStepInput input = rolling_at(0);
    input.state.position.roll = 3;
    CHECK_THROWS_WITH(wheel.step(input), StartsWith("wheelrail.state.position.roll "));
    CHECK(wheel.step(rolling_at(0)).step == 1);
}

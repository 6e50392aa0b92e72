// Tests steps of several sessions in one message, with a real daemon.
#include <catch2/catch_test_macros.hpp>

#include "contactd/client/session.hpp"
#include "own_daemon.hpp"

using namespace contactd;
using namespace contactd::client;

namespace {

ContactProblem ball_on_plate() {
    ContactProblem problem;
    problem.grid = Grid::of_elements(10, 8, 0.5, 0.5);
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    problem.gap = Paraboloid{400, 400};
    problem.Fn = 5000;
    problem.friction = FrictionLaw{.mu = {0.3}};
    return problem;
}

StepInput shifted(double x, SolutionFields fields = {}) {
    StepInput input;
    input.motion = Shift{.rigid_shift = {x, 0}};
    input.fields = std::move(fields);
    return input;
}

double force_of(const StepOrStatus& reply) {
    return std::get<StepReply>(reply).solution.forces.Fx;
}

}  // namespace

TEST_CASE("Steps of many sessions are those of each alone, to the last bit") {
    const Daemon daemon;
    Client client(daemon.endpoint());
    Session one(client, ball_on_plate()), two(client, ball_on_plate()), alone(client, ball_on_plate());
    const SolutionFields wanted{SolutionField::traction_x, SolutionField::element_division};
    const std::vector<SessionStep> steps{{one, shifted(0.001, wanted)}, {two, shifted(0.002)}};
    const auto replies = step_many(steps);
    const StepReply expected = alone.step(shifted(0.001, wanted));
    const ContactSolution& first = std::get<StepReply>(replies.at(0)).solution;
    CHECK(first.traction_x == expected.solution.traction_x);
    CHECK(first.element_division == expected.solution.element_division);
    CHECK(first.pressure.empty());
    CHECK(std::get<StepReply>(replies.at(1)).solution.traction_x.empty());
    CHECK(one.step_number() == 1);
    CHECK(two.step_number() == 1);
}

TEST_CASE("Steps are tried again together, those that failed too") {
    const Daemon daemon;
    Client client(daemon.endpoint());
    Session one(client, ball_on_plate()), two(client, ball_on_plate()), alone(client, ball_on_plate());
    StepInput lost = shifted(0.001);
    lost.gap = std::vector<double>(80, 1e9);  // no contact can carry the force
    lost.friction = FrictionLaw{.mu = {0.3}, .kinetic = KineticFriction{.mu = 0.4, .slip_velocity = 1}};
    const auto tried = step_many(std::vector<SessionStep>{{one, shifted(0.001)}, {two, lost}});
    REQUIRE(std::holds_alternative<StepReply>(tried[0]));
    CHECK(std::get<Status>(tried[1]).violations.at(0).field == "friction.kinetic.mu");
    StepInput better = shifted(0.0005);
    better.again = true;
    const auto done = step_many(std::vector<SessionStep>{{one, better}, {two, better}});
    const double expected = alone.step(shifted(0.0005)).solution.forces.Fx;
    CHECK(force_of(done[0]) == expected);
    CHECK(force_of(done[1]) == expected);
    CHECK(one.step_number() == 1);
    CHECK(two.step_number() == 1);
}

TEST_CASE("A step of one session is tried until it pleases") {
    const Daemon daemon;
    Client client(daemon.endpoint());
    Session tried(client, ball_on_plate()), straight(client, ball_on_plate());
    tried.step(shifted(0.001));
    tried.step(shifted(-0.003));
    StepInput last = shifted(0.0004);
    last.again = true;
    const StepReply done = tried.step(last);
    straight.step(shifted(0.001));
    CHECK(done.solution.forces.Fx == straight.step(shifted(0.0004)).solution.forces.Fx);
    CHECK(done.step == 2);
}

TEST_CASE("Sessions of several clients of a daemon step together") {
    const Daemon daemon;
    Client client(daemon.endpoint()), other(daemon.endpoint());
    Session one(client, ball_on_plate()), two(other, ball_on_plate());
    const auto done = step_many(std::vector<SessionStep>{{one, shifted(0.001)}, {two, shifted(0.001)}});
    CHECK(force_of(done[0]) == force_of(done[1]));
    CHECK(two.step(shifted(0.001)).step == 2);
}

TEST_CASE("A session takes one step of a message, and all are of one daemon") {
    const Daemon daemon, another;
    Client client(daemon.endpoint()), other(another.endpoint());
    Session one(client, ball_on_plate()), two(other, ball_on_plate());
    CHECK_THROWS_AS(step_many(std::vector<SessionStep>{{one, {}}, {one, {}}}), InvalidArgument);
    CHECK_THROWS_AS(step_many(std::vector<SessionStep>{{one, {}}, {two, {}}}), InvalidArgument);
    Session same = Session::join(client, one.name());
    CHECK_THROWS_AS(step_many(std::vector<SessionStep>{{one, {}}, {same, {}}}), InvalidArgument);
    same.release();
    CHECK(step_many(std::vector<SessionStep>()).empty());
    CHECK(one.step({}).step == 1);
}

TEST_CASE("A solve brings the arrays that it is asked for") {
    const Daemon daemon;
    Client client(daemon.endpoint());
    const ContactProblem problem = ball_on_plate();
    const ContactSolution all = client.solve(problem).solution, none = client.solve(problem, {}, {}).solution,
                          one = client.solve(problem, {}, {SolutionField::pressure}).solution;
    CHECK(none.pressure.empty());
    CHECK(none.element_division.empty());
    CHECK(none.forces.Fn == all.forces.Fn);
    CHECK(one.pressure == all.pressure);
    CHECK(one.traction_x.empty());
    const auto many = client.solve_many(std::vector<ContactProblem>{problem, problem}, {}, {});
    CHECK(std::get<SolveReply>(many.at(1)).solution.pressure.empty());
}

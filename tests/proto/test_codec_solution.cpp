#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <limits>
#include <numbers>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/proto/session.hpp"
#include "solve_replies.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using nlohmann::json;
using wire::solve_reply;

namespace {

json sent(const json& message) {
    return json::parse(dump(message));
}

}  // namespace

TEST_CASE("A solution comes back exactly", "[codec]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    const bool friction = GENERATE(true, false);
    SolveReply reply = solve_reply();
    if (!friction) {
        reply.solution.evidence.tangential.reset();
        reply.solution.slip_x.clear();
        reply.solution.slip_y.clear();
        reply.solution.motion.reset();
        reply.solution.frictional_work.reset();
    }
    ArrayWriter arrays(encoding);
    const json result = encode_solve_reply(reply, Grid::of_elements(3, 2, 1, 1), arrays);

    CHECK(violations_of("contact.solve.result", result).empty());
    const SolveReply read = decode_solve_reply(sent(result), arrays.take_frames());

    CHECK(read.solution.approach == reply.solution.approach);
    CHECK(read.solution.forces.Fn == reply.solution.forces.Fn);
    CHECK(read.solution.forces.Fx == reply.solution.forces.Fx);
    CHECK(read.solution.forces.Fy == reply.solution.forces.Fy);
    CHECK(read.solution.forces.Mz == reply.solution.forces.Mz);
    CHECK(read.solution.pmax == reply.solution.pmax);
    CHECK(read.solution.area.contact == reply.solution.area.contact);
    CHECK(read.solution.area.adhesion == reply.solution.area.adhesion);
    CHECK(read.solution.area.slip == reply.solution.area.slip);
    CHECK(read.solution.elements.contact == 3);
    CHECK(read.solution.elements.adhesion == 1);
    CHECK(read.solution.elements.slip == 2);
    CHECK(read.solution.elements.border == 1);
    CHECK(read.solution.element_division == reply.solution.element_division);
    CHECK(read.solution.pressure == reply.solution.pressure);
    CHECK(read.solution.traction_x == reply.solution.traction_x);
    CHECK(read.solution.traction_y == reply.solution.traction_y);
    CHECK(read.solution.slip_x == reply.solution.slip_x);
    CHECK(read.solution.slip_y == reply.solution.slip_y);
    CHECK(read.solution.frictional_work == reply.solution.frictional_work);
    CHECK_FALSE(read.solution.frictional_power);
    CHECK(read.solution.motion == reply.solution.motion);
    CHECK(read.solution.warnings == reply.solution.warnings);
    CHECK(read.solution.evidence.normal.iterations == 12);
    CHECK(read.solution.evidence.tangential.has_value() == friction);
    CHECK(read.solution.converged() == !friction);
    CHECK(result["converged"] == !friction);
    CHECK(read.ics.upper->origin == "closed_form");
    CHECK(read.ics.lower->key == "def");
    CHECK_FALSE(read.ics.pair);
}

TEST_CASE("A solution whose arrays disagree is refused", "[codec]") {
    ArrayWriter arrays(ArrayEncoding::list);
    json result = encode_solve_reply(solve_reply(), Grid::of_elements(3, 2, 1, 1), arrays);
    SECTION("shape") {
        result["traction_x"].erase(0);
    }
    SECTION("shape of the slip") {
        result["slip_y"].erase(0);
    }
    SECTION("element state") {
        result["element_division"][0][0] = 4;
    }
    SECTION("no rows") {
        result["pressure"] = json::array();
    }
    SECTION("dimensions") {
        result["pressure"] = json::parse(R"({"$array": {"frame": 1, "dtype": "<f8", "shape": [6]}})");
    }
    SECTION("huge shape") {
        result["pressure"] = json::parse(R"({"$array": {"frame": 1, "dtype": "<f8", "shape": [4000000, 4000000]}})");
    }
    CHECK(wire::status_thrown_by([&] { decode_solve_reply(result, {""}); }));
}

TEST_CASE("The resultant on curved columns comes back", "[codec]") {
    SolveReply reply = solve_reply();
    reply.solution.resultant = Resultant{1, -2, 1.0 / 3, 4, 5e-9, -6};
    ArrayWriter arrays(ArrayEncoding::list);
    const json result = encode_solve_reply(reply, Grid::of_elements(3, 2, 1, 1), arrays);
    CHECK(violations_of("contact.solve.result", result).empty());
    CHECK(decode_solve_reply(sent(result), {}).solution.resultant == reply.solution.resultant);
    reply.solution.resultant->My = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(encode_solve_reply(reply, Grid::of_elements(3, 2, 1, 1), arrays), Error);
}

TEST_CASE("Every motion comes back", "[codec]") {
    SolveReply reply = solve_reply();
    SECTION("shift with a force") {
        reply.solution.motion = Shift{{1e-3, 0.1 + 0.2}, 1e-5, {{}, -3.5}, 0.25};
    }
    SECTION("rolling") {
        reply.solution.motion = Rolling{1e-3, 2e-3, 1e-4, 0.5, 0.1, 0.25, RollingKind::transient, 7, 3e4, {{}, 0.5}};
        reply.solution.frictional_work.reset();
        reply.solution.frictional_power = 1.0 / 3;
    }
    ArrayWriter arrays(ArrayEncoding::list);
    const json result = sent(encode_solve_reply(reply, Grid::of_elements(3, 2, 1, 1), arrays));
    CHECK(violations_of("contact.solve.result", result).empty());
    const ContactSolution read = decode_solve_reply(result, {}).solution;
    CHECK(read.motion == reply.solution.motion);
    CHECK(read.frictional_power == reply.solution.frictional_power);
}

TEST_CASE("A step that the request left out is told", "[codec]") {
    SolveReply reply = solve_reply();
    reply.solution.motion = Rolling{};
    ArrayWriter arrays(ArrayEncoding::list);
    const json along_x = encode_solve_reply(reply, Grid::of_elements(3, 2, 0.25, 1), arrays)["motion"];
    CHECK(along_x["dq"] == 0.25);
    CHECK(along_x["spin_offset"] == 0);
    reply.solution.motion = Rolling{.chi = std::numbers::pi / 2};
    CHECK(encode_solve_reply(reply, Grid::of_elements(3, 2, 0.25, 1), arrays)["motion"]["dq"] == 1);
}

TEST_CASE("Operators beyond the budget come back", "[codec]") {
    SolveReply reply = solve_reply();
    reply.operators = OperatorUse{true, 400'000'000, 268'435'456};
    ArrayWriter arrays(ArrayEncoding::list);
    const json result = encode_solve_reply(reply, Grid::of_elements(3, 2, 1, 1), arrays);
    CHECK(violations_of("contact.solve.result", result).empty());
    CHECK(decode_solve_reply(result, {}).operators == reply.operators);
}

TEST_CASE("Errors of the discretisation come back", "[codec]") {
    SolveReply reply = solve_reply();
    SECTION("known") {
        reply.solution.evidence.discretisation = Discretisation{8, 0.1 + 0.2, 1.0 / 7, ErrorSource::hertz};
    }
    SECTION("estimated, of rolling") {
        reply.solution.evidence.discretisation = Discretisation{1, 1, 1, ErrorSource::estimate, 0.3, 1.1};
    }
    SECTION("none") {}
    ArrayWriter arrays(ArrayEncoding::list);
    const json result = sent(encode_solve_reply(reply, Grid::of_elements(3, 2, 1, 1), arrays));
    CHECK(violations_of("contact.solve.result", result).empty());
    CHECK(decode_solve_reply(result, {}).solution.evidence.discretisation == reply.solution.evidence.discretisation);
    const json step = sent(encode_step_reply(1, reply.solution, Grid::of_elements(3, 2, 1, 1), {}, arrays));
    CHECK(violations_of("session.step.result", step).empty());
    CHECK(decode_step_reply(step, {}, Grid::of_elements(3, 2, 1, 1)).solution.evidence.discretisation ==
          reply.solution.evidence.discretisation);
}

TEST_CASE("Derivatives come back exactly", "[codec]") {
    SolveReply reply = solve_reply();
    Derivatives derivatives;
    SECTION("of rolling under a normal force") {
        const DerivativesOfAnswer row{.xi = 1, .eta = 0.1 + 0.2, .phi = -1e-300, .Fn = 1.0 / 7, .mu = 3};
        derivatives = {.Fx = row, .Fy = row, .Mz = row, .approach = row};
        derivatives.Fy->eta = 8;
    }
    SECTION("of a shift at an approach") {
        const DerivativesOfAnswer row{.rigid_shift = DerivativesByShift{1, 2}, .rotation = 3, .approach = 4, .mu = 0};
        derivatives = {.Fx = row, .Fy = row, .Mz = row, .Fn = row};
    }
    SECTION("without friction") {
        derivatives.Fn = DerivativesOfAnswer{.approach = 5};
    }
    reply.solution.derivatives = derivatives;
    reply.solution.evidence.derivatives = SolverEvidence{20, 1e-6, true, 0.01};
    const Grid grid = Grid::of_elements(3, 2, 1, 1);
    ArrayWriter arrays(ArrayEncoding::list);
    const json result = sent(encode_solve_reply(reply, grid, arrays));
    CHECK(violations_of("contact.solve.result", result).empty());
    const ContactSolution read = decode_solve_reply(result, {}).solution;
    CHECK(read.derivatives == derivatives);
    CHECK(read.evidence.derivatives->iterations == 20);
    const json step = sent(encode_step_reply(1, reply.solution, grid, {}, arrays));
    CHECK(violations_of("session.step.result", step).empty());
    CHECK(decode_step_reply(step, {}, grid).solution.derivatives == derivatives);

    reply.solution.derivatives.reset();
    const json none = sent(encode_solve_reply(reply, grid, arrays));
    CHECK_FALSE(none.contains("derivatives"));
    CHECK_FALSE(decode_solve_reply(none, {}).solution.derivatives);
}

TEST_CASE("Derivatives that are not finite are not sent", "[codec]") {
    SolveReply reply = solve_reply();
    reply.solution.derivatives = Derivatives{};
    reply.solution.derivatives->Fn = DerivativesOfAnswer{.mu = std::numeric_limits<double>::infinity()};
    ArrayWriter arrays(ArrayEncoding::list);
    CHECK_THROWS_AS(encode_solve_reply(reply, Grid::of_elements(3, 2, 1, 1), arrays), Error);
}

TEST_CASE("Evidence tells of the solvers that ran and of the coefficients that were used", "[codec]") {
    SolveReply reply = solve_reply();
    SECTION("all solvers") {
        reply.solution.evidence.outer = SolverEvidence{5, 1e-7, true, 0.5};
        reply.solution.evidence.force = SolverEvidence{6, 1e-8, true, 0.5};
    }
    SECTION("a rigid body has no coefficients") {
        reply.ics.upper.reset();
    }
    SECTION("a simplified model uses none") {
        reply.ics.upper.reset();
        reply.ics.lower.reset();
    }
    SECTION("of a pair") {
        reply.ics.pair = reply.ics.upper;
        reply.ics.upper.reset();
        reply.ics.lower.reset();
    }
    ArrayWriter arrays(ArrayEncoding::list);
    const json result = sent(encode_solve_reply(reply, Grid::of_elements(3, 2, 1, 1), arrays));
    CAPTURE(result["evidence"].dump());
    CHECK(violations_of("contact.solve.result", result).empty());
    const SolveReply read = decode_solve_reply(result, {});
    CHECK(read.solution.evidence.outer.has_value() == reply.solution.evidence.outer.has_value());
    CHECK(read.solution.evidence.force.has_value() == reply.solution.evidence.force.has_value());
    CHECK(read.ics.upper.has_value() == reply.ics.upper.has_value());
    CHECK(read.ics.lower.has_value() == reply.ics.lower.has_value());
    CHECK(read.ics.pair.has_value() == reply.ics.pair.has_value());
}

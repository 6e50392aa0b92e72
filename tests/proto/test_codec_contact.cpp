#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;

namespace {

ContactProblem problem() {
    ContactProblem problem;
    problem.grid = Grid{3, 2, 0.1, 1.0 / 3, -7, 0.3};
    problem.bodies = {{200, 0.42}, {100.1, 0.3}};
    problem.undeformed_distance = {0.1, 0.2, 0.3, -0.4, 1.0 / 7, 6e-5};
    problem.approach = 0.02;
    problem.friction = Friction{0.4, 0.00817, -1e-9};
    problem.normal_settings = {1e-9, 50};
    problem.tangential_settings = {1e-5, 70};
    problem.initial_traction_y = {1, 2, 3, 4, 5, 6};
    return problem;
}

SolveReply solve_reply() {
    SolveReply reply;
    ContactSolution& solution = reply.solution;
    solution.Fn = 9.195402;
    solution.Fx = -3.2216;
    solution.Fy = 1e-17;
    solution.pmax = 4.39;
    solution.contact_area = 3.1;
    solution.adhesion_area = 1.1;
    solution.slip_area = 2.0;
    solution.contact_elements = 3;
    solution.adhesion_elements = 1;
    solution.slip_elements = 2;
    solution.element_division = {ElementState::exterior, ElementState::adhesion, ElementState::slip,
                                 ElementState::exterior, ElementState::slip,     ElementState::exterior};
    solution.pressure = {0, 1, 2, 0, 3, 0};
    solution.traction_x = {0, -0.1, -0.2, 0, -0.3, 0};
    solution.traction_y = {0, 0.1 + 0.2, 0, 0, 1e-300, 0};
    solution.normal = {12, 3e-7, true, 0.01};
    solution.tangential = SolverEvidence{40, 2e-3, false, 0.02};
    reply.upper = {"closed_form", "abc", {}};
    reply.upper.evidence.source = "analytic";
    reply.lower = reply.upper;
    reply.lower.key = "def";
    return reply;
}

json sent(const json& message) {
    return json::parse(dump(message));
}

std::string refused_field(const json& params, const std::vector<std::string>& frames = {}) {
    REQUIRE(violations_of("contact.solve.params", params).empty());
    const auto status = wire::status_thrown_by([&] { decode_problem(params, frames); });
    REQUIRE(status);
    REQUIRE(status->violations.size() == 1);
    return status->violations[0].field;
}

}  // namespace

TEST_CASE("A problem comes back exactly", "[codec]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    const ContactProblem original = problem();
    ArrayWriter arrays(encoding);
    const json params = encode_problem(original, arrays);

    CHECK(violations_of("contact.solve.params", params).empty());
    const auto frames = arrays.take_frames();
    CHECK_NOTHROW(check_frames_used(params, frames));
    const ContactProblem read = decode_problem(sent(params), frames);

    CHECK(read.grid == original.grid);
    CHECK(read.bodies == original.bodies);
    CHECK(read.ics.source == IcSource::analytic);
    CHECK(read.undeformed_distance == original.undeformed_distance);
    CHECK(read.approach == original.approach);
    CHECK(read.friction == original.friction);
    CHECK(read.normal_settings == original.normal_settings);
    CHECK(read.tangential_settings == original.tangential_settings);
    CHECK(read.initial_pressure.empty());
    CHECK(read.initial_traction_x.empty());
    CHECK(read.initial_traction_y == original.initial_traction_y);
}

TEST_CASE("A problem with finite-element coefficients keeps their spec", "[codec]") {
    ContactProblem original = problem();
    original.ics.source = IcSource::fem;
    original.ics.body = BodyShape::block;
    original.ics.load_shape = LoadShape::bilinear;
    original.ics.any_nu = true;
    original.ics.fem = *fem_preset("paper-mesh2-test1");
    original.friction.reset();
    ArrayWriter arrays(ArrayEncoding::list);

    const ContactProblem read = decode_problem(sent(encode_problem(original, arrays)), {});

    CHECK(read.ics.source == IcSource::fem);
    CHECK(read.ics.body == BodyShape::block);
    CHECK(read.ics.load_shape == LoadShape::bilinear);
    CHECK(read.ics.any_nu);
    CHECK(read.ics.accuracy == 0);
    CHECK(read.ics.fem == original.ics.fem);
    CHECK_FALSE(read.friction);
}

TEST_CASE("A problem may ask for an accuracy", "[codec]") {
    json params = wire::solve_params();
    params["ics"] = {{"source", "fem"}, {"body", "block"}, {"L_over_h", 20}, {"accuracy", 1e-2}};
    REQUIRE(violations_of("contact.solve.params", params).empty());

    const ContactProblem read = decode_problem(params, {});
    ArrayWriter arrays(ArrayEncoding::list);
    const ContactProblem again = decode_problem(sent(encode_problem(read, arrays)), {});

    for (const ContactProblem& problem : {read, again}) {
        CHECK(problem.ics.accuracy == 1e-2);
        CHECK(problem.ics.body == BodyShape::block);
        CHECK(problem.ics.fem.L_over_h == 20);
        CHECK_FALSE(problem.ics.any_nu);
    }
}

TEST_CASE("What a request leaves out has its default", "[codec]") {
    const ContactProblem read = decode_problem(wire::solve_params(), {});

    CHECK(read.grid == Grid::centred(3, 2, 0.06, 0.06));
    CHECK(read.bodies.lower == read.bodies.upper);
    CHECK(read.normal_settings == SolverSettings{});
    CHECK(read.undeformed_distance == paraboloid(read.grid, 50, 50));
}

TEST_CASE("A radius left out is a flat direction, one corner may be given", "[codec]") {
    json params = wire::solve_params();
    params["gap"] = {{"paraboloid", {{"Ry", -10}}}};
    params["grid"]["x0"] = 100;

    const ContactProblem read = decode_problem(params, {});

    CHECK(read.grid.x0 == 100);
    CHECK(read.grid.y0 == Grid::centred(3, 2, 0.06, 0.06).y0);
    CHECK(read.undeformed_distance[0] == 0.03 * 0.03 / (2 * -10.0));
    CHECK(read.undeformed_distance[2] == read.undeformed_distance[0]);
}

TEST_CASE("A grid that is too large is refused before it is allocated", "[codec]") {
    json params = wire::solve_params();
    params["grid"]["nx"] = params["grid"]["ny"] = 1'000'000;
    CHECK(refused_field(params) == "grid.nx");
}

TEST_CASE("Arrays of a problem that do not fit are named", "[codec]") {
    json params = wire::solve_params();
    params["gap"] = {{"array", {{1, 2, 3}}}};
    CHECK(refused_field(params) == "gap.array");

    params = wire::solve_params();
    params["initial"]["traction_x"] = json::parse(R"({"$array": {"frame": 2, "dtype": "<f8", "shape": [2, 3]}})");
    CHECK(refused_field(params, {"short"}) == "initial.traction_x");
    CHECK(refused_field(params, {"", "short"}) == "initial.traction_x");
}

TEST_CASE("A solution comes back exactly", "[codec]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    const bool friction = GENERATE(true, false);
    SolveReply reply = solve_reply();
    if (!friction) reply.solution.tangential.reset();
    ArrayWriter arrays(encoding);
    const json result = encode_solve_reply(reply, Grid::centred(3, 2, 1, 1), arrays);

    CHECK(violations_of("contact.solve.result", result).empty());
    const SolveReply read = decode_solve_reply(sent(result), arrays.take_frames());

    CHECK(read.solution.Fn == reply.solution.Fn);
    CHECK(read.solution.Fx == reply.solution.Fx);
    CHECK(read.solution.Fy == reply.solution.Fy);
    CHECK(read.solution.pmax == reply.solution.pmax);
    CHECK(read.solution.contact_area == reply.solution.contact_area);
    CHECK(read.solution.adhesion_area == reply.solution.adhesion_area);
    CHECK(read.solution.slip_area == reply.solution.slip_area);
    CHECK(read.solution.contact_elements == 3);
    CHECK(read.solution.adhesion_elements == 1);
    CHECK(read.solution.slip_elements == 2);
    CHECK(read.solution.element_division == reply.solution.element_division);
    CHECK(read.solution.pressure == reply.solution.pressure);
    CHECK(read.solution.traction_x == reply.solution.traction_x);
    CHECK(read.solution.traction_y == reply.solution.traction_y);
    CHECK(read.solution.normal.iterations == 12);
    CHECK(read.solution.tangential.has_value() == friction);
    CHECK(read.solution.converged() == !friction);
    CHECK(result["converged"] == !friction);
    CHECK(read.upper.origin == "closed_form");
    CHECK(read.lower.key == "def");
}

TEST_CASE("A solution whose arrays disagree is refused", "[codec]") {
    ArrayWriter arrays(ArrayEncoding::list);
    json result = encode_solve_reply(solve_reply(), Grid::centred(3, 2, 1, 1), arrays);
    SECTION("shape") {
        result["traction_x"].erase(0);
    }
    SECTION("element state") {
        result["element_division"][0][0] = 3;
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

#include <catch2/catch_test_macros.hpp>

#include <string>

#include "contactd/proto/status.hpp"
#include "methods/costs/request_limits.hpp"

using namespace contactd;
using namespace contactd::server;
using nlohmann::json;

namespace {

json grid(int nx, int ny) {
    return {{"grid", {{"nx", nx}, {"ny", ny}}}};
}

template <class Check>
std::string refusal_of(const Check& check) {
    try {
        check();
    } catch (const proto::StatusError& error) {
        return error.status().reason + " " + error.status().violations.at(0).field;
    }
    return "taken";
}

}  // namespace

TEST_CASE("A grid has no more elements than are allowed") {
    CHECK(refusal_of([] { check_grid_limit(grid(10, 10), 100); }) == "taken");
    CHECK(refusal_of([] { check_grid_limit(grid(10, 11), 100); }) == "LIMIT_EXCEEDED grid.nx");
    CHECK(refusal_of([] { check_grid_limit(grid(1, 101), 100); }) == "LIMIT_EXCEEDED grid.ny");
}

TEST_CASE("Grids of many problems count together") {
    const json problems{grid(10, 5), grid(5, 10)};
    CHECK(refusal_of([&] { check_grid_limits(problems, 100); }) == "taken");
    CHECK(refusal_of([&] { check_grid_limits(problems, 99); }) == "LIMIT_EXCEEDED problems");
    CHECK(refusal_of([&] { check_grid_limits({grid(1, 1), grid(100, 1)}, 99); }) ==
          "LIMIT_EXCEEDED problems[1].grid.nx");
}

TEST_CASE("Solutions that could not be sent as frames are refused before they are solved") {
    const json problem = grid(10, 10), sliding = {{"grid", problem["grid"]}, {"friction", json::object()}};
    MessageLimits limits;
    limits.max_frame_bytes = 800;
    limits.max_message_bytes = 2500;
    const auto refusal = [&](const std::vector<const json*>& problems, proto::ArrayEncoding arrays) {
        std::vector<ArrayAnswer> answers;
        for (const json* each : problems) answers.push_back(array_answer(*each));
        return refusal_of([&] { check_answer_fits(answers, arrays, limits); });
    };
    using enum proto::ArrayEncoding;
    CHECK(refusal({&problem}, frame) == "taken");
    CHECK(refusal({&problem, &problem}, frame) == "ANSWER_TOO_LARGE grid.nx");
    CHECK(refusal({&sliding}, frame) == "ANSWER_TOO_LARGE grid.nx");
    CHECK(refusal({&problem, &problem}, list) == "taken");
    limits.max_frame_bytes = 799;
    CHECK(refusal({&problem}, frame) == "ANSWER_TOO_LARGE grid.nx");
    json forces = problem, division = problem;
    forces["fields"] = json::array();
    division["fields"] = {"element_division"};
    CHECK(refusal({&forces, &division}, frame) == "taken");
}

TEST_CASE("An answer has the arrays that the fields of its request allow") {
    json params = grid(1, 1);
    const auto arrays = [&] { return array_answer(params).fields.size(); };
    CHECK(arrays() == 4);
    params["friction"]["layer"] = json::object();
    CHECK(arrays() == 9);
    params["friction"]["kinetic"] = json::object();
    CHECK(arrays() == 10);
    params["displacements"] = false;
    CHECK(arrays() == 10);
    params["displacements"] = true;
    CHECK(arrays() == 13);
    params["temperature"] = json::object();
    CHECK(arrays() == 15);
    params["derivatives"] = true;
    CHECK(arrays() == 16);
}

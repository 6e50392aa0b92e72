// contact.solve_many.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "solve_replies.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;

namespace {

const std::vector<double> gap{0, 1, 2, 3, 4, 5};

ContactProblem problem(double approach) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(3, 2, 0.1, 0.1);
    problem.bodies = {{200, 0.42}, {200, 0.42}};
    problem.gap = gap;
    problem.approach = approach;
    return problem;
}

json reference(std::size_t frame, const json& shape) {
    return {{"$array", {{"frame", frame}, {"dtype", "<f8"}, {"shape", shape}}}};
}

}  // namespace

TEST_CASE("Problems come back in their order", "[codec]") {
    const std::vector<ContactProblem> originals{problem(0.1), problem(0.3), problem(0.2)};
    ArrayWriter arrays(ArrayEncoding::frame);
    const json params = json::parse(dump(encode_problems(originals, arrays)));
    CHECK_NOTHROW(check_params("contact.solve_many", params));

    const auto frames = arrays.take_frames();

    REQUIRE(params["problems"].size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        const ContactProblem read = decode_problem(params["problems"][i], frames);
        CHECK(read.approach == originals[i].approach);
        CHECK(read.gap == Gap{gap});
    }
}

TEST_CASE("Equal arrays travel once where that is asked for", "[codec]") {
    std::vector<ContactProblem> originals{problem(0.1), problem(0.2), problem(0.3)};
    originals[2].gap = std::vector<double>{0, 1, 2, 3, 4, 6};
    ArrayWriter arrays(ArrayEncoding::frame, EqualArrays::shared);

    const json params = encode_problems(originals, arrays);
    const auto frames = arrays.take_frames();

    CHECK(frames.size() == 2);
    CHECK_NOTHROW(check_frames_used(params, frames));
    for (std::size_t i = 0; i < 3; ++i) CHECK(decode_problem(params["problems"][i], frames).gap == originals[i].gap);
}

TEST_CASE("Arrays of a problem that do not fit are named as those of contact.solve", "[codec]") {
    for (const json& gap : {json{{"array", {{1, 2, 3}}}}, json{{"array", reference(7, {2, 3})}}}) {
        json params{{"problems", json::array({wire::solve_params()})}};
        params["problems"][0]["gap"] = gap;
        REQUIRE_NOTHROW(check_params("contact.solve_many", params));

        const auto status = wire::status_thrown_by([&] { decode_problem(params["problems"][0], {}); });

        REQUIRE(status);
        CHECK(status->reason == "ARRAY_INVALID");
        CHECK(status->violations[0].field == "gap.array");
    }
}

TEST_CASE("A list conforms when its shape and each of its members do", "[schema]") {
    json params{{"problems", json::array({wire::solve_params(), wire::solve_params()})}};
    params["problems"][1]["bodies"]["upper"]["nu"] = 0.6;
    const ListCheck check("contact.solve_many", params);
    REQUIRE(check.conforms());
    REQUIRE(check.size() == 2);
    CHECK(check.member_conforms(0));
    CHECK_FALSE(check.member_conforms(1));

    json too_many = params;
    too_many["problems"] = json(1001, wire::solve_params());
    json more = params;
    more["solver"] = "mine";
    for (const json& bad : {json::object(), json{{"problems", 1}}, json{{"problems", json::array()}}, too_many, more}) {
        const ListCheck refused("contact.solve_many", bad);
        CHECK_FALSE(refused.conforms());
        CHECK(refused.size() == 0);
        CHECK_THROWS_AS(check_params("contact.solve_many", bad), StatusError);
    }
    CHECK_THROWS_AS(ListCheck("contact.solve", params), std::out_of_range);
}

TEST_CASE("A problem that breaks its schema fails the request, named by its place", "[codec]") {
    json params{{"problems", json::array({wire::solve_params(), wire::solve_params()})}};
    params["problems"][1]["bodies"]["upper"]["nu"] = 0.6;
    const auto status = wire::status_thrown_by([&] { check_params("contact.solve_many", params); });
    REQUIRE(status);
    REQUIRE(status->violations.size() == 1);
    CHECK(status->violations[0].field == "problems[1].bodies.upper.nu");
    CHECK(status->violations[0].description == "is 0.6; it must lie in [0, 0.5]");
}

TEST_CASE("One frame cannot stand for more than memory holds", "[codec]") {
    json one = wire::solve_params();
    one["gap"] = {{"array", reference(1, {2, 3})}};
    const json params{{"problems", json(10, one)}};
    CHECK_NOTHROW(check_referred_elements(params["problems"], {.max_array_elements = 60}));

    const auto status =
        wire::status_thrown_by([&] { check_referred_elements(params["problems"], {.max_array_elements = 59}); });

    REQUIRE(status);
    CHECK(status->reason == "LIMIT_EXCEEDED");
    CHECK(status->violations[0].field == "problems");
    CHECK_THAT(status->message, ContainsSubstring("60 elements") && ContainsSubstring("59"));
}

TEST_CASE("Huge claims of many arrays do not overflow their sum", "[codec]") {
    json one = wire::solve_params();
    one["gap"] = {{"array", reference(1, {4'000'000, 4'000'000, 4'000'000, 4'000'000})}};
    const json params{{"problems", json(1000, one)}};
    const auto status = wire::status_thrown_by([&] { check_referred_elements(params["problems"]); });
    REQUIRE(status);
    CHECK(status->reason == "LIMIT_EXCEEDED");
}

TEST_CASE("Solutions and failures come back in their order", "[codec]") {
    Status status{StatusCode::invalid_argument, "grid.nx is bad.", "FIELD_INVALID", {{"grid.nx", "is bad"}}, 0};
    SolveReply second = wire::solve_reply();
    second.solution.forces.Fn = 1.0 / 3;
    const Grid grid = Grid::of_elements(3, 2, 1, 1);
    std::vector<ResultOrStatus> results{encode_outcome(wire::solve_reply(), grid, ArrayEncoding::frame), status,
                                        encode_outcome(second, grid, ArrayEncoding::frame)};
    Frames frames;

    const json result = json::parse(encode_results("solutions", std::move(results), frames));

    CHECK(violations_of("contact.solve_many.result", result).empty());
    const auto read = decode_solve_replies(result, frames);
    REQUIRE(read.size() == 3);
    CHECK(std::get<SolveReply>(read[0]).solution.forces.Fn == 9.195402);
    CHECK(std::get<Status>(read[1]).code == StatusCode::invalid_argument);
    CHECK(std::get<Status>(read[1]).violations[0].field == "grid.nx");
    CHECK(std::get<SolveReply>(read[2]).solution.forces.Fn == 1.0 / 3);
    CHECK(std::get<SolveReply>(read[2]).solution.pressure == second.solution.pressure);
}

TEST_CASE("A reply that is not finite fails alone and leaves no frames behind", "[codec]") {
    SolveReply bad = wire::solve_reply();
    bad.solution.traction_y[3] = std::numeric_limits<double>::quiet_NaN();
    const Grid grid = Grid::of_elements(3, 2, 1, 1);
    Frames frames;

    const json result = json::parse(encode_results("solutions",
                                                   {encode_outcome(bad, grid, ArrayEncoding::frame),
                                                    encode_outcome(wire::solve_reply(), grid, ArrayEncoding::frame)},
                                                   frames));

    CHECK_NOTHROW(check_frames_used(result, frames));
    const auto read = decode_solve_replies(result, frames);
    CHECK(std::get<Status>(read[0]).code == StatusCode::internal);
    CHECK(std::get<SolveReply>(read[1]).solution.traction_y == wire::solve_reply().solution.traction_y);
}

TEST_CASE("A solution without a result, or with one beside a failure, is no answer", "[codec]") {
    const json ok{{"code", 0}, {"name", "OK"}, {"message", ""}};
    const json failure{{"code", 13}, {"name", "INTERNAL"}, {"message", "No."}};
    const auto conforms = [](const json& solution) {
        return violations_of("contact.solve_many.result", {{"solutions", {solution}}}).empty();
    };
    CHECK(conforms({{"status", failure}}));
    CHECK_FALSE(conforms({{"status", ok}}));
    CHECK_FALSE(conforms({{"status", failure}, {"result", json::object()}}));
}

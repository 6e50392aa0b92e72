// Tests answers of a wheel on its rail that violate the protocol: the client names the invalid field.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <functional>

#include "contactd/client/client.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "fake_solver.hpp"

using namespace contactd;
using namespace contactd::client;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using fake::Frames, fake::message_of;
using nlohmann::json;

namespace {

/// The result of one patch with its pressures.
json good_result(proto::ArrayWriter& arrays) {
    WheelRailSolution solution;
    solution.z = 0.25;
    WheelRailPatch& patch = solution.patches.emplace_back();
    patch.place.grid = Grid::of_elements(2, 1, 0.2, 0.2);
    patch.solution.pressure = {3, 4};
    return proto::encode_wheel_rail_solution(solution, {{SolutionField::pressure}, false}, arrays);
}

/// Checks that the client refuses the text of an answer with these words.
void check_refused(const std::function<std::string(const json& request, const json& result)>& text_of,
                   const std::string& says) {
    CAPTURE(says);
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> {
        proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
        const json result = good_result(arrays);
        Frames message{text_of(request, result)};
        for (proto::Frame& frame : arrays.take_frames()) message.push_back(std::move(frame));
        return {message};
    });
    Client client(daemon.endpoint());
    CHECK_THROWS_MATCHES(client.wheel_rail({}, {}, {}, {SolutionField::pressure}), ProtocolError,
                         MessageMatches(ContainsSubstring(says)));
}

/// Checks that the client refuses a damaged result with these words.
void check_refused(const std::function<void(json& result)>& damage, const std::string& says) {
    check_refused(
        [&](const json& request, json result) {
            damage(result);
            return fake::reply(request, result);
        },
        says);
}

/// Returns the text of an answer, with the first `from` replaced by `to`.
auto replaced(const std::string& from, const std::string& to) {
    return [=](const json& request, const json& result) {
        std::string text = fake::reply(request, result);
        const auto at = text.find(from);
        REQUIRE(at != std::string::npos);
        return text.replace(at, from.size(), to);
    };
}

}  // namespace

TEST_CASE("A damaged answer is refused, and the field is named that is wrong", "[client]") {
    check_refused([](json& result) { result.erase("z"); }, "wheelrail.solve.result: z is missing");
    check_refused([](json& result) { result["z"] = "high"; }, "z is \"high\"; it must be a number");
    check_refused([](json& result) { result["z"] = nullptr; }, "z is null; it must be a number");
    check_refused([](json& result) { result["forces"]["track"].erase("Fz"); }, "forces.track.Fz is missing");
    check_refused([](json& result) { result["patches"][0]["place"]["grid"]["nx"] = 2.5; },
                  "patches[0].place.grid.nx is 2.5; it must be an integer");
    check_refused([](json& result) { result["patches"][0]["solution"].erase("evidence"); },
                  "patches[0].solution.evidence is missing");
    check_refused([](json& result) { result["accuracy"] = -1; }, "accuracy is -1; it must be at least 0");
    check_refused([](json& result) { result["height"] = 1; }, "height is not a field");
    check_refused([](json& result) { result["patches"][0]["place"]["slope"] = 1; },
                  "patches[0].place.slope is not a field");
    check_refused([](json& result) { result["patches"] = 3; }, "patches is 3; it must be a list");
    check_refused([](json& result) { result.erase("patches"); }, "patches are missing, and so are contacts");
}

TEST_CASE("An answer whose array does not fit its grid is refused", "[client]") {
    const auto of_pressure = [](const auto& damage) {
        return [=](json& result) { damage(result["patches"][0]["solution"]["pressure"]); };
    };
    check_refused(of_pressure([](json& pressure) { pressure = {{3, 4, 5}}; }), "pressure has 3 values at [0]");
    check_refused(of_pressure([](json& pressure) { pressure["$array"]["shape"] = {1, 3}; }),
                  "pressure has shape [1,3]");
    check_refused(of_pressure([](json& pressure) { pressure["$array"]["frame"] = 2; }), "pressure refers to frame 2");
    check_refused(of_pressure([](json& pressure) { pressure = {{3, "x"}}; }), "pressure contains \"x\" at [0, 1]");
}

TEST_CASE("An answer that is no JSON is refused, as one with NaN is", "[client]") {
    const std::string z = "\"z\":0.25";
    check_refused(replaced(z, "\"z\":NaN"), "is not a JSON object");
    check_refused(replaced(z, "\"z\":Infinity"), "is not a JSON object");
    check_refused(replaced(z, "\"z\":1e999"), "is not a JSON object");
    check_refused(replaced(z, "\"z\":0.25,"), "is not a JSON object");
    check_refused(replaced(z, "\"z\":0.25,\"z\":0.5"), "an object with a duplicate field");
}

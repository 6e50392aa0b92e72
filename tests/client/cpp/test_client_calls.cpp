// Tests the course of calls: progress, errors, timeouts, cancellation, and invalid answers.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <chrono>
#include <future>
#include <limits>
#include <stop_token>
#include <thread>

#include "contactd/client/client.hpp"
#include "contactd/proto/schema.hpp"
#include "fake_solver.hpp"

using namespace contactd;
using namespace contactd::client;
using namespace std::chrono_literals;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using fake::echo_gap, fake::healthy, fake::problem;
using fake::Frames;
using nlohmann::json;

TEST_CASE("Progress is reported in order", "[client]") {
    fake::Daemon daemon([](const json& request, const Frames&) -> std::vector<Frames> {
        return {{fake::progress(request, {{"job", "build-1"}, {"stage", "assembly"}, {"fraction", 0.1}})},
                {fake::progress(request, {{"job", "build-1"}, {"stage", "pcg"}, {"fraction", 0.5}, {"iteration", 7}})},
                {fake::reply(request, healthy)}};
    });
    Client client(daemon.endpoint());
    std::vector<Progress> reports;

    client.health({.on_progress = [&](const Progress& report) { reports.push_back(report); }});

    REQUIRE(reports.size() == 2);
    CHECK(reports[0].stage == "assembly");
    CHECK(reports[1].job == "build-1");
    CHECK(reports[1].iteration == 7);
    CHECK(reports[1].fraction == 0.5);
}

TEST_CASE("A status of the daemon is thrown with its details", "[client]") {
    fake::Daemon daemon([](const json& request, const Frames&) -> std::vector<Frames> {
        Status status{StatusCode::resource_exhausted, "The queue is full.", "QUEUE_FULL", {}, 250};
        return {{fake::failure(request, proto::to_json(status))}};
    });
    Client client(daemon.endpoint());

    try {
        client.jobs();
        FAIL("nothing was thrown");
    } catch (const StatusError& error) {
        CHECK(error.status().code == StatusCode::resource_exhausted);
        CHECK(error.status().reason == "QUEUE_FULL");
        CHECK(error.status().retry_delay_ms == 250);
        CHECK(std::string(error.what()) == "The queue is full.");
    }
}

TEST_CASE("An error whose id the daemon could not find is ours", "[client]") {
    fake::Daemon daemon([](const json&, const Frames&) -> std::vector<Frames> {
        return {{fake::failure({{"id", nullptr}}, {{"code", 3}, {"name", "INVALID_ARGUMENT"}, {"message", "No."}})}};
    });
    Client client(daemon.endpoint());
    CHECK_THROWS_AS(client.health(), StatusError);
}

TEST_CASE("A call ends at its timeout and its late answer is discarded", "[client]") {
    json late;
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> {
        if (late.is_null()) {
            late = request;
            return {};
        }
        return {{fake::reply(late, {{"state", "stopping"}})}, {fake::reply(request, healthy)}};
    });
    Client client(daemon.endpoint());
    const auto start = std::chrono::steady_clock::now();

    CHECK_THROWS_AS(client.health({.timeout = 50ms}), TimeoutError);

    const auto waited = std::chrono::steady_clock::now() - start;
    CHECK(waited >= 50ms);
    CHECK(client.health() == "serving");
}

TEST_CASE("Progress does not put off the timeout", "[client]") {
    fake::Daemon daemon([](const json& request, const Frames&) -> std::vector<Frames> {
        return std::vector<Frames>(3, {fake::progress(request, {{"stage", "pcg"}, {"fraction", 0.1}})});
    });
    Client client(daemon.endpoint());
    CHECK_THROWS_AS(client.health({.timeout = 50ms}), TimeoutError);
}

TEST_CASE("A wait for a build that ends says that the build goes on, and as which job", "[client]") {
    bool refused = false;
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> {
        const Frames going{fake::progress(request, {{"job", "build-3"}, {"stage", "pcg"}, {"fraction", 0.1}})};
        if (!refused) return {going};
        const json late{{"code", 4}, {"name", "DEADLINE_EXCEEDED"}, {"message", "Too late."}};
        return {going, {fake::failure(request, late)}};
    });
    Client client(daemon.endpoint());
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.8;
    spec.nx = spec.ny = 2;
    spec.source = IcSource::fem;
    const std::string advice = "continues in the daemon as job build-3. jobs() reports its progress";

    CHECK_THROWS_MATCHES(client.get_ic(spec, {.timeout = 50ms}), TimeoutError,
                         MessageMatches(ContainsSubstring(advice)));
    refused = true;
    CHECK_THROWS_MATCHES(client.get_ic(spec), StatusError, MessageMatches(ContainsSubstring(advice)));
}

TEST_CASE("Nobody listening and bad endpoints are connection errors", "[client]") {
    Client client("tcp://127.0.0.1:1", {.connect_timeout = 50ms});
    CHECK_THROWS_MATCHES(client.health(), ConnectionError, MessageMatches(ContainsSubstring("tcp://127.0.0.1:1")));
    CHECK_THROWS_AS(Client("nonsense"), ConnectionError);
    CHECK_THROWS_AS(Client(""), ConnectionError);
}

TEST_CASE("Malformed answers are named as such and the next call works", "[client]") {
    std::function<std::string(const json&)> answer;
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> { return {{answer(request)}}; });
    Client client(daemon.endpoint());
    const std::vector<std::function<std::string(const json&)>> malformed{
        [](const json&) { return ""; },
        [](const json&) { return "hello"; },
        [](const json&) { return "[]"; },
        [](const json&) { return "{}"; },
        [](const json& request) { return json{{"contactd", 1}, {"id", request["id"]}}.dump(); },
        [](const json& request) { return json{{"contactd", 9}, {"id", request["id"]}, {"progress", {}}}.dump(); },
        [](const json& request) { return fake::failure(request, {{"code", 99}, {"name", ""}, {"message", ""}}); },
        [](const json& request) { return fake::reply(request, {{"state", "asleep"}}); },
        [](const json& request) { return fake::reply(request, json::object()); },
        [](const json& request) { return fake::progress(request, {{"stage", 5}, {"fraction", 2}}); }};
    for (std::size_t i = 0; i < malformed.size(); ++i) {
        CAPTURE(i);
        answer = malformed[i];
        CHECK_THROWS_AS(client.health(), ProtocolError);
    }
    answer = [](const json& request) { return fake::reply(request, healthy); };
    CHECK(client.health() == "serving");
}

TEST_CASE("Arrays of an answer that do not fit are the daemon's fault", "[client]") {
    fake::Daemon daemon([](const json& request, const Frames& frames) {
        std::vector<Frames> answer = echo_gap(request, frames);
        answer[0].pop_back();
        return answer;
    });
    Client client(daemon.endpoint());
    CHECK_THROWS_AS(client.solve(problem()), ProtocolError);
}

TEST_CASE("What cannot be solved or sent is refused before it is sent", "[client]") {
    int requests = 0;
    fake::Daemon daemon([&](const json&, const Frames&) -> std::vector<Frames> {
        ++requests;
        return {};
    });
    Client client(daemon.endpoint(), {.limits = {.max_frame_bytes = 200}});
    ContactProblem bad = problem();
    bad.approach = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(client.solve(bad), InvalidArgument);
    bad.approach.reset();
    CHECK_THROWS_AS(client.solve(bad), InvalidArgument);
    CHECK_THROWS_AS(client.solve_many(std::vector{bad}), InvalidArgument);
    bad.approach = 0.02;
    bad.Fn = 1;
    CHECK_THROWS_AS(client.solve(bad), InvalidArgument);

    ContactProblem large = problem();
    large.grid = Grid::of_elements(50, 50, 0.1, 0.1);
    large.gap = Paraboloid{50, 50};
    try {
        client.solve(large);
        FAIL("nothing was thrown");
    } catch (const StatusError& error) {
        CHECK(error.status().reason == "LIMIT_EXCEEDED");
    }
    CHECK(requests == 0);
}

namespace {

/// Never answers; records the ids of requests and of cancellations.
struct Silent {
    std::string asked;
    std::promise<std::string> cancelled;
    bool with_progress = false;
    fake::Daemon daemon{[this](const json& request, const Frames&) -> std::vector<Frames> {
        if (request["method"] == "request.cancel") {
            cancelled.set_value(request["params"]["id"]);
            return {};
        }
        asked = request["id"];
        if (!with_progress) return {};
        return {{fake::progress(request, {{"stage", "pcg"}, {"fraction", 0.1}})}};
    }};
};

}  // namespace

TEST_CASE("A call that times out is cancelled", "[client]") {
    Silent silent;
    Client client(silent.daemon.endpoint());
    CHECK_THROWS_AS(client.health({.timeout = 10ms}), TimeoutError);
    CHECK(silent.cancelled.get_future().get() == silent.asked);
}

TEST_CASE("A call whose progress handler throws is cancelled", "[client]") {
    Silent silent;
    silent.with_progress = true;
    Client client(silent.daemon.endpoint());
    const auto enough = [](const Progress&) { throw std::runtime_error("enough"); };
    CHECK_THROWS_AS(client.health({.on_progress = enough}), std::runtime_error);
    CHECK(silent.cancelled.get_future().get() == silent.asked);
}

TEST_CASE("A call is stopped from another thread", "[client]") {
    Silent silent;
    Client client(silent.daemon.endpoint());
    std::stop_source stop;
    const std::jthread stopper([&] { stop.request_stop(); });
    try {
        client.health({.stop = stop.get_token()});
        FAIL("nothing was thrown");
    } catch (const StatusError& error) {
        CHECK(error.status().code == StatusCode::cancelled);
    }
    CHECK(silent.cancelled.get_future().get() == silent.asked);
}

TEST_CASE("Requests name the client", "[client]") {
    json seen;
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> {
        seen = request;
        return {{fake::reply(request, healthy)}};
    });
    Client(daemon.endpoint()).health();
    CHECK_THAT(seen["metadata"]["client"].get<std::string>(), ContainsSubstring("contactd-cpp "));
    CHECK(proto::violations_of("envelope", seen).empty());
}

TEST_CASE("Another version is named with the side to upgrade", "[client]") {
    int version = 0;
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> {
        json answer = json::parse(fake::reply(request, healthy));
        answer["contactd"] = version;
        return {{answer.dump()}};
    });
    Client client(daemon.endpoint());
    CHECK_THROWS_MATCHES(client.health(), ProtocolError, MessageMatches(ContainsSubstring("upgrade the daemon")));
    version = 2;
    CHECK_THROWS_MATCHES(client.health(), ProtocolError, MessageMatches(ContainsSubstring("upgrade the client")));
}

TEST_CASE("The states of the daemon are watched", "[client]") {
    fake::Daemon daemon([&](const json& request, const Frames&) {
        std::vector<Frames> answers;
        for (const char* state : {"serving", "serving", "stopping"})
            answers.push_back({fake::progress(request, {{"stage", "watch"}, {"fraction", 0}, {"state", state}})});
        answers.push_back({fake::reply(request, {{"state", "stopping"}})});
        return answers;
    });
    std::vector<std::string> seen;
    CHECK(Client(daemon.endpoint()).watch_health([&](const std::string& state) { seen.push_back(state); }) ==
          "stopping");
    CHECK(seen == std::vector<std::string>{"serving", "stopping"});
}

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <chrono>
#include <cstring>
#include <future>
#include <limits>
#include <stop_token>
#include <thread>

#include "contactd/client/client.hpp"
#include "contactd/proto/schema.hpp"
#include "fake_daemon.hpp"

using namespace contactd;
using namespace contactd::client;
using namespace std::chrono_literals;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using fake::Frames;
using nlohmann::json;

namespace {

const json healthy{{"state", "serving"}};

ContactProblem problem() {
    ContactProblem problem;
    problem.grid = Grid::centred(3, 2, 0.1, 0.1);
    problem.bodies = {{200, 0.42}, {200, 0.42}};
    problem.gap = Paraboloid{50, 50};
    problem.approach = 0.02;
    return problem;
}

/// Solves by returning the gap as the pressure.
proto::SolveReply gap_as_pressure(const ContactProblem& read) {
    proto::SolveReply reply;
    reply.solution.pressure = reply.solution.traction_x = reply.solution.traction_y = undeformed_distance(read);
    reply.solution.element_division.assign(read.grid.size(), ElementState::slip);
    reply.upper = {"closed_form", "", {}};
    reply.upper->evidence.source = "analytic";
    reply.lower = reply.upper;
    return reply;
}

std::vector<Frames> message_of(const json& request, const json& result, proto::ArrayWriter& arrays) {
    Frames message{fake::reply(request, result)};
    for (std::string& frame : arrays.take_frames()) message.push_back(std::move(frame));
    return {message};
}

std::vector<Frames> echo_gap(const json& request, const Frames& frames) {
    const ContactProblem read = proto::decode_problem(request["params"], frames);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    return message_of(request, proto::encode_solve_reply(gap_as_pressure(read), read.grid, arrays), arrays);
}

/// The same for many; fails those without contact.
std::vector<Frames> echo_gaps(const json& request, const Frames& frames) {
    std::vector<proto::ReplyOrStatus> replies;
    std::vector<Grid> grids;
    for (const auto& problem : proto::decode_problems(request["params"], frames)) {
        const auto& read = std::get<ContactProblem>(problem);
        grids.push_back(read.grid);
        if (read.approach > 0)
            replies.emplace_back(gap_as_pressure(read));
        else
            replies.emplace_back(proto::Status{proto::StatusCode::internal, "No.", "UNEXPECTED", {}, 0});
    }
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    return message_of(request, proto::encode_solve_replies(replies, grids, arrays), arrays);
}

}  // namespace

TEST_CASE("A request carries version, method, parameters and timeout", "[client]") {
    json seen;
    fake::Daemon daemon([&](const json& request, const Frames&) -> std::vector<Frames> {
        seen = request;
        return {{fake::reply(request, {{"job", "build-3"}})}};
    });
    Client client(daemon.endpoint());

    client.cancel_job("build-3", {.timeout = 1234ms});

    CHECK(proto::violations_of("envelope", seen).empty());
    CHECK(seen["method"] == "job.cancel");
    CHECK(seen["params"] == json{{"job", "build-3"}});
    CHECK(seen["timeout_ms"] == 1234);
}

TEST_CASE("A problem goes out and its solution comes back", "[client]") {
    fake::Daemon daemon(echo_gap);
    Client client(daemon.endpoint());

    const auto reply = client.solve(problem());

    CHECK(reply.solution.pressure == undeformed_distance(problem()));
    CHECK(reply.upper->origin == "closed_form");
}

TEST_CASE("Many problems go out and their outcomes come back in order", "[client]") {
    std::size_t frames_sent = 0;
    fake::Daemon daemon([&](const json& request, const Frames& frames) {
        CHECK(request["method"] == "contact.solve_many");
        frames_sent = frames.size();
        return echo_gaps(request, frames);
    });
    Client client(daemon.endpoint());
    std::vector<ContactProblem> problems(3, problem());
    problems[0].gap = problems[2].gap = std::vector<double>{1, 2, 3, 4, 5, 6};
    problems[1].approach = -1;

    const auto replies = client.solve_many(problems);

    REQUIRE(replies.size() == 3);
    CHECK(std::get<proto::SolveReply>(replies[0]).solution.pressure == std::vector<double>{1, 2, 3, 4, 5, 6});
    CHECK(std::get<proto::Status>(replies[1]).message == "No.");
    CHECK(std::get<proto::SolveReply>(replies[2]).solution.pressure.size() == 6);
    CHECK(frames_sent == 1);
}

TEST_CASE("Another number of solutions than problems is the daemon's fault", "[client]") {
    fake::Daemon daemon([](const json& request, const Frames& frames) {
        json fewer = request;
        fewer["params"]["problems"].erase(0);
        return echo_gaps(fewer, frames);
    });
    Client client(daemon.endpoint());
    CHECK_THROWS_AS(client.solve_many(std::vector<ContactProblem>(2, problem())), ProtocolError);
}

TEST_CASE("Of many problems the one that cannot be solved is named", "[client]") {
    fake::Daemon daemon(echo_gaps);
    Client client(daemon.endpoint());
    std::vector<ContactProblem> problems(2, problem());
    problems[1].bodies.upper.nu = 0.6;
    try {
        client.solve_many(problems);
        FAIL("nothing was thrown");
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "problems[1].bodies.upper.nu");
        CHECK_THAT(error.what(), ContainsSubstring("problems[1].bodies.upper.nu is 0.6; it must"));
    }
}

TEST_CASE("Stresses are asked for and read", "[client]") {
    proto::SubsurfaceRequest request;
    request.grid = Grid::centred(2, 1, 0.1, 0.1);
    request.nu = 0.3;
    request.body = ContactBody::upper;
    request.pressure = {1, 2};
    request.points = StressBlock{{0, 1, 2}, {0}, {0, -1}};
    std::vector<std::size_t> shape{2, 1, 3};
    fake::Daemon daemon([&](const json& asked, const Frames& frames) {
        CHECK(asked["method"] == "contact.subsurface");
        const auto read = proto::decode_subsurface_request(asked["params"], frames);
        CHECK(read.body == ContactBody::upper);
        proto::SubsurfaceReply reply;
        for (auto* values : {&reply.stress.xx, &reply.stress.yy, &reply.stress.zz, &reply.stress.xy, &reply.stress.xz,
                             &reply.stress.yz, &reply.stress.von_mises})
            *values = std::vector<double>(6, read.pressure[1]);
        reply.shape = shape;
        reply.largest = {2, read.point(0)};
        proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
        return message_of(asked, proto::encode_subsurface_reply(reply, arrays), arrays);
    });
    Client client(daemon.endpoint());

    SECTION("as they come") {
        const auto reply = client.subsurface(request);
        CHECK(reply.stress.xz == std::vector<double>(6, 2));
        CHECK(reply.shape == request.shape());
        CHECK(reply.largest.von_mises == 2);
    }
    SECTION("another shape than asked for is the daemon's fault") {
        shape = {6};
        CHECK_THROWS_AS(client.subsurface(request), ProtocolError);
    }
    SECTION("an array that does not fit the grid is named before anything is sent") {
        request.traction_y = {1, 2, 3};
        CHECK_THROWS_MATCHES(client.subsurface(request), InvalidArgument,
                             MessageMatches(ContainsSubstring("traction_y has 3 values; the grid has 2 elements")));
    }
}

TEST_CASE("A table is asked for and read", "[client]") {
    fake::Daemon daemon([](const json& request, const Frames&) -> std::vector<Frames> {
        proto::IcReply reply{"key", "built", proto::decode_ic_spec(request["params"]), IcTable(2, 1), {}};
        reply.table(Axis::z, Axis::z, 1, 0) = 0.25;
        reply.evidence.source = "fem";
        proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
        const json result = proto::encode_ic_reply(reply, arrays);
        return {{fake::reply(request, result), arrays.take_frames()[0]}};
    });
    Client client(daemon.endpoint());
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.8;
    spec.nx = 2;
    spec.ny = 1;
    spec.source = IcSource::fem;
    SECTION("of a mesh") {
        spec.fem.mesh = MeshKind::prism;
    }
    SECTION("of an accuracy, for every Poisson's ratio of a block") {
        spec.body = BodyShape::block;
        spec.load_shape = LoadShape::bilinear;
        spec.accuracy = 1e-2;
        spec.any_nu = true;
        spec.fem.L_over_h = 20;
    }

    const proto::IcReply reply = client.get_ic(spec);

    CHECK(reply.spec == spec);
    CHECK(reply.table.at(Axis::z, Axis::z, -1, 0) == 0.25);
}

TEST_CASE("Progress is reported in order", "[client]") {
    fake::Daemon daemon([](const json& request, const Frames&) -> std::vector<Frames> {
        return {{fake::progress(request, {{"job", "build-1"}, {"stage", "assembly"}, {"fraction", 0.1}})},
                {fake::progress(request, {{"job", "build-1"}, {"stage", "pcg"}, {"fraction", 0.5}, {"iteration", 7}})},
                {fake::reply(request, healthy)}};
    });
    Client client(daemon.endpoint());
    std::vector<ProgressReport> reports;

    client.health({.on_progress = [&](const ProgressReport& report) { reports.push_back(report); }});

    REQUIRE(reports.size() == 2);
    CHECK(reports[0].stage == "assembly");
    CHECK(reports[1].job == "build-1");
    CHECK(reports[1].iteration == 7);
    CHECK(reports[1].fraction == 0.5);
}

TEST_CASE("A status of the daemon is thrown with its details", "[client]") {
    fake::Daemon daemon([](const json& request, const Frames&) -> std::vector<Frames> {
        proto::Status status{proto::StatusCode::resource_exhausted, "The queue is full.", "QUEUE_FULL", {}, 250};
        return {{fake::failure(request, proto::to_json(status))}};
    });
    Client client(daemon.endpoint());

    try {
        client.jobs();
        FAIL("nothing was thrown");
    } catch (const proto::StatusError& error) {
        CHECK(error.status().code == proto::StatusCode::resource_exhausted);
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
    CHECK_THROWS_AS(client.health(), proto::StatusError);
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
    CHECK(waited < 5s);
    CHECK(client.health() == "serving");
}

TEST_CASE("Progress does not put off the timeout", "[client]") {
    fake::Daemon daemon([](const json& request, const Frames&) -> std::vector<Frames> {
        return std::vector<Frames>(3, {fake::progress(request, {{"stage", "pcg"}, {"fraction", 0.1}})});
    });
    Client client(daemon.endpoint());
    CHECK_THROWS_AS(client.health({.timeout = 50ms}), TimeoutError);
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
    Client client(daemon.endpoint(), {.limits = {.max_frame_bytes = 500}});
    ContactProblem bad = problem();
    bad.approach = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(client.solve(bad), InvalidArgument);

    ContactProblem large = problem();
    large.grid = Grid::centred(50, 50, 0.1, 0.1);
    large.gap = Paraboloid{50, 50};
    try {
        client.solve(large);
        FAIL("nothing was thrown");
    } catch (const proto::StatusError& error) {
        CHECK(error.status().reason == "LIMIT_EXCEEDED");
    }
    CHECK(requests == 0);
}

namespace {

/// Never answers; the ids of what was asked and of what was cancelled.
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
    const auto enough = [](const ProgressReport&) { throw std::runtime_error("enough"); };
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
    } catch (const proto::StatusError& error) {
        CHECK(error.status().code == proto::StatusCode::cancelled);
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

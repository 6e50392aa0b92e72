// Tests clients and sessions in several threads and in forked processes: correct answers or a clear error.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <future>
#include <optional>
#include <thread>

#include "contactd/client/client.hpp"
#include "contactd/client/session.hpp"
#include "fake_solver.hpp"

using namespace contactd;
using namespace contactd::client;
using namespace std::chrono_literals;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using fake::echo_gap, fake::problem;
using fake::Frames;
using nlohmann::json;

namespace {

const json healthy{{"state", "serving"}};

/// Returns the exit status of a process forked for `act`; 99 if it throws.
int in_fork(const std::function<int()>& act) {
    const pid_t child = ::fork();
    if (child == 0) {
        int status = 99;
        try {
            status = act();
        } catch (...) {
        }
        ::_exit(status);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::vector<Frames> serving(const json& request, const Frames&) {
    return {{fake::reply(request, healthy)}};
}

/// Holds a session with its own grid, and its step number.
std::vector<Frames> stepping(const json& request, const Frames&) {
    const std::string method = request["method"];
    if (method == "session.open")
        return {{fake::reply(request, {{"session", std::string(32, 'a')},
                                       {"lease_seconds", 60},
                                       {"step", 0},
                                       {"ics", json::object()},
                                       {"bytes", 1}})}};
    if (method == "session.info")
        return {{fake::reply(request, {{"step", 7},
                                       {"lease_seconds", 60},
                                       {"states", 0},
                                       {"bytes", 1},
                                       {"grid", {{"nx", 3}, {"ny", 2}, {"dx", 1}, {"dy", 1}}},
                                       {"motion", "rolling"},
                                       {"ics", json::object()}})}};
    if (method == "session.save") return {{fake::reply(request, {{"state", "state-1"}, {"step", 7}})}};
    return {{fake::reply(request, {{"step", 7}})}};
}

}  // namespace

TEST_CASE("A call while another one runs is refused, and that one is answered", "[client]") {
    std::promise<void> asked, go_on;
    fake::Daemon daemon([&](const json& request, const Frames& frames) {
        asked.set_value();
        go_on.get_future().wait();
        return serving(request, frames);
    });
    Client client(daemon.endpoint());
    auto first = std::async(std::launch::async, [&] { return client.health(); });
    asked.get_future().wait();

    CHECK_THROWS_MATCHES(client.health(), ConcurrencyError, MessageMatches(ContainsSubstring("one client per thread")));

    go_on.set_value();
    CHECK(first.get() == "serving");
}

TEST_CASE("A client that many threads use at once answers rightly or refuses, and never stalls", "[client]") {
    fake::Daemon daemon(echo_gap);
    Client client(daemon.endpoint());
    std::atomic<int> right = 0, wrong = 0, refused = 0;
    std::vector<std::jthread> threads;
    for (int n = 0; n < 4; ++n)
        threads.emplace_back([&, n] {
            ContactProblem mine = problem();
            mine.gap = std::vector<double>(mine.grid.size(), n);
            for (int i = 0; i < 25; ++i) {
                try {
                    const auto reply = client.solve(mine);
                    ++(reply.solution.pressure == std::vector<double>(mine.grid.size(), n) ? right : wrong);
                } catch (const ConcurrencyError&) {
                    ++refused;
                }
            }
        });
    threads.clear();

    CHECK(wrong == 0);
    CHECK(right > 0);
    CHECK(right + refused == 100);
}

TEST_CASE("Threads hand a client on between calls", "[client]") {
    fake::Daemon daemon(serving);
    Client client(daemon.endpoint());
    for (int n = 0; n < 3; ++n) {
        std::string state;
        std::thread([&] { state = client.health(); }).join();
        CHECK(state == "serving");
    }
}

TEST_CASE("A call in on_progress of the same client is refused", "[client]") {
    fake::Daemon daemon([](const json& request, const Frames&) -> std::vector<Frames> {
        return {{fake::progress(request, {{"stage", "watch"}, {"fraction", 0}, {"state", "serving"}})},
                {fake::reply(request, healthy)}};
    });
    Client client(daemon.endpoint()), other(daemon.endpoint());
    std::string nested;

    CHECK_THROWS_AS(client.health({.on_progress = [&](const Progress&) { client.health(); }}), ConcurrencyError);
    client.health({.on_progress = [&](const Progress&) { nested = other.health(); }});

    CHECK(nested == "serving");
}

#ifndef __SANITIZE_THREAD__  // which ends a forked process that starts threads
TEST_CASE("A forked process goes on with a connection of its own", "[client]") {
    fake::Daemon daemon(serving);
    Client client(daemon.endpoint());
    std::optional<Client> ended_by_the_child(std::in_place, daemon.endpoint());
    REQUIRE(client.health() == "serving");
    REQUIRE(ended_by_the_child->health() == "serving");

    for (int n = 0; n < 3; ++n)
        CHECK(in_fork([&] {
                  ended_by_the_child.reset();
                  return client.health() == "serving" && client.health() == "serving" ? 0 : 1;
              }) == 0);

    CHECK(client.health() == "serving");
    CHECK(ended_by_the_child->health() == "serving");
}
#endif

TEST_CASE("A session tells its name, and is joined by it where it is", "[client]") {
    std::vector<json> requests;
    fake::Daemon daemon([&](const json& request, const Frames& frames) {
        requests.push_back(request);
        return stepping(request, frames);
    });
    Client client(daemon.endpoint());
    std::string name;
    {
        Session opened(client, problem());
        CHECK(opened.name() == std::string(32, 'a'));
        name = opened.release();
    }
    CHECK(requests.size() == 1);
    {
        Session joined = Session::join(client, name);
        CHECK(joined.step_number() == 7);
        CHECK(joined.lease_seconds() == 60);
        CHECK(joined.name() == name);
    }
    CHECK(requests.back()["method"] == "session.close");
    CHECK(requests.back()["params"]["session"] == name);
}

TEST_CASE("A session of a problem holds its gap, load and friction", "[client]") {
    json opened;
    fake::Daemon daemon([&](const json& request, const Frames& frames) {
        if (request["method"] == "session.open") opened = request["params"];
        return stepping(request, frames);
    });
    Client client(daemon.endpoint());

    Session session(client, problem());

    CHECK(opened.contains("gap"));
    CHECK(opened["approach"] == problem().approach);
}

TEST_CASE("A session belongs to its process, and its end to the parent", "[client]") {
    std::atomic<int> requests = 0;
    fake::Daemon daemon([&](const json& request, const Frames& frames) {
        ++requests;
        return stepping(request, frames);
    });
    Client client(daemon.endpoint());
    std::optional<Session> session(std::in_place, client, problem());

    CHECK(in_fork([&] {
              try {
                  session->save();
              } catch (const ConcurrencyError& error) {
                  session.reset();
                  return std::string(error.what()).find("join(client, name)") != std::string::npos ? 0 : 1;
              }
              return 2;
          }) == 0);

    CHECK(requests == 1);
    CHECK(session->save().step == 7);
}

TEST_CASE("A session takes one call at a time", "[client]") {
    std::promise<void> asked, go_on;
    fake::Daemon daemon([&](const json& request, const Frames& frames) {
        if (request["method"] == "session.save") {
            asked.set_value();
            go_on.get_future().wait();
        }
        return stepping(request, frames);
    });
    Client client(daemon.endpoint());
    Session session(client, problem());
    auto first = std::async(std::launch::async, [&] { return session.save(); });
    asked.get_future().wait();

    CHECK_THROWS_MATCHES(session.step({}), ConcurrencyError,
                         MessageMatches(ContainsSubstring("A session takes one step at a time")));

    go_on.set_value();
    CHECK(first.get().step == 7);
}

// Tests the service in process: messages in, messages out, and its end.
#include "service/in_process.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "contactd/error.hpp"
#include "support/temporary_folder.hpp"

namespace {

using contactd::TemporaryFolder;
using contactd::server::Exchange;
using contactd::server::InProcess;
using nlohmann::json;
using namespace std::chrono_literals;

std::string config_in(const TemporaryFolder& folder, int workers = 1) {
    return json{{"store", {{"folder", (folder.path() / "store").string()}}}, {"workers", workers}}.dump();
}

std::string request(const std::string& method, const json& params = json::object(), int timeout_ms = 0) {
    json envelope{{"contactd", 1}, {"id", "a"}, {"method", method}, {"params", params}};
    if (timeout_ms > 0) envelope["timeout_ms"] = timeout_ms;
    return envelope.dump();
}

/// Is a solve that would take hours.
json endless() {
    return {{"grid", {{"nx", 60}, {"ny", 60}, {"dx", 0.04}, {"dy", 0.04}}},
            {"bodies", {{"upper", {{"G", 200}, {"nu", 0.42}}}, {"lower", {{"G", 200}, {"nu", 0.42}}}}},
            {"ics", {{"source", "analytic"}}},
            {"gap", {{"paraboloid", {{"Rx", 50}, {"Ry", 50}}}}},
            {"approach", 0.02},
            {"friction",
             {{"mu", 0.3}, {"rolling", {{"kind", "transient"}, {"xi", 2e-3}, {"phi", 1e-3}, {"steps", 1000}}}}}};
}

json simplified() {
    json params = endless();
    params["model"] = "hertz";
    params["grid"] = {{"nx", 20}, {"ny", 20}, {"dx", 0.12}, {"dy", 0.12}};
    params.erase("friction");
    params.erase("ics");
    return params;
}

/// Returns the answer, after any progress.
json answer_of(Exchange& exchange) {
    for (;;) {
        const auto message = exchange.next(Exchange::Clock::now() + 20s);
        if (!message) throw std::runtime_error("no answer");  // Catch2 supports one thread only
        json envelope = json::parse(message->front().bytes());
        if (envelope.contains("status")) return envelope;
    }
}

std::string reason_of(const json& answer) {
    return answer["status"]["details"]["reason"];
}

}  // namespace

TEST_CASE("A request in process is answered as on the wire") {
    const TemporaryFolder folder;
    InProcess service(config_in(folder));
    const auto exchange = service.ask(request("server.health"), {});
    const json answer = answer_of(*exchange);
    CHECK(answer["id"] == "a");
    CHECK(answer["status"]["code"] == 0);
    CHECK(answer["result"]["state"] == "serving");
    CHECK_FALSE(exchange->next(Exchange::Clock::now()));  // answered once
}

TEST_CASE("What is wrong with a message is its answer") {
    const TemporaryFolder folder;
    InProcess service(config_in(folder));
    CHECK(reason_of(answer_of(*service.ask("{", {}))) == "NOT_JSON");
    CHECK(reason_of(answer_of(*service.ask(request("contact.guess"), {}))) == "UNKNOWN_METHOD");
    const json refused = answer_of(*service.ask(request("contact.solve", {{"grid", 1}}), {}));
    CHECK(refused["status"]["code"] == 3);
    CHECK(refused["status"]["details"]["violations"][0]["field"] == "gap");
}

TEST_CASE("A configuration that cannot be used is refused by its field") {
    CHECK_THROWS_AS(InProcess(R"({"workers": 0})"), contactd::Error);
    CHECK_THROWS_AS(InProcess("{"), contactd::Error);
    try {
        const InProcess service(R"({"workers": 0})");
    } catch (const contactd::Error& error) {
        CHECK(std::string(error.what()).find("workers is 0") != std::string::npos);
    }
}

TEST_CASE("A request in process ends at its time") {
    const TemporaryFolder folder;
    InProcess service(config_in(folder));
    CHECK(reason_of(answer_of(*service.ask(request("contact.solve", endless(), 50), {}))) == "DEADLINE_PASSED");
    CHECK(answer_of(*service.ask(request("server.health"), {}))["status"]["code"] == 0);
}

TEST_CASE("A request in process that is cancelled leaves its worker to others") {
    const TemporaryFolder folder;
    InProcess service(config_in(folder));
    const auto given_up = service.ask(request("contact.solve", endless()), {});
    CHECK_FALSE(given_up->next(Exchange::Clock::now() + 20ms));
    given_up->cancel();
    CHECK(reason_of(answer_of(*given_up)) == "REQUEST_CANCELLED");
    CHECK(reason_of(answer_of(*service.ask(request("contact.solve", endless(), 50), {}))) == "DEADLINE_PASSED");
}

TEST_CASE("A request that nobody holds any more leaves its worker to others") {
    const TemporaryFolder folder;
    InProcess service(config_in(folder));
    service.ask(request("contact.solve", endless()), {}).reset();
    CHECK(reason_of(answer_of(*service.ask(request("contact.solve", endless(), 50), {}))) == "DEADLINE_PASSED");
    CHECK(answer_of(*service.ask(request("job.list"), {}))["result"]["jobs"].empty());
}

TEST_CASE("Small solves need no thread of the service") {
    const TemporaryFolder folder;
    InProcess service(config_in(folder));
    const auto blocks = service.ask(request("contact.solve", endless()), {});  // the only worker
    CHECK(answer_of(*service.ask(request("contact.solve", simplified()), {}))["status"]["code"] == 0);
    blocks->cancel();
}

TEST_CASE("Threads that ask at once are all answered") {
    const TemporaryFolder folder;
    InProcess service(config_in(folder, 2));
    const auto ask = [&](const std::string& method, const json& params = json::object()) {
        return answer_of(*service.ask(request(method, params), {}));
    };
    std::atomic<int> good = 0;
    {
        std::vector<std::jthread> threads;
        for (int n = 0; n < 4; ++n)
            threads.emplace_back([&] {
                for (int turn = 0; turn < 5; ++turn) {
                    const json session = ask("session.open", simplified())["result"]["session"];
                    for (const char* method : {"server.info", "server.metrics", "job.list", "session.list"})
                        good += ask(method)["status"]["code"] == 0;
                    good += ask("contact.solve", simplified())["status"]["code"] == 0;
                    good += ask("session.step", {{"session", session}, {"step", 1}})["status"]["code"] == 0;
                    good +=
                        ask("contact.solve_many", {{"problems", {simplified(), simplified()}}})["status"]["code"] == 0;
                    good += ask("session.close", {{"session", session}})["status"]["code"] == 0;
                }
            });
    }
    CHECK(good == 4 * 5 * 8);
}

TEST_CASE("The end answers what is open, and what comes later is refused") {
    const TemporaryFolder folder;
    InProcess service(config_in(folder));
    const auto open = service.ask(request("contact.solve", endless()), {});
    const auto watch = service.ask(request("health.watch"), {});
    service.close();
    service.close();
    CHECK(reason_of(answer_of(*open)) == "STOPPING");
    CHECK(answer_of(*watch)["result"]["state"] == "stopping");
    CHECK_THROWS_AS(service.ask(request("server.health"), {}), contactd::Error);
}

TEST_CASE("Requests that come while the service ends are answered or refused") {
    const TemporaryFolder folder;
    InProcess service(config_in(folder, 2));
    std::atomic<int> unanswered = 0;
    {
        std::vector<std::jthread> threads;
        for (int n = 0; n < 4; ++n)
            threads.emplace_back([&] {
                try {
                    for (;;) {
                        const auto exchange = service.ask(request("contact.solve", endless()), {});
                        unanswered += !exchange->next(Exchange::Clock::now() + 20s);
                    }
                } catch (const contactd::Error&) {
                    // closed
                }
            });
        std::this_thread::sleep_for(20ms);
        service.close();
    }
    CHECK(unanswered == 0);
}

TEST_CASE("A process that was forked is refused, and ends without the threads of the other") {
    const TemporaryFolder folder;
    auto service = std::make_unique<InProcess>(config_in(folder));
    CHECK(answer_of(*service->ask(request("session.list"), {}))["status"]["code"] == 0);
    const auto open = service->ask(request("contact.solve", endless()), {});  // its worker runs
    const pid_t child = ::fork();
    if (child == 0) {
        bool is_refused = false;
        try {
            service->ask(request("server.health"), {});
        } catch (const contactd::Error&) {
            is_refused = true;
        }
        service.reset();
        ::_exit(is_refused ? 7 : 0);
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(WEXITSTATUS(status) == 7);
    open->cancel();
}

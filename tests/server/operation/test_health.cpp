#include <catch2/catch_test_macros.hpp>

#include "operation/health.hpp"

using namespace contactd::server;
using nlohmann::json;

namespace {

const contactd::MessageLimits limits;

struct Watcher {
    std::vector<json> messages;
    CallPtr call = std::make_shared<Call>(
        Route{"a"}, contactd::proto::Request{}, Call::Clock::now(), contactd::proto::Priority::normal, limits,
        [this](const Answer& answer) { messages.push_back(json::parse(answer.envelope)); });
};

}  // namespace

TEST_CASE("Who watches hears of the state now and of each change, and is answered at the end") {
    Health health;
    Watcher watcher;
    health.watch(watcher.call);
    REQUIRE(watcher.messages.size() == 1);
    CHECK(watcher.messages[0]["progress"]["state"] == "serving");

    health.set(HealthState::serving);
    CHECK(watcher.messages.size() == 1);
    health.set(HealthState::stopping);
    REQUIRE(watcher.messages.size() == 3);
    CHECK(watcher.messages[1]["progress"]["state"] == "stopping");
    CHECK(watcher.messages[2]["result"] == json{{"state", "stopping"}});
}

TEST_CASE("Who watches a daemon that ends already is answered at once") {
    Health health;
    health.set(HealthState::stopping);
    Watcher watcher;
    health.watch(watcher.call);
    CHECK(watcher.messages.back()["result"] == json{{"state", "stopping"}});
}

TEST_CASE("Who has been answered hears nothing more") {
    Health health;
    Watcher watcher;
    health.watch(watcher.call);
    watcher.call->fail({});
    health.set(HealthState::stopping);
    CHECK(watcher.messages.size() == 2);
}

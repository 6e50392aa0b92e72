// Tests turns, states, leases and limits of sessions, without a daemon.
#include <catch2/catch_test_macros.hpp>
#include <future>
#include <thread>

#include "sessions/session_table.hpp"

using namespace contactd;
using namespace contactd::server;
using namespace std::chrono_literals;

namespace {

constexpr SessionLimits limits{2, 1'000'000, 2, 300, 3600};

SessionPtr session(std::chrono::duration<double> lease = 300s) {
    SessionSpec spec;
    spec.setup.grid = Grid{4, 4, 1, 1, 0, 0};
    spec.setup.bodies = {{1, 0}, {1, 0}};
    return std::make_shared<Session>(simulation_of(std::make_unique<engine::ContactSteps>(
                                         std::move(spec), engine::IcAnswers{}, engine::CachedInfluence{})),
                                     lease);
}

std::string reason_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const proto::StatusError& error) {
        return error.status().reason;
    }
    return "none";
}

SessionStatePtr state_at(long long step) {
    auto state = std::make_shared<SessionState>();
    state->last = std::make_shared<const engine::StepState>(engine::StepState{.step = step});
    return state;
}

}  // namespace

TEST_CASE("Turns of one session run one after another in the order they came, while other sessions run") {
    WorkerPool workers(3);
    const auto one = session(), other = session();
    std::promise<void> begun, go_on, last;
    std::vector<int> order;
    one->enqueue(
        {},
        [&] {
            begun.set_value();
            go_on.get_future().wait();
            order.push_back(0);
        },
        workers);
    begun.get_future().wait();
    for (int n = 1; n <= 20; ++n)
        one->enqueue(
            {},
            [&order, &last, n] {
                order.push_back(n);
                if (n == 20) last.set_value();
            },
            workers);
    std::promise<void> beside;
    other->enqueue({}, [&] { beside.set_value(); }, workers);
    beside.get_future().wait();
    go_on.set_value();
    last.get_future().wait();

    CHECK(order.size() == 21);
    CHECK(std::is_sorted(order.begin(), order.end()));
}

TEST_CASE("What waits in a session and was abandoned is dropped before its turn") {
    SessionTable table(limits);
    const SessionPtr one = session();
    table.add(one);
    WorkerPool workers(1);
    std::promise<void> go_on, last;
    std::vector<int> order;
    one->enqueue({}, [&] { go_on.get_future().wait(); }, workers);
    bool abandoned = false;
    const auto held = std::make_shared<int>(1);
    one->enqueue({"client", {}, [&] { return abandoned; }}, [&, held] { order.push_back(1); }, workers);
    one->enqueue(
        {},
        [&] {
            order.push_back(2);
            last.set_value();
        },
        workers);
    abandoned = true;
    table.drop_abandoned();
    CHECK(held.use_count() == 1);
    go_on.set_value();
    last.get_future().wait();

    CHECK(order == std::vector{2});
}

TEST_CASE("What waits in a session goes with the workers") {
    const auto held = std::make_shared<int>(1);
    {
        WorkerPool workers(1);
        const auto one = session();
        std::promise<void> begun, go_on;
        one->enqueue(
            {},
            [&] {
                begun.set_value();
                go_on.get_future().wait();
            },
            workers);
        begun.get_future().wait();
        one->enqueue({}, [held] {}, workers);
        auto stopping = std::async(std::launch::async, [&] { workers.stop(); });
        go_on.set_value();
        stopping.wait();
    }
    CHECK(held.use_count() == 1);
}

TEST_CASE("A saved state stays what it was and can be forgotten") {
    const auto one = session();
    const std::string start = one->save();
    one->set_state(state_at(5));
    const std::string later = one->save();
    one->set_state(state_at(6));

    CHECK(start != later);
    CHECK(one->saved(start)->last->step == 0);
    CHECK(one->saved(later)->last->step == 5);
    CHECK(one->forget(start) == 1);
    CHECK(reason_of([&] { one->saved(start); }) == "STATE_UNKNOWN");
    CHECK(reason_of([&] { one->forget(start); }) == "STATE_UNKNOWN");
}

TEST_CASE("Saved states count as bytes of their session") {
    const auto one = session();
    const std::size_t before = one->bytes();
    one->save();

    CHECK(one->bytes() == before + one->state_bytes());
}

TEST_CASE("Names of sessions differ in all places") {
    SessionTable table(limits);
    const std::string one = table.add(session()), other = table.add(session());

    CHECK(one.size() == 32);
    CHECK(one.find_first_not_of("0123456789abcdef") == std::string::npos);
    CHECK(one.substr(0, 16) != other.substr(0, 16));
    CHECK(one.substr(16) != other.substr(16));
}

TEST_CASE("A session that was closed, and one that never was, are unknown") {
    SessionTable table(limits);
    const std::string name = table.add(session());
    const SessionPtr closed = table.remove(name);

    CHECK(closed->closed());
    CHECK(reason_of([&] { table.find(name); }) == "SESSION_UNKNOWN");
    CHECK(reason_of([&] { table.remove(name); }) == "SESSION_UNKNOWN");
    CHECK(reason_of([&] { table.find("0"); }) == "SESSION_UNKNOWN");
    CHECK(table.all().empty());
}

TEST_CASE("An unused session expires, and a renewed one later") {
    SessionTable table(limits);
    const std::string brief = table.add(session(10s)), longer = table.add(session(20s));
    const auto start = Session::Clock::now();

    CHECK(table.next_expiry() <= start + 10s);
    table.expire(start + 9s);
    CHECK(table.all().size() == 2);
    table.expire(start + 11s);
    CHECK(table.all().size() == 1);
    CHECK(table.next_expiry() > start + 11s);
    CHECK(table.next_expiry() <= start + 21s);
    CHECK(reason_of([&] { table.find(brief); }) == "SESSION_EXPIRED");
    CHECK(reason_of([&] { table.find(longer); }) == "none");
    table.expire(start + 60s);
    CHECK(table.all().empty());
    CHECK(table.next_expiry() == Session::Clock::time_point::max());
}

TEST_CASE("A session does not expire while it is used") {
    SessionTable table(limits);
    const SessionPtr busy = session(0.5s);
    table.add(busy);
    WorkerPool workers(1);
    std::promise<void> used;
    busy->enqueue(
        {},
        [&] {
            table.expire(Session::Clock::now() + 60s);
            CHECK(table.all().size() == 1);
            used.set_value();
        },
        workers);
    used.get_future().wait();
    workers.stop();
    table.expire(Session::Clock::now() + 120s);

    CHECK(table.all().empty());
}

TEST_CASE("Sessions, their states and their bytes are limited") {
    const SessionLimits two_fit{3, 2 * session()->bytes() + session()->state_bytes(), 1, 300, 3600};
    SessionTable table(two_fit);
    const std::string name = table.add(session());
    table.add(session());

    CHECK(reason_of([&] { table.add(session()); }) == "SESSION_LIMIT");  // bytes
    CHECK(reason_of([&] { table.save(*table.find(name)); }) == "none");
    CHECK(reason_of([&] { table.save(*table.find(name)); }) == "SESSION_LIMIT");  // states
    table.remove(name);
    CHECK(reason_of([&] { table.check_room(session()->bytes()); }) == "none");
    SessionTable few(limits);
    few.add(session());
    few.add(session());
    CHECK(reason_of([&] { few.add(session()); }) == "SESSION_LIMIT");  // count
}

TEST_CASE("A lease is what was asked for, within its bound") {
    const SessionTable table(limits);

    CHECK(table.lease({}) == 300s);
    CHECK(table.lease(2.5) == 2.5s);
    CHECK(reason_of([&] { (void)table.lease(3601); }) == "LIMIT_EXCEEDED");
}

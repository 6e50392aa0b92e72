#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <filesystem>
#include <future>

#include "engine/jobs/worker_pool.hpp"

using contactd::engine::QueueTicket;
using contactd::engine::WorkerPool;
using contactd::proto::Priority;

TEST_CASE("Every task that was posted is run") {
    std::atomic<int> ran = 0;
    std::promise<void> last;
    WorkerPool pool(3);
    for (int n = 0; n < 100; ++n)
        pool.post({}, [&] {
            if (++ran == 100) last.set_value();
        });

    last.get_future().wait();
    CHECK(ran == 100);
}

TEST_CASE("Threads start when they are needed, and no more than were asked for") {
    const auto threads = [] {
        const std::filesystem::directory_iterator tasks("/proc/self/task");
        return std::distance(begin(tasks), end(tasks));
    };
    const auto before = threads();
    WorkerPool pool(2);
    CHECK(threads() == before);
    for (int n = 0; n < 3; ++n) {  // in sequence, because one thread runs all
        std::promise<void> ran;
        pool.post({}, [&] { ran.set_value(); });
        ran.get_future().wait();
        while (pool.running() > 0) std::this_thread::yield();
    }
    CHECK(threads() == before + 1);
    std::promise<void> go_on;
    const auto gate = go_on.get_future().share();
    for (int n = 0; n < 5; ++n) pool.post({}, [gate] { gate.wait(); });
    while (pool.running() < 2) std::this_thread::yield();
    CHECK(threads() == before + 2);
    go_on.set_value();
}

TEST_CASE("Stopping waits for the running task, drops the waiting ones and what they hold") {
    WorkerPool pool(1);
    std::promise<void> begun, go_on;
    std::atomic<bool> ended = false, dropped_ran = false;
    const auto held = std::make_shared<int>(1);
    pool.post({}, [&] {
        begun.set_value();
        go_on.get_future().wait();
        ended = true;
    });
    begun.get_future().wait();
    pool.post({}, [&, held] { dropped_ran = true; });
    CHECK(pool.running() == 1);
    CHECK(pool.waiting() == 1);

    auto stopping = std::async(std::launch::async, [&] { pool.stop(); });
    while (pool.waiting() > 0) std::this_thread::yield();
    go_on.set_value();
    stopping.wait();

    CHECK(ended);
    CHECK_FALSE(dropped_ran);
    CHECK(held.use_count() == 1);
    pool.post({}, [&] { dropped_ran = true; });  // after the end: ignored
    CHECK_FALSE(dropped_ran);
}

namespace {

/// Creates a pool of one thread that is busy until it is released; then it runs posted tasks, which record their names.
class Stalled {
   public:
    Stalled() {
        pool.post({}, [this] {
            begun_.set_value();
            go_on_.get_future().wait();
        });
        begun_.get_future().wait();
    }
    void post(const std::string& name, QueueTicket ticket) {
        ++expected_;
        pool.post(std::move(ticket), [this, name] { order_.push_back(name); });
    }
    std::vector<std::string> order() {
        std::promise<void> done;
        // It comes last: even a starved task runs before it.
        for (int n = 0; n <= WorkerPool::most_passes * expected_; ++n) pool.post({"last", Priority::low}, [] {});
        pool.post({"last", Priority::low}, [&] { done.set_value(); });
        go_on_.set_value();
        done.get_future().wait();
        return order_;
    }

    WorkerPool pool{1};

   private:
    std::promise<void> begun_, go_on_;
    std::vector<std::string> order_;
    int expected_ = 0;
};

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("Clients take turns, however much one of them has posted") {
    Stalled stalled;
    for (const char* name : {"a1", "a2", "a3", "a4"}) stalled.post(name, {"a", Priority::normal});
    stalled.post("b1", {"b", Priority::normal});
    stalled.post("c1", {"c", Priority::normal});
    stalled.post("b2", {"b", Priority::normal});

    CHECK(stalled.order() == Names{"a1", "b1", "c1", "a2", "b2", "a3", "a4"});
}

TEST_CASE("Users take turns, however many clients one of them has, and their clients among themselves") {
    Stalled stalled;
    const auto post = [&](const std::string& name, const std::string& client, const std::string& user) {
        stalled.post(name, {client, Priority::normal, {}, user});
    };
    for (const char* client : {"p", "q", "r"}) {
        post(std::string("many-") + client + "1", client, "many");
        post(std::string("many-") + client + "2", client, "many");
    }
    post("one-1", "s", "one");
    post("one-2", "s", "one");

    CHECK(stalled.order() == Names{"many-p1", "one-1", "many-q1", "one-2", "many-r1", "many-p2", "many-q2", "many-r2"});
}

TEST_CASE("A higher priority overtakes") {
    Stalled stalled;
    stalled.post("low", {"a", Priority::low});
    stalled.post("normal", {"a", Priority::normal});
    stalled.post("high", {"b", Priority::high});

    CHECK(stalled.order() == Names{"high", "normal", "low"});
}

TEST_CASE("What was passed over often enough goes next") {
    Stalled stalled;
    stalled.post("low", {"a", Priority::low});
    stalled.post("normal", {"a", Priority::normal});
    for (int n = 0; n < 2 * WorkerPool::most_passes; ++n) stalled.post("high", {"b", Priority::high});

    Names expected(WorkerPool::most_passes, "high");
    expected.insert(expected.end(), {"low", "normal"});
    expected.insert(expected.end(), WorkerPool::most_passes, "high");
    CHECK(stalled.order() == expected);
}

TEST_CASE("What was abandoned is dropped with what it holds, and the rest is run") {
    Stalled stalled;
    const auto held = std::make_shared<int>(1);
    bool abandoned = false;
    stalled.pool.post({"a", Priority::normal, [&] { return abandoned; }}, [held] {});
    stalled.post("kept", {"a", Priority::normal, [] { return false; }});

    stalled.pool.drop_abandoned();
    CHECK(stalled.pool.waiting() == 2);
    abandoned = true;
    stalled.pool.drop_abandoned();
    CHECK(stalled.pool.waiting() == 1);
    CHECK(held.use_count() == 1);
    CHECK(stalled.order() == Names{"kept"});
}

TEST_CASE("Threads that look for work before they sleep do all of it, and end when they are told") {
    WorkerPool pool(2, std::chrono::seconds(1));
    std::atomic<int> done = 0;
    for (int n = 0; n < 100; ++n) {
        pool.post({}, [&] { ++done; });
        if (n % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    while (done < 100) std::this_thread::yield();
    pool.stop();
    CHECK(done == 100);
    CHECK(pool.running() == 0);
}

TEST_CASE("Large tasks leave a thread to small ones") {
    WorkerPool pool(3);
    std::promise<void> go_on;
    const auto gate = go_on.get_future().share();
    std::atomic<int> large = 0;
    for (int n = 0; n < 5; ++n)
        pool.post({.client = std::to_string(n), .is_large = true}, [&, gate] {
            ++large;
            gate.wait();
        });
    while (large < 2) std::this_thread::yield();
    std::promise<void> small;
    pool.post({.client = "other"}, [&] { small.set_value(); });
    small.get_future().wait();
    CHECK(large == 2);
    CHECK(pool.running() <= 3);
    CHECK(pool.waiting() == 3);
    go_on.set_value();
    while (large < 5) std::this_thread::yield();
}

TEST_CASE("The only thread takes large tasks, too") {
    WorkerPool pool(1);
    std::promise<void> ran;
    pool.post({.client = "a", .is_large = true}, [&] { ran.set_value(); });
    ran.get_future().wait();
}

TEST_CASE("What a client sent behind a large task begins after it") {
    WorkerPool pool(2);
    std::promise<void> go_on;
    const auto gate = go_on.get_future().share();
    std::atomic<bool> first_began = false, second_began = false, third_began = false;
    pool.post({.client = "a", .is_large = true}, [&, gate] {
        first_began = true;
        gate.wait();
    });
    while (!first_began) std::this_thread::yield();
    pool.post({.client = "b", .is_large = true}, [&] { second_began = true; });
    pool.post({.client = "b"}, [&] { third_began = true; });
    std::promise<void> other;
    pool.post({.client = "c"}, [&] { other.set_value(); });
    other.get_future().wait();
    CHECK_FALSE(second_began);
    CHECK_FALSE(third_began);
    go_on.set_value();
    while (!second_began || !third_began) std::this_thread::yield();
}

TEST_CASE("Each thread that there is runs an idle task once") {
    WorkerPool pool(3);
    std::promise<void> go_on;
    const auto gate = go_on.get_future().share();
    std::atomic<int> began = 0, idle = 0;
    for (int n = 0; n < 2; ++n)
        pool.post({}, [&, gate] {
            ++began;
            gate.wait();
        });
    while (began < 2) std::this_thread::yield();
    pool.each_when_idle([&] { ++idle; });
    CHECK(idle == 0);
    CHECK(pool.running() == 2);
    go_on.set_value();
    while (idle < 2) std::this_thread::yield();
    std::promise<void> ran;
    pool.post({}, [&] { ran.set_value(); });
    ran.get_future().wait();
    CHECK(idle == 2);
}

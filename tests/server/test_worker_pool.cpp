#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <future>

#include "worker_pool.hpp"

using contactd::server::WorkerPool;

TEST_CASE("Every task that was posted is run") {
    std::atomic<int> ran = 0;
    std::promise<void> last;
    WorkerPool pool(3);
    for (int n = 0; n < 100; ++n)
        pool.post([&] {
            if (++ran == 100) last.set_value();
        });

    last.get_future().wait();
    CHECK(ran == 100);
}

TEST_CASE("Stopping waits for the running task, drops the waiting ones and what they hold") {
    WorkerPool pool(1);
    std::promise<void> begun, go_on;
    std::atomic<bool> ended = false, dropped_ran = false;
    const auto held = std::make_shared<int>(1);
    pool.post([&] {
        begun.set_value();
        go_on.get_future().wait();
        ended = true;
    });
    begun.get_future().wait();
    pool.post([&, held] { dropped_ran = true; });
    CHECK(pool.running() == 1);
    CHECK(pool.waiting() == 1);

    auto stopping = std::async(std::launch::async, [&] { pool.stop(); });
    while (pool.waiting() > 0) std::this_thread::yield();
    go_on.set_value();
    stopping.wait();

    CHECK(ended);
    CHECK_FALSE(dropped_ran);
    CHECK(held.use_count() == 1);
    pool.post([&] { dropped_ran = true; });  // after the end: ignored
    CHECK_FALSE(dropped_ran);
}

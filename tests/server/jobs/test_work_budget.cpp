#include <catch2/catch_test_macros.hpp>
#include <future>
#include <mutex>
#include <string>
#include <vector>

#include "jobs/work_budget.hpp"

using namespace contactd::server;

namespace {

const contactd::MessageLimits limits;

CallPtr call_of(const std::string& client) {
    return std::make_shared<Call>(Route{client}, contactd::proto::Request{}, Call::Clock::now(),
                                  contactd::proto::Priority::normal, limits, [](const Answer&) {});
}

/// Records pieces of work by their names, in the order in which they began.
struct Begun {
    std::vector<std::string> names{};
    std::mutex mutex{};

    std::function<void()> work(const std::string& name) {
        return [this, name] {
            const std::scoped_lock lock(mutex);
            names.push_back(name);
        };
    }
    std::vector<std::string> all() {
        const std::scoped_lock lock(mutex);
        return names;
    }
};

/// Returns after all tasks given to a pool of one thread so far are done.
void finish(WorkerPool& pool) {
    std::promise<void> done;
    pool.post({"last", contactd::proto::Priority::low}, [&] { done.set_value(); });
    done.get_future().wait();
}

}  // namespace

TEST_CASE("Work begins at once where it fits, and otherwise when others have given back what they held") {
    Begun begun;
    WorkerPool pool(1);
    WorkBudget budget(1000, pool);
    CallPtr first = call_of("a"), second = call_of("b"), third = call_of("c");
    budget.enter(first, 600, begun.work("first"));
    budget.enter(second, 600, begun.work("second"));
    budget.enter(third, 300, begun.work("third"));  // it would fit, but waits behind the second one
    CHECK(begun.all() == std::vector<std::string>{"first"});
    CHECK(budget.bytes() == 600);
    CHECK(budget.waiting() == 2);
    first.reset();
    finish(pool);
    CHECK(begun.all() == std::vector<std::string>{"first", "second", "third"});
    CHECK(budget.bytes() == 900);
    second->work.reset();
    third.reset();
    CHECK(budget.bytes() == 0);
    pool.stop();
}

TEST_CASE("Small work goes before what does not fit yet") {
    Begun begun;
    WorkerPool pool(1);
    WorkBudget budget(1000, pool);
    const CallPtr first = call_of("a"), large = call_of("b"), small = call_of("c");
    budget.enter(first, 600, begun.work("first"));
    budget.enter(large, 600, begun.work("large"));
    budget.enter(small, 10, begun.work("small"));
    CHECK(begun.all() == std::vector<std::string>{"first", "small"});
    budget.close();
}

TEST_CASE("Answers that wait to be sent count, and never keep work alone from beginning") {
    Begun begun;
    WorkerPool pool(1);
    WorkBudget budget(1000, pool);
    auto answer = budget.count(900);
    CallPtr alone = call_of("a"), other = call_of("b");
    budget.enter(alone, 800, begun.work("alone"));
    budget.enter(other, 200, begun.work("other"));
    CHECK(begun.all() == std::vector<std::string>{"alone"});
    CHECK(budget.bytes() == 1700);
    answer.reset();
    finish(pool);
    CHECK(begun.all() == std::vector<std::string>{"alone", "other"});
    pool.stop();
}

TEST_CASE("Of a client's batches one is under way at a time, and others' go on") {
    Begun begun;
    WorkerPool pool(1);
    WorkBudget budget(1000, pool);
    CallPtr first = call_of("a");
    const CallPtr second = call_of("a"), third = call_of("b");
    budget.enter(first, 100, begun.work("first"), true);
    budget.enter(second, 100, begun.work("second"), true);
    budget.enter(third, 100, begun.work("third"), true);
    CHECK(begun.all() == std::vector<std::string>{"first", "third"});
    first.reset();
    finish(pool);
    CHECK(begun.all() == std::vector<std::string>{"first", "third", "second"});
    pool.stop();
}

TEST_CASE("Work of calls that were answered is forgotten while it waits") {
    Begun begun;
    WorkerPool pool(1);
    WorkBudget budget(1000, pool);
    CallPtr first = call_of("a");
    const CallPtr second = call_of("b");
    budget.enter(first, 600, begun.work("first"));
    budget.enter(second, 600, begun.work("second"));
    second->fail({});
    budget.drop_abandoned();
    CHECK(budget.waiting() == 0);
    first.reset();
    finish(pool);
    CHECK(begun.all() == std::vector<std::string>{"first"});
    pool.stop();
}

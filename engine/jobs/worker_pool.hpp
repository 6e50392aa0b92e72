// Runs tasks in a bounded number of threads, with a queue in which clients take turns.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "contactd/proto/message.hpp"

namespace contactd::engine {

/// Holds the owner and the priority of a task.
struct QueueTicket {
    std::string client;
    proto::Priority priority = proto::Priority::normal;
    std::function<bool()> abandoned{};  ///< returns whether the task is abandoned; called under the pool's lock
    std::string user{};                 ///< the user of the client, which may have several clients
    bool is_large = false;              ///< runs so long that one thread must stay free of such tasks
};

/// Tasks of a higher priority go first. Within a priority, users take turns, and so do the clients of a user. To
/// prevent starvation, a priority that was passed over `most_passes` times while it had tasks goes next. If there are
/// several threads, large tasks never occupy all of them, so a small task waits for other small ones only. Tasks of one
/// client begin in the order of arrival.
class WorkerPool {
   public:
    using Task = std::function<void()>;  ///< must not throw
    static constexpr int most_passes = 16;

    /// Threads start when they are first needed. A thread that has finished a task polls for another one for the time
    /// `spin` before it sleeps.
    explicit WorkerPool(int threads, std::chrono::microseconds spin = {});
    /// Drops tasks that have not begun, and waits for running ones.
    ~WorkerPool();

    void post(QueueTicket ticket, Task task);
    /// Drops abandoned waiting tasks and their resources.
    void drop_abandoned();
    /// Lets each existing thread run `task` once, as soon as it is idle.
    void each_when_idle(Task task);
    void stop();  ///< Does the same as the destructor; may be called before it.

    int waiting() const;
    int running() const;

   private:
    struct Waiting {
        Task task;
        std::function<bool()> abandoned;
        bool is_large;
    };
    template <class Part>
    struct Line {
        std::string name;
        std::deque<Part> parts;  // never empty; the one at the front is the next
    };
    using Client = Line<Waiting>;
    using User = Line<Client>;
    struct Level {
        std::deque<User> users;
        int passed_over = 0;
    };
    using Levels = std::array<Level, 3>;  // by priority, the highest first

    template <class Part>
    static Line<Part>& line_of(std::deque<Line<Part>>& lines, std::string name);
    template <class Part, class Take>
    Waiting take_round_robin(std::deque<Line<Part>>& lines, const Take& take) const;

    bool may_begin(const Waiting& task) const { return !task.is_large || running_large_ < most_large_; }
    bool may_begin(const Client& client) const { return may_begin(client.parts.front()); }
    bool may_begin(const User& user) const;
    bool may_begin(const Level& level) const;
    bool any_may_begin() const;
    void work();
    void spin() const;
    Level& next_level();
    Waiting take_next();

    const std::size_t most_;  // threads
    const int most_large_;    // number of large tasks at a time
    const std::chrono::microseconds spin_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    Levels levels_;
    Task idle_task_;                // of each thread
    std::size_t idle_tasks_ = 0;    // so far
    std::atomic<int> waiting_ = 0;  // changed under the lock, as stopping_
    int running_ = 0, running_large_ = 0;
    std::atomic<bool> stopping_ = false;
    std::vector<std::jthread> threads_;  // added to under the lock
};

}  // namespace contactd::engine

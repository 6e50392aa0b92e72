// A fixed number of threads and a queue of tasks.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace contactd::server {

class WorkerPool {
   public:
    using Task = std::function<void()>;  ///< must not throw

    explicit WorkerPool(int threads);
    /// Tasks that have not begun are dropped; running ones are waited for.
    ~WorkerPool();

    void post(Task task);
    void stop();  ///< what the destructor does; may be called before it

    int waiting() const;
    int running() const;

   private:
    void work();

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Task> tasks_;
    int running_ = 0;
    bool stopping_ = false;
    std::vector<std::jthread> threads_;
};

}  // namespace contactd::server

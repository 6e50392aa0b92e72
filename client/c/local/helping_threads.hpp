// Provides threads that help callers with many tasks, and wait in between.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

namespace contactd::c {

/// Threads and their memory persist between calls. Any number of callers may use them at a time.
class HelpingThreads {
   public:
    HelpingThreads() = default;
    HelpingThreads(const HelpingThreads&) = delete;
    HelpingThreads& operator=(const HelpingThreads&) = delete;
    ~HelpingThreads();

    /// Calls `act` for 0 to count - 1, started in this order, in this thread and up to `threads` - 1 others. `act` must
    /// not throw. If no more threads can be created, the existing ones do all the work.
    void share(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& act);

   private:
    struct Work;
    void make(std::size_t count);
    void help();
    void leave_to_parent();

    std::mutex mutex_;  // guards the members below
    std::condition_variable called_, left_;
    std::list<Work*> works_;  // that take more helpers
    std::vector<std::thread> threads_;
    bool ends_ = false;
    int generation_ = 0;  // process that created the threads
};

}  // namespace contactd::c

// Threads that help callers with many pieces of work, and wait in between.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

namespace contactd::c {

/// They keep their memory from call to call, and need not be made for each. Any number of callers at a time.
class HelpingThreads {
   public:
    HelpingThreads() = default;
    HelpingThreads(const HelpingThreads&) = delete;
    HelpingThreads& operator=(const HelpingThreads&) = delete;
    ~HelpingThreads();

    /// Calls `act` for 0 to count - 1, begun in this order, in this thread and in up to `threads` - 1 others. `act`
    /// must not throw. Where there are no more threads, those that are here do all of it.
    void share(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& act);

   private:
    struct Work;
    void make(std::size_t count);
    void help();
    void leave_to_parent();

    std::mutex mutex_;  // guards what follows
    std::condition_variable called_, left_;
    std::list<Work*> works_;  // that take more helpers
    std::vector<std::thread> threads_;
    bool ends_ = false;
    int generation_ = 0;  // of the process that the threads are in
};

}  // namespace contactd::c

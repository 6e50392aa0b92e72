// Memory that work has given back goes to the system, once the daemon is quiet.
#pragma once

#include <chrono>
#include <cstddef>

#include "jobs/work_budget.hpp"

namespace contactd::server {

/// The allocator keeps what was freed for the arrays of the next solve, which saves solves the time of new pages.
/// Behind a burst it would keep the most that was ever needed. So when there was no work for a moment, a worker gives
/// everything that is free back, and does so again some seconds later. Used by one thread.
class MemoryReturn {
   public:
    using Clock = std::chrono::steady_clock;

    MemoryReturn(const WorkBudget& budget, WorkerPool& workers) : budget_(budget), workers_(workers) {}

    /// Other threads that take memory, beside the workers and the one that looks.
    void add(WorkerPool& others) { others_ = &others; }

    /// Gives memory back when it is time. `is_busy`: workers have something to do; `kept` are the bytes of what
    /// outlives requests, as sessions.
    void look(Clock::time_point now, bool is_busy, std::size_t kept);
    /// When it wants to look again, since work ends without a word to the thread that looks.
    Clock::time_point next_look() const { return next_; }

   private:
    const WorkBudget& budget_;
    WorkerPool& workers_;
    WorkerPool* others_ = nullptr;
    double freed_ = 0;      // bytes, since memory was last given back
    double seen_ = 0;       // of the budget's bytes so far
    std::size_t kept_ = 0;  // at the last look
    Clock::time_point next_ = Clock::time_point::max();
    Clock::time_point quiet_since_ = Clock::time_point::max();
    Clock::time_point again_ = Clock::time_point::max();  // after memory was given back
    std::size_t times_again_ = 0;
};

}  // namespace contactd::server

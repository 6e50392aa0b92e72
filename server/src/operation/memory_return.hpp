// Returns freed memory to the system once the daemon is idle.
#pragma once

#include <chrono>
#include <cstddef>

#include "jobs/work_budget.hpp"

namespace contactd::server {

/// The allocator keeps freed memory for the arrays of the next solve, which avoids the cost of new pages. After a burst
/// it would keep the largest amount ever needed. Therefore a worker returns all free memory after a moment without
/// work, and again some seconds later. Used by one thread.
class MemoryReturn {
   public:
    using Clock = std::chrono::steady_clock;

    MemoryReturn(const WorkBudget& budget, WorkerPool& workers) : budget_(budget), workers_(workers) {}

    /// Number of other threads that allocate memory, in addition to the workers and the calling thread.
    void add(WorkerPool& others) { others_ = &others; }

    /// Returns memory to the system if it is time. `is_busy`: workers have work; `kept`: bytes that outlive requests,
    /// such as sessions.
    void look(Clock::time_point now, bool is_busy, std::size_t kept);
    /// Returns the time of the next check, because the calling thread is not notified of the end of work.
    Clock::time_point next_look() const { return next_; }

   private:
    const WorkBudget& budget_;
    WorkerPool& workers_;
    WorkerPool* others_ = nullptr;
    double freed_ = 0;      // bytes freed since memory was last returned
    double seen_ = 0;       // bytes of the budget counted so far
    std::size_t kept_ = 0;  // at the last look
    Clock::time_point next_ = Clock::time_point::max();
    Clock::time_point quiet_since_ = Clock::time_point::max();
    Clock::time_point again_ = Clock::time_point::max();  // checks after memory was returned
    std::size_t times_again_ = 0;
};

}  // namespace contactd::server

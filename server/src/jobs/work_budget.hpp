// The memory of work that is under way, counted before the work begins.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "call.hpp"

namespace contactd::server {

/// The expected cost of a request, from its arguments.
struct WorkCost {
    double bytes = 0;    ///< of memory when it takes most, its answer included
    double seconds = 0;  ///< of a processor, an estimate by the products that it takes
};

/// Work begins when it fits beside what is under way and beside the answers that wait to be sent; until then it waits,
/// in the order of arrival. What is small may go before what does not fit yet. Work alone always fits, so that clients
/// that do not read their answers slow others down and never stop them. Thread-safe.
class WorkBudget {
   public:
    WorkBudget(std::size_t bytes, WorkerPool& workers);
    ~WorkBudget();
    WorkBudget(const WorkBudget&) = delete;
    WorkBudget& operator=(const WorkBudget&) = delete;

    /// Runs `work` now when it fits, otherwise later, in a worker, by the ticket of its call. The call holds the bytes
    /// until it goes, or until its `work` is reset. `one_at_a_time`: only when no other such work of the same client is
    /// under way.
    void enter(const CallPtr& call, double bytes, std::function<void()> work, bool one_at_a_time = false);
    /// Counts what is there in any case; given back when the last copy of the result goes.
    std::shared_ptr<const void> count(double bytes);
    /// Forgets the waiting work of calls that were answered.
    void drop_abandoned();
    /// Forgets what waits; nothing waits from now on. To be called before the workers go.
    void close();

    std::size_t bytes() const;  ///< that are counted now
    struct Use {
        double under_way;  ///< bytes of work, without those that are there in any case
        double so_far;     ///< bytes of all work that has ended, and of all that was counted
    };
    Use use() const;
    std::size_t waiting() const;  ///< pieces of work

   private:
    struct State;
    std::shared_ptr<State> state_;  // outlived by what is counted
};

}  // namespace contactd::server

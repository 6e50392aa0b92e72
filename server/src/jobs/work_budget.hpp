// Limits the memory of running work, counted before the work begins.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "call.hpp"

namespace contactd::server {

/// Holds the expected cost of a request, computed from its arguments.
struct WorkCost {
    double bytes = 0;    ///< largest memory, including the answer
    double seconds = 0;  ///< processor time, estimated from the number of products
};

/// Work begins when it fits beside the running work and the answers waiting to be sent. Until then it waits, in the
/// order of arrival. Small work may overtake work that does not fit yet. A single piece of work always fits, so clients
/// that do not read their answers slow others down but never block them. Thread-safe.
class WorkBudget {
   public:
    WorkBudget(std::size_t bytes, WorkerPool& workers);
    ~WorkBudget();
    WorkBudget(const WorkBudget&) = delete;
    WorkBudget& operator=(const WorkBudget&) = delete;

    /// Runs `work` now if it fits, otherwise later, in a worker, with the ticket of its call. The call holds the bytes
    /// until it is destroyed or its `work` is reset. `one_at_a_time`: only if no other such work of the same client is
    /// running.
    void enter(const CallPtr& call, double bytes, std::function<void()> work, bool one_at_a_time = false);
    /// Counts memory that is in use anyway; released with the last copy of the result.
    std::shared_ptr<const void> count(double bytes);
    /// Drops the waiting work of answered calls.
    void drop_abandoned();
    /// Drops all waiting work; no work waits from now on. Must be called before the workers are destroyed.
    void close();

    std::size_t bytes() const;  ///< that are counted now
    struct Use {
        double under_way;  ///< bytes of work, without bytes that are used in any case
        double so_far;     ///< bytes of all ended work and of everything counted
    };
    Use use() const;
    std::size_t waiting() const;  ///< pieces of work

   private:
    struct State;
    std::shared_ptr<State> state_;  // must outlive everything counted
};

}  // namespace contactd::server

// Shares the check of a message with many members among the threads that process them.
#pragma once

#include <atomic>
#include <functional>
#include <latch>
#include <mutex>

#include "contactd/proto/schema.hpp"
#include "jobs/call.hpp"

namespace contactd::server {

/// Work on a message begins only after the whole message has been checked. A check takes as long as a small solve, so
/// the threads share it.
class SharedCheck {
   public:
    /// Runs `conclude` once, in one thread, after the params have passed their schema. An exception refuses the call.
    SharedCheck(CallPtr call, std::function<void()> conclude);

    /// Checks members until none are left, and waits for those of other threads. Returns false if the call was refused.
    bool passed();

   private:
    void check_members();
    void conclude();

    const CallPtr call_;
    const std::function<void()> conclude_;
    const proto::ListCheck members_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> violated_;
    std::latch checked_;
    std::once_flag concluded_{};
    std::atomic<bool> refused_ = false;
};

}  // namespace contactd::server

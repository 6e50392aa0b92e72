// The check of a message with many members by all threads that come for one of them.
#pragma once

#include <atomic>
#include <functional>
#include <latch>
#include <mutex>

#include "contactd/proto/schema.hpp"
#include "jobs/call.hpp"

namespace contactd::server {

/// Nothing of a message is done before all of it was seen to conform. Checking takes as long as a small solve: so the
/// threads that come share it.
class SharedCheck {
   public:
    /// `conclude` runs once, in one thread, when the params have passed their schema; what it throws refuses the call.
    SharedCheck(CallPtr call, std::function<void()> conclude);

    /// Checks members until there are none left, and waits for those of other threads. False when the call has been
    /// refused, which it is then.
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

// Ensures one user of a contact or a wheel at a time.
#pragma once

#include <atomic>

#include "failure.hpp"

namespace contactd::c {

/// Returns the number of forks between this process and the one that loaded the library, plus one. It replaces getpid,
/// which costs more than all other parts of a setter.
int generation() noexcept;

/// Holds `user` during its lifetime: a generation, negative after a cancellation, 0 without a user. Throws
/// StatusError (CONCURRENT_USE) if another thread of this process holds it. A copy by a fork of the parent's user
/// holds nothing.
class HandleGuard {
   public:
    explicit HandleGuard(std::atomic<int>& user) : user_(user) {
        const int self = generation();
        int holder = user_.load();
        do {
            if (holder == self || holder == -self)
                throw StatusError(
                    StatusCode::failed_precondition, concurrent_use,
                    "Another call of this contact or wheel is running, in another thread or in the call that reports "
                    "to this callback. That call continues. Use a separate handle in each thread.");
        } while (!user_.compare_exchange_weak(holder, self));
    }
    ~HandleGuard() { user_.store(0); }
    HandleGuard(const HandleGuard&) = delete;
    HandleGuard& operator=(const HandleGuard&) = delete;

    /// Cancels the current use, if any, until its end, from any thread.
    static void cancel(std::atomic<int>& user) noexcept {
        int holder = generation();
        user.compare_exchange_strong(holder, -holder);
    }
    static bool is_cancelled(const std::atomic<int>& user) noexcept { return user.load() == -generation(); }

   private:
    std::atomic<int>& user_;
};

}  // namespace contactd::c

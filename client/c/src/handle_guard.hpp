// One user of a contact or a wheel at a time.
#pragma once

#include <atomic>

#include "failure.hpp"

namespace contactd::c {

/// How many forks this process is away from the one that loaded the library, and one: what a call of getpid tells, too,
/// and costs more than all the rest of a setter.
int generation() noexcept;

/// Holds `user` while it lives: a generation, negative once the turn is cancelled, 0 for nobody. Throws StatusError
/// (CONCURRENT_USE) when somebody of this process does already; what a fork copied of a holder in the parent holds
/// nothing.
class HandleGuard {
   public:
    explicit HandleGuard(std::atomic<int>& user) : user_(user) {
        const int self = generation();
        int holder = user_.load();
        do {
            if (holder == self || holder == -self)
                throw StatusError(
                    StatusCode::failed_precondition, concurrent_use,
                    "Another call of this contact or wheel runs, in another thread or in whose log this is; the "
                    "one that runs goes on. Use one for each thread.");
        } while (!user_.compare_exchange_weak(holder, self));
    }
    ~HandleGuard() { user_.store(0); }
    HandleGuard(const HandleGuard&) = delete;
    HandleGuard& operator=(const HandleGuard&) = delete;

    /// From any thread: the turn that is held, if there is one, until its end.
    static void cancel(std::atomic<int>& user) noexcept {
        int holder = generation();
        user.compare_exchange_strong(holder, -holder);
    }
    static bool is_cancelled(const std::atomic<int>& user) noexcept { return user.load() == -generation(); }

   private:
    std::atomic<int>& user_;
};

}  // namespace contactd::c

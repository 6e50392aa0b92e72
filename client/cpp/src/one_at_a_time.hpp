// One user at a time, by the process that it runs in.
#pragma once

#include <unistd.h>

#include <atomic>
#include <string>

#include "contactd/client/errors.hpp"

namespace contactd::client {

/// Holds `user` (a process id, 0 for nobody) while it lives. Throws ConcurrencyError with `why` when somebody of this
/// process does already; what a fork copied of a holder in the parent holds nothing.
class OneAtATime {
   public:
    OneAtATime(std::atomic<int>& user, const std::string& why) : user_(user) {
        const int self = ::getpid();
        int holder = user_.load();
        do {
            if (holder == self) throw ConcurrencyError(why);
        } while (!user_.compare_exchange_weak(holder, self));
    }
    ~OneAtATime() { user_.store(0); }
    OneAtATime(const OneAtATime&) = delete;
    OneAtATime& operator=(const OneAtATime&) = delete;

   private:
    std::atomic<int>& user_;
};

}  // namespace contactd::client

// Ensures one user at a time within a process.
#pragma once

#include <unistd.h>

#include <atomic>
#include <string>

#include "contactd/client/errors.hpp"

namespace contactd::client {

/// Holds `user` (a process ID, 0 without a user) during its lifetime. Throws ConcurrencyError with `why` if this
/// process already holds it. A copy by a fork of the parent's user holds nothing.
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

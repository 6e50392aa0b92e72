// Limits the requests of each user by a token bucket.
#pragma once

#include <chrono>
#include <map>
#include <string>

#include "contactd/proto/status.hpp"

namespace contactd::server {

/// Belongs to one thread. Users whose bucket is full again are removed.
class RateLimit {
   public:
    using Clock = std::chrono::steady_clock;

    /// Adds `per_second` tokens each second, up to `burst`. 0: no limit.
    RateLimit(double per_second, int burst) : per_second_(per_second), burst_(burst) {}

    /// Takes a token. Returns zero if there was one, otherwise the time until there is one.
    std::chrono::milliseconds take(const std::string& user, Clock::time_point now);

    /// Returns the answer to a client that has to wait.
    proto::Status refusal(std::chrono::milliseconds wait) const;
    /// Returns the number of stored users.
    std::size_t users() const { return buckets_.size(); }

   private:
    struct Bucket {
        double tokens;
        Clock::time_point at;
    };
    double tokens_at(const Bucket& bucket, Clock::time_point now) const;
    void forget_idle(Clock::time_point now);

    const double per_second_;
    const double burst_;
    std::map<std::string, Bucket> buckets_;
    std::size_t forget_at_ = 1024;  // number of users at which idle ones are removed
};

}  // namespace contactd::server

// How many requests a user may send: a token bucket for each.
#pragma once

#include <chrono>
#include <map>
#include <string>

#include "contactd/proto/status.hpp"

namespace contactd::server {

/// Belongs to one thread. Users who have not asked for long enough to have a full bucket again are forgotten.
class RateLimit {
   public:
    using Clock = std::chrono::steady_clock;

    /// `per_second` tokens come back each second, up to `burst`. 0: no limit.
    RateLimit(double per_second, int burst) : per_second_(per_second), burst_(burst) {}

    /// Takes a token. Zero when there was one, else the time until there is.
    std::chrono::milliseconds take(const std::string& user, Clock::time_point now);

    /// The answer to a client that has to wait.
    proto::Status refusal(std::chrono::milliseconds wait) const;
    /// Users who are remembered.
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
    std::size_t forget_at_ = 1024;  // users, when those who are idle are looked for
};

}  // namespace contactd::server

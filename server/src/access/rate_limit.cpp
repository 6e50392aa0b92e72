#include "rate_limit.hpp"

#include <algorithm>
#include <cmath>

#include "contactd/proto/message.hpp"

namespace contactd::server {

double RateLimit::tokens_at(const Bucket& bucket, Clock::time_point now) const {
    const std::chrono::duration<double> passed = now - bucket.at;
    return std::min(burst_, bucket.tokens + passed.count() * per_second_);
}

std::chrono::milliseconds RateLimit::take(const std::string& user, Clock::time_point now) {
    if (per_second_ <= 0) return std::chrono::milliseconds{0};
    if (buckets_.size() >= forget_at_) forget_idle(now);
    Bucket& bucket = buckets_.try_emplace(user, Bucket{burst_, now}).first->second;
    bucket = {tokens_at(bucket, now), now};
    if (bucket.tokens >= 1) {
        bucket.tokens -= 1;
        return std::chrono::milliseconds{0};
    }
    const double seconds = (1 - bucket.tokens) / per_second_;
    return std::chrono::milliseconds{static_cast<long>(std::ceil(std::min(1000 * seconds, 86'400'000.0)))};
}

proto::Status RateLimit::refusal(std::chrono::milliseconds wait) const {
    return {proto::StatusCode::resource_exhausted,
            "You send more than " + proto::dump(per_second_) +
                " requests a second (security.per_user.requests_per_second); try again in " +
                std::to_string(wait.count()) + " ms.",
            std::string(proto::reason::rate_limited),
            {},
            static_cast<int>(wait.count())};
}

void RateLimit::forget_idle(Clock::time_point now) {
    std::erase_if(buckets_, [&](const auto& entry) { return tokens_at(entry.second, now) >= burst_; });
    forget_at_ = std::max<std::size_t>(1024, 2 * buckets_.size());
}

}  // namespace contactd::server

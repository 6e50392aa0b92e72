// Counts of the daemon since it started, beside those of its engine; shown by server.info and among the metrics.
#pragma once

#include <atomic>

namespace contactd::server {

struct Counters {
    using Count = std::atomic<long long>;
    Count requests = 0;
    Count requests_failed = 0;
    Count solves = 0;

    // These have the values of now.
    Count connections = 0;
    Count outbox_bytes = 0;
    Count open_requests = 0;
};

}  // namespace contactd::server

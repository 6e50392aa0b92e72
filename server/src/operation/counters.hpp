// What the daemon has done since it started, beside its engine; shown by server.info and among the metrics.
#pragma once

#include <atomic>

namespace contactd::server {

struct Counters {
    using Count = std::atomic<long long>;
    Count requests = 0;
    Count requests_failed = 0;
    Count solves = 0;

    // What is the case now.
    Count connections = 0;
    Count outbox_bytes = 0;
    Count open_requests = 0;
};

}  // namespace contactd::server

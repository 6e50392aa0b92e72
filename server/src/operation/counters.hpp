// Counts events of the daemon since its start, in addition to those of its engine; reported by server.info and as
// metrics.
#pragma once

#include <atomic>

namespace contactd::server {

struct Counters {
    using Count = std::atomic<long long>;
    Count requests = 0;
    Count requests_failed = 0;
    Count solves = 0;

    // Current values.
    Count connections = 0;
    Count outbox_bytes = 0;
    Count open_requests = 0;
};

}  // namespace contactd::server

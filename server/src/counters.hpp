// What the daemon has done since it started; shown by server.info.
#pragma once

#include <atomic>

namespace contactd::server {

struct Counters {
    using Count = std::atomic<long long>;
    Count requests = 0;
    Count requests_failed = 0;
    Count solves = 0;
    Count builds_started = 0;
    Count builds_finished = 0;
    Count builds_failed = 0;
    Count builds_cancelled = 0;
    Count builds_joined = 0;
    Count memory_hits = 0;
    Count disk_hits = 0;
    Count closed_form = 0;
    Count tables_set_aside = 0;
};

}  // namespace contactd::server

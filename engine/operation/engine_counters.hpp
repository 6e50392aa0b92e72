// Counts an engine's work since its creation.
#pragma once

#include <atomic>

namespace contactd::engine {

struct EngineCounters {
    using Count = std::atomic<long long>;
    Count builds_started = 0;
    Count builds_finished = 0;
    Count builds_failed = 0;
    Count builds_cancelled = 0;
    Count builds_joined = 0;
    Count memory_hits = 0;
    Count disk_hits = 0;
    Count closed_form = 0;
    Count tables_set_aside = 0;
    Count solves_converged = 0;
    Count solves_not_converged = 0;
    Count normal_iterations = 0;
    Count tangential_iterations = 0;
    Count build_milliseconds = 0;

    // Current values.
    Count store_tables = 0;
    Count store_bytes = 0;
};

}  // namespace contactd::engine

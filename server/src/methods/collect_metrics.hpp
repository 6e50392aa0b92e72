// Collects all metrics of the daemon in one list.
#pragma once

#include "daemon_parts.hpp"

namespace contactd::server {

/// Can be called from any thread. `look_at_store` counts the files of the store, which is slow for many files.
MetricFamilies collect_metrics(const DaemonParts& parts, bool look_at_store);

}  // namespace contactd::server

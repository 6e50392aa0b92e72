// Everything the daemon counts and measures, in one list.
#pragma once

#include "daemon_parts.hpp"

namespace contactd::server {

/// From any thread; `look_at_store` counts the files of the store, which takes its time when there are many.
MetricFamilies collect_metrics(const DaemonParts& parts, bool look_at_store);

}  // namespace contactd::server

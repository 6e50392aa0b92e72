// ic.export: fetch the coefficients of one body or of two, then make a file of them on a worker.
#pragma once

#include "daemon_parts.hpp"

namespace contactd::server {

/// Throws StatusError for bad parameters, and for a text of more than limits.max_frame_bytes.
void export_table(const CallPtr& call, const DaemonParts& parts);

}  // namespace contactd::server

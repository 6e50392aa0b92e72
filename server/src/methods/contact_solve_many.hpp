// contact.solve_many: several problems of one call, on all workers.
#pragma once

#include "daemon_parts.hpp"

namespace contactd::server {

/// Answers `call` when all solves have ended; what cannot be solved fails alone. As many of them as there are workers
/// run at a time, so that other requests get their turn in between.
void solve_many(const CallPtr& call, const DaemonParts& parts);

}  // namespace contactd::server

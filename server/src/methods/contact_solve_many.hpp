// contact.solve_many: several problems of one call, on all workers.
#pragma once

#include "daemon_parts.hpp"

namespace contactd::server {

/// From the I/O thread: answers `call` when all solves have ended; what cannot be solved fails alone. Each problem is
/// decoded, solved and encoded by the worker that takes it. As many as there are workers are on their way at a time,
/// so that other requests run in between.
void queue_problems(const CallPtr& call, const DaemonParts& parts);

}  // namespace contactd::server

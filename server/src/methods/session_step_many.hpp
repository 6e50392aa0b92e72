// session.step_many: steps of several sessions.
#pragma once

#include "daemon_parts.hpp"

namespace contactd::server {

/// From the I/O thread: queues each step in its session, and answers when all have run.
void queue_steps(const CallPtr& call, const DaemonParts& parts);

}  // namespace contactd::server

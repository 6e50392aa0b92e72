// session.step_many: steps of several sessions.
#pragma once

#include "daemon_parts.hpp"

namespace contactd::server {

/// From the I/O thread: gives each step its turn in its session, and answers when all have had it.
void queue_steps(const CallPtr& call, const DaemonParts& parts);

}  // namespace contactd::server

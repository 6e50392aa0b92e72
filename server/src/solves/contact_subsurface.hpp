// contact.subsurface: stresses inside a body.
#pragma once

#include "contactd/proto/message.hpp"
#include "jobs/call.hpp"
#include "jobs/job.hpp"

namespace contactd::server {

/// Computes in the calling thread, as a job that can be cancelled, and answers `call`. Throws for a bad request.
void answer_subsurface(const CallPtr& call, JobTable& jobs, const MessageLimits& limits);

}  // namespace contactd::server

// ic.list and ic.delete: what is in the store, and what must not stay there.
#pragma once

#include "ic_service.hpp"
#include "jobs/call.hpp"

namespace contactd::server {

/// Both throw StatusError for what cannot be done.
void answer_ic_list(const CallPtr& call, IcService& ics);
void answer_ic_delete(const CallPtr& call, IcService& ics);

}  // namespace contactd::server

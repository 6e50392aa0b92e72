// ic.list and ic.delete: what is in the store, and what must not stay there.
#pragma once

#include "daemon_parts.hpp"

namespace contactd::server {

/// Both throw StatusError for what cannot be done.
void list_tables(const CallPtr& call, const DaemonParts& parts);
void delete_tables(const CallPtr& call, const DaemonParts& parts);

}  // namespace contactd::server

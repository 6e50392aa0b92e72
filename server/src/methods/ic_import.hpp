// ic.import: a table of somebody's into the store.
#pragma once

#include "daemon_parts.hpp"

namespace contactd::server {

/// Throws InvalidArgument ("attributes...", "datasets...") for what is no table, or not what it claims to be.
void import_table(const CallPtr& call, const DaemonParts& parts);

}  // namespace contactd::server

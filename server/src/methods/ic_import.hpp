// ic.import: a file of ic.export, or of another store, into the store.
#pragma once

#include "daemon_parts.hpp"

namespace contactd::server {

/// Throws InvalidArgument ("file") for what is no such file, or a damaged one.
void import_table(const CallPtr& call, const DaemonParts& parts);

}  // namespace contactd::server

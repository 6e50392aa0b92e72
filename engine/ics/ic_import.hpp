// Stores tables that users have imported.
#pragma once

#include <string>

#include "contactd/ic_import.hpp"
#include "contactd/observer.hpp"
#include "engine/operation/engine_counters.hpp"
#include "ic_service.hpp"

namespace contactd::engine {

/// Returns the warning for every solution that uses the imported table with this key.
std::string imported_warning(const std::string& key);

/// Stores the record of an IC file as an import of `user`. A table that already serves this user is kept. Throws
/// InvalidArgument ("datasets") for records that stored_record() refuses, StoreError and Cancelled.
IcImport import_table(IcRecord record, IcService& tables, const std::string& user, EngineCounters& counters,
                      const Observer& observer);

}  // namespace contactd::engine

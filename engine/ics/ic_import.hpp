// Tables that somebody has brought.
#pragma once

#include <string>

#include "contactd/ic_import.hpp"
#include "contactd/observer.hpp"
#include "engine/operation/engine_counters.hpp"
#include "ic_service.hpp"

namespace contactd::engine {

/// Returns the warning of every solution that has used a table with this key.
std::string imported_warning(const std::string& key);

/// Keeps the record of an IC file in the store as the word of `user`. What this user is served already stays. Throws
/// InvalidArgument ("datasets") for what stored_record() refuses, StoreError and Cancelled.
IcImport import_table(IcRecord record, IcService& tables, const std::string& user, EngineCounters& counters,
                      const Observer& observer);

}  // namespace contactd::engine

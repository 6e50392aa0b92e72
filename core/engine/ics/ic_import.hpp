// Tables that come as files.
#pragma once

#include "contactd/ic_import.hpp"
#include "ic_service.hpp"

namespace contactd::engine {

/// Keeps the record of an IC file (from_ic_file) in the store as if it had been built here, with a warning that it was
/// not. A table that is there already stays. Throws InvalidArgument ("file") as stored_record, StoreError when the
/// store cannot be written to.
IcImport import_table(IcRecord record, IcService& tables, Counters& counters);

}  // namespace contactd::engine

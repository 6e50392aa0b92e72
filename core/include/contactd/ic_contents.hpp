// Converts a record of influence coefficients to the contents of a file and back.
#pragma once

#include "contactd/file_contents.hpp"
#include "contactd/ic_record.hpp"

namespace contactd {

/// Throws StoreError for tables that are not stored in files.
FileContents contents_of(const IcRecord& record);

/// Returns the record in the contents of a file. Throws DamagedTable if contactd did not write it, and
/// NewerFormat.
IcRecord record_from(FileContents contents);

}  // namespace contactd

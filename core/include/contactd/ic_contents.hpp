// A record of influence coefficients as the contents of a file, and back.
#pragma once

#include "contactd/file_contents.hpp"
#include "contactd/ic_record.hpp"

namespace contactd {

/// Throws StoreError for tables that are not kept in files.
FileContents contents_of(const IcRecord& record);

/// The record that a file holds, whoever has taken the file apart. Throws DamagedTable when it is none of ours, and
/// NewerFormat.
IcRecord record_from(FileContents contents);

}  // namespace contactd

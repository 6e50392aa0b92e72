// Tables that come back as files (to_ic_file, from_ic_file).
#pragma once

#include "contactd/ic_record.hpp"

namespace contactd {

/// What a store keeps of the record of an IC file: dimensionless. Throws InvalidArgument ("file") for what no builder
/// makes: tables of closed forms, of specs that cannot be, coefficients that no elastic body has, frames of columns
/// that are not those of the section. That the numbers are right nobody can know.
IcRecord stored_record(IcRecord record);

}  // namespace contactd

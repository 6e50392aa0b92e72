// Tables of strangers, before a store keeps them.
#pragma once

#include "contactd/ic_record.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Returns the record of an IC file as a store keeps it: dimensionless. Throws InvalidArgument ("datasets") for what no
/// builder makes: tables of closed forms, of specs that cannot be, tables that err by more than they state where a
/// closed form exists, coefficients that no elastic body has (sign, decay, reciprocity, positive definiteness), frames
/// of strips that are not those of the section. That the numbers are right otherwise nobody can know. Throws Cancelled.
IcRecord stored_record(IcRecord record, const Observer& observer);

}  // namespace contactd

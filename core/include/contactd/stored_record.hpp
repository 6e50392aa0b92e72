// Checks imported tables before they are stored.
#pragma once

#include "contactd/ic_record.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Returns the record of an IC file in stored form: dimensionless. Throws InvalidArgument ("datasets") for tables that
/// no builder makes. These are tables of closed forms or of invalid specs, tables whose errors against a closed form
/// exceed the stated ones, coefficients that no elastic body has (sign, decay, reciprocity, positive definiteness), and
/// frames of strips that differ from those of the section. Other errors cannot be detected. Throws Cancelled.
IcRecord stored_record(IcRecord record, const Observer& observer);

}  // namespace contactd

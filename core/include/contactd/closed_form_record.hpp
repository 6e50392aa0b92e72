// Tables of half-spaces in closed form, as the store and the daemon hold tables.
#pragma once

#include "contactd/ic_record.hpp"

namespace contactd {

/// The dimensionless table of `spec` (whose source is analytic), with the evidence that closed forms have: source and
/// version.
IcRecord closed_form_record(const IcSpec& spec);

}  // namespace contactd

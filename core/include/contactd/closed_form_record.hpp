// Tables of half-spaces in closed form, and of layers, as the store and the daemon hold tables.
#pragma once

#include "contactd/ic_record.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// The dimensionless table of `spec` (whose source is analytic), with the evidence that closed forms have: source and
/// version, and of layers the estimated errors. Of layers, which may take seconds, it asks the observer whether to go
/// on.
IcRecord closed_form_record(const IcSpec& spec, const Observer& observer = {});

}  // namespace contactd

// Tables of half-spaces in closed form, and of layers, as the store and the daemon hold tables.
#pragma once

#include <vector>

#include "contactd/ic_record.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// The dimensionless table of `spec` (whose source is analytic), with the evidence that closed forms have: source and
/// version, and of layers the estimated errors. Of layers, which may take seconds, it asks the observer whether to go
/// on.
IcRecord closed_form_record(const IcSpec& spec, const Observer& observer = {});

/// Of the columns of a prism (mm), none of other bodies. Throws InvalidArgument as the making of its table does.
std::vector<ColumnFrame> column_frames(const IcSpec& spec);

}  // namespace contactd

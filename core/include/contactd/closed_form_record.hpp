// Makes records of the tables of half-spaces in closed form and of layers.
#pragma once

#include "contactd/ic_record.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Returns the dimensionless table of `spec`, whose source is analytic, with its evidence: source and version, and the
/// estimated errors of layers. Layers may take seconds, and the observer can cancel them.
IcRecord closed_form_record(const IcSpec& spec, const Observer& observer = {});

}  // namespace contactd

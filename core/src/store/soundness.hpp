// Properties of the coefficients of every elastic body, whoever computed them: tables of strangers are checked for
// them.
#pragma once

#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/observer.hpp"
#include "contactd/strip_spectrum.hpp"

namespace contactd {

/// Throws InvalidArgument ("datasets") when a table of offsets does not err as little as it states, where a closed form
/// exists (half-space); when it is not near the half-space's, decays otherwise or is not reciprocal, where none does
/// (block); and in any case when a traction on some of its elements would take work out of the body. `spec` and `table`
/// are in one unit; `stated` is the evidence of the table.
void require_sound(const IcTable& table, const IcSpec& spec, const IcEvidence& stated, const Observer& observer);

/// Throws the same for the transform of a longitudinally uniform body: at no wavenumber may a traction on some of its
/// strips take work out of the body, by more than the stated error.
void require_sound(const StripSpectrum& spectrum, const IcEvidence& stated, bool is_free, const Observer& observer);

}  // namespace contactd

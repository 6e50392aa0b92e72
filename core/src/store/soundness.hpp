// Checks properties that the coefficients of every elastic body have. Imported tables must pass.
#pragma once

#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/observer.hpp"
#include "contactd/strip_spectrum.hpp"

namespace contactd {

/// Throws InvalidArgument ("datasets") for an implausible table. If a closed form exists (half-space), the errors of
/// the table must not exceed the stated ones. If none exists (block), it must be near the half-space's, decay like it
/// and be reciprocal. In any case, no traction on some of its elements may extract work from the body. `spec` and
/// `table` have the same units; `stated` is the evidence of the table.
void require_sound(const IcTable& table, const IcSpec& spec, const IcEvidence& stated, const Observer& observer);

/// Throws the same for the transform of a longitudinally uniform body: at no wavenumber may a traction on some of its
/// strips extract work from the body, by more than the stated error.
void require_sound(const StripSpectrum& spectrum, const IcEvidence& stated, bool is_free, const Observer& observer);

}  // namespace contactd

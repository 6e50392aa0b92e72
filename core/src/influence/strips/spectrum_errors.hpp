// How good the transform of a longitudinally uniform body's coefficients is.
#pragma once

#include "contactd/strip_spectrum.hpp"

namespace contactd {

/// Returns the scale of errors of coefficients: zz of the half-space under an element of the same size, `dx` long, or
/// the largest zz of a strip on itself where that is less, as of thin layers.
double error_scale(const StripSpectrum& spectrum, double dx);

/// The largest change of a coefficient over error_scale() when every other wavenumber is left out; a cubic
/// interpolation's own error is about a sixteenth of it. Their number must be odd.
double nested_change(const StripSpectrum& spectrum, double dx, int nx);

/// The most, over error_scale(), by which coefficients may be wrong because the difference to the half-space is taken
/// to fall as 1/xi^2 beyond the last wavenumber; the last two tell how it does fall. Longer elements feel less of it.
double beyond_the_end(const StripSpectrum& spectrum, double dx);

}  // namespace contactd

// Estimates the accuracy of the transform of a longitudinally uniform body's coefficients.
#pragma once

#include "contactd/strip_spectrum.hpp"

namespace contactd {

/// Returns the scale of errors of coefficients: zz of the half-space under an element of the same size, `dx` long, or
/// the largest zz of a strip on itself if that is less, as for thin layers.
double error_scale(const StripSpectrum& spectrum, double dx);

/// Returns the largest change of a coefficient over error_scale() if every other wavenumber is omitted; the error of
/// cubic interpolation is about a sixteenth of it. The number of wavenumbers must be odd.
double nested_change(const StripSpectrum& spectrum, double dx, int nx);

/// Returns the largest possible error of coefficients, over error_scale(), due to the assumption that the difference to
/// the half-space decays as 1/xi^2 beyond the last wavenumber. The last two wavenumbers determine how it does decay.
/// Longer elements are less affected.
double beyond_the_end(const StripSpectrum& spectrum, double dx);

}  // namespace contactd

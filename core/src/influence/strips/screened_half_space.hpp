// The half-space under a strip of unit width in s, screened: its displacements without the logarithm at wavenumber
// zero. What is left of a section's transform when it is taken away is smooth there.
//
// The kernels of the surface displacements (kernel_integrals.hpp; x, s for x, y) have the transforms along x
//   1/r -> 2 K0(xi |s|),  s^2/r^3 -> 2 xi |s| K1(xi |s|),  x s/r^3 -> 2 xi s K0(xi |s|),
//   x/r^2 -> pi exp(-xi |s|),  s/r^2 -> pi sign(s) exp(-xi |s|),
// cosine transforms of what is even in x, sine transforms of what is odd. Screened, xi is sqrt(xi^2 + xi0^2) in the
// functions, and where it is odd a factor xi over that remains. In space 1/r becomes exp(-xi0 r)/r, whose derivatives
// the others are, and ln r becomes -K0(xi0 r).
#pragma once

#include "influence/kernel_integrals.hpp"

namespace contactd {

/// Transforms at wavenumber xi of the screened kernels over a strip one wide, its middle l strips away (in s).
KernelIntegrals screened_transforms(double xi, double xi0, int l);

/// Screened less unscreened kernels, over an element dx x 1 whose centre is (x, s) away.
KernelIntegrals screening(double xi0, double x, double s, double dx);

}  // namespace contactd

// Computes the screened half-space under a strip of unit width in s, whose displacements have no logarithm at
// wavenumber zero. The remainder of a section's transform without it is smooth there.
//
// The kernels of the surface displacements (kernel_integrals.hpp; x, s for x, y) have the transforms along x
//   1/r -> 2 K0(xi |s|),  s^2/r^3 -> 2 xi |s| K1(xi |s|),  x s/r^3 -> 2 xi s K0(xi |s|),
//   x/r^2 -> pi exp(-xi |s|),  s/r^2 -> pi sign(s) exp(-xi |s|),
// which are cosine transforms of even functions of x and sine transforms of odd ones. Screening replaces xi by
// sqrt(xi^2 + xi0^2) in the functions; in odd ones a factor xi over that remains. In space 1/r becomes exp(-xi0 r)/r,
// of which the others are derivatives, and ln r becomes -K0(xi0 r).
#pragma once

#include "influence/kernel_integrals.hpp"

namespace contactd {

/// Returns transforms at wavenumber xi of the screened kernels over a strip of width one, whose middle is l strips away
/// (in s).
KernelIntegrals screened_transforms(double xi, double xi0, int l);

/// Returns screened minus unscreened kernels, over an element dx x 1 whose centre is (x, s) away.
KernelIntegrals screening(double xi0, double x, double s, double dx);

}  // namespace contactd

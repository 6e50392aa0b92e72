// The half-space's kernels with what is far screened off, as they are and by their Fourier transform along x.
//
// Of the kernels of Boussinesq and Cerruti (Johnson, Contact Mechanics, 3.2 and 3.6), with r^2 = x^2 + s^2,
//     1/r       becomes  Y = exp(-xi0 r)/r,      x x/r^3, x s/r^3, s s/r^3  become  Y + s dY/ds, -s dY/dx, -s dY/ds,
//     x/r^2, s/r^2  become  x/r^2, s/r^2  times  xi0 r K1(xi0 r).
// They are as singular at the load, and vanish exponentially from r = 1/xi0 on. Their transforms, which for the
// half-space are infinite or jump at wavenumber 0, are smooth there, even or odd: |xi| becomes sqrt(xi^2 + xi0^2), but
// for a factor xi of the odd ones.
#pragma once

#include "influence/kernel_integrals.hpp"

namespace contactd {

/// Over the rectangle dx x ds at the distance (x, s) from its middle, 1 N/mm^2; xi0 = 0: those of the half-space.
/// Accuracy 1e-9 of the largest of them while xi0 max(dx, ds) <= 0.1.
KernelIntegrals screened_integrals(double x, double s, double dx, double ds, double xi0);

/// Transforms along x of the kernels over the line x = 0, |s'| <= ds/2 at the distance s: of the even ones (xx, yy and
/// y) the integral of A(x) cos(xi x) over all x, of the odd ones (xy and x) that of A(x) sin(xi x). So A(x) is 1/pi
/// times the integral of cos or sin(xi x) times the transform over xi > 0, and an element of length dx takes the factor
/// 2 sin(xi dx/2)/xi. Not both of xi >= 0 and xi0 >= 0 may vanish.
KernelIntegrals screened_transform(double xi, double s, double ds, double xi0);

}  // namespace contactd

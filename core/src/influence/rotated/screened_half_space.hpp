// The half-space's coefficients with what is far screened off: both as they are and by their Fourier transform along x.
//
// In the kernels of Boussinesq and Cerruti (Johnson, Contact Mechanics, 3.2 and 3.6), with r^2 = x^2 + s^2,
//     1/r        becomes  Y = exp(-xi0 r)/r,        x x/r^3, x s/r^3, s s/r^3  become  -x dY/dx, -s dY/dx, Y + x dY/dx,
//     x/r^2, s/r^2  become  x/r^2 and s/r^2 times xi0 r K1(xi0 r).
// They are those of the half-space near the load and vanish exponentially from 1/xi0 on. Their transforms along x,
// which are infinite or break off at wavenumber 0 for the half-space, are smooth there: even or odd functions of xi
// with powers of kappa = sqrt(xi^2 + xi0^2) in place of those of |xi|.
#pragma once

#include "influence/rotated/column_values.hpp"

namespace contactd {

/// Times G: displacements at (x, s) of the flat surface for unit tractions over dx x ds about the origin; xi0 = 0:
/// those of the half-space. Accuracy: 1e-9 of the largest component while xi0 max(dx, ds) < 0.1.
NineValues screened_coefficients(double x, double s, double dx, double ds, double nu, double xi0);

/// Times G: transforms along x of the displacements at (x, s) for unit tractions over the strip of width ds about s =
/// 0, per unit of length along x: of the even components (xx, ss, nn, sn, ns) the integral of A(x) cos(xi x) over all
/// x, of the odd ones (xs, sx, xn, nx) that of A(x) sin(xi x). So A(x) = 1/pi times the integral of A^(xi) cos or
/// sin(xi x) over xi from 0 on, and an element of length dx takes the factor 2 sin(xi dx/2)/xi. xi >= 0, xi0 > 0 or xi
/// > 0.
NineValues screened_transform(double xi, double s, double ds, double nu, double xi0);

}  // namespace contactd

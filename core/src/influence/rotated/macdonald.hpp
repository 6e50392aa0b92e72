// Bessel functions of the second kind of imaginary argument, K0 and K1, and an integral (Abramowitz and Stegun, 9.6
// and 11.1).
#pragma once

namespace contactd {

struct Macdonald {
    double k0 = 0;        ///< K0(t); meant for t > 0
    double t_k1 = 0;      ///< t K1(t) - 1: 0 at t = 0, -1 far away
    double integral = 0;  ///< of K0 from 0 to t: pi/2 far away
};

/// Relative accuracy 1e-13 of each; t >= 0. At t = 0 k0 is infinite.
Macdonald macdonald(double t);

}  // namespace contactd

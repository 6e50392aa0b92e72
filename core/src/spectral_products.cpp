#include "spectral_products.hpp"

#include "wide.hpp"

namespace contactd {

CONTACTD_WIDE
void multiply_pair(std::size_t n, double* __restrict x, double* __restrict y, const double* __restrict xx,
                   const double* __restrict xy, const double* __restrict yx, const double* __restrict yy) {
    for (std::size_t i = 0; i < n; ++i) {
        const double ar = x[2 * i], ai = x[2 * i + 1], br = y[2 * i], bi = y[2 * i + 1];
        x[2 * i] = xx[i] * ar + xy[i] * br;
        x[2 * i + 1] = xx[i] * ai + xy[i] * bi;
        y[2 * i] = yx[i] * ar + yy[i] * br;
        y[2 * i + 1] = yx[i] * ai + yy[i] * bi;
    }
}

CONTACTD_WIDE
static void multiply(std::size_t n, double* __restrict x, double* __restrict y, const double* __restrict xx_real,
                     const double* __restrict xx_imag, const double* __restrict xy_real,
                     const double* __restrict xy_imag, const double* __restrict yx_real,
                     const double* __restrict yx_imag, const double* __restrict yy_real,
                     const double* __restrict yy_imag) {
    for (std::size_t i = 0; i < n; ++i) {
        const double ar = x[2 * i], ai = x[2 * i + 1], br = y[2 * i], bi = y[2 * i + 1];
        x[2 * i] = xx_real[i] * ar - xx_imag[i] * ai + xy_real[i] * br - xy_imag[i] * bi;
        x[2 * i + 1] = xx_real[i] * ai + xx_imag[i] * ar + xy_real[i] * bi + xy_imag[i] * br;
        y[2 * i] = yx_real[i] * ar - yx_imag[i] * ai + yy_real[i] * br - yy_imag[i] * bi;
        y[2 * i + 1] = yx_real[i] * ai + yx_imag[i] * ar + yy_real[i] * bi + yy_imag[i] * br;
    }
}

void multiply_pair(std::size_t n, double* x, double* y, const ComplexFactor& xx, const ComplexFactor& xy,
                   const ComplexFactor& yx, const ComplexFactor& yy) {
    multiply(n, x, y, xx.real, xx.imag, xy.real, xy.imag, yx.real, yx.imag, yy.real, yy.imag);
}

}  // namespace contactd

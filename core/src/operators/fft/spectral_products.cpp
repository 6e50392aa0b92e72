#include "spectral_products.hpp"

#include "types/simd.hpp"

namespace contactd {

CONTACTD_SIMD
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

CONTACTD_SIMD
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

CONTACTD_SIMD
static void multiply(std::size_t n, double* __restrict x, const double* __restrict real,
                     const double* __restrict imag) {
    for (std::size_t i = 0; i < n; ++i) {
        const double xr = x[2 * i], xi = x[2 * i + 1];
        x[2 * i] = real[i] * xr - imag[i] * xi;
        x[2 * i + 1] = real[i] * xi + imag[i] * xr;
    }
}

void multiply(std::size_t n, double* x, const ComplexFactor& symbol) {
    multiply(n, x, symbol.real, symbol.imag);
}

void multiply_pair(std::size_t n, double* x, double* y, const ComplexFactor& xx, const ComplexFactor& xy,
                   const ComplexFactor& yx, const ComplexFactor& yy) {
    multiply(n, x, y, xx.real, xx.imag, xy.real, xy.imag, yx.real, yx.imag, yy.real, yy.imag);
}

CONTACTD_SIMD
void interleave(std::size_t n, const double* __restrict x, const double* __restrict y, double* __restrict both) {
    for (std::size_t i = 0; i < n; ++i) {
        both[2 * i] = x[i];
        both[2 * i + 1] = y[i];
    }
}

CONTACTD_SIMD
void deinterleave(std::size_t n, const double* __restrict both, double* __restrict x, double* __restrict y) {
    for (std::size_t i = 0; i < n; ++i) {
        x[i] = both[2 * i];
        y[i] = both[2 * i + 1];
    }
}

// X(k) = (Z(k) + conj Z(n-k))/2, Y(k) = (Z(k) - conj Z(n-k))/(2i)
CONTACTD_SIMD
void split_transforms(std::size_t n, const double* __restrict both, double* __restrict x, double* __restrict y) {
    x[0] = both[0];
    x[1] = 0;
    y[0] = both[1];
    y[1] = 0;
    for (std::size_t k = 1; k <= n / 2; ++k) {
        const double ar = both[2 * k], ai = both[2 * k + 1], br = both[2 * (n - k)], bi = both[2 * (n - k) + 1];
        x[2 * k] = 0.5 * (ar + br);
        x[2 * k + 1] = 0.5 * (ai - bi);
        y[2 * k] = 0.5 * (ai + bi);
        y[2 * k + 1] = 0.5 * (br - ar);
    }
}

// Z(k) = X(k) + i Y(k), Z(n-k) = conj X(k) + i conj Y(k); X and Y are real at 0 and at n/2 but for rounding.
CONTACTD_SIMD
void join_transforms(std::size_t n, const double* __restrict x, const double* __restrict y, double* __restrict both) {
    both[0] = x[0];
    both[1] = y[0];
    for (std::size_t k = 1; 2 * k < n; ++k) {
        const double xr = x[2 * k], xi = x[2 * k + 1], yr = y[2 * k], yi = y[2 * k + 1];
        both[2 * k] = xr - yi;
        both[2 * k + 1] = xi + yr;
        both[2 * (n - k)] = xr + yi;
        both[2 * (n - k) + 1] = yr - xi;
    }
    if (n > 1 && n % 2 == 0) {
        both[n] = x[n];
        both[n + 1] = y[n];
    }
}

}  // namespace contactd

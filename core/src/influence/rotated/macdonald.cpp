#include "influence/rotated/macdonald.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace contactd {
namespace {

// Powers of t with a logarithm, term by term (9.6.13).
Macdonald series(double t) {
    const double logarithm = -std::log(t / 2) - std::numbers::egamma, square = t * t / 4;
    Macdonald sum;
    double power = 1, harmonic = 0;  // square^k / k!^2, and 1 + 1/2 + ... + 1/k
    for (int k = 0; k < 14; ++k) {
        if (k > 0) {
            power *= square / (k * k);
            harmonic += 1.0 / k;
        }
        const double term = harmonic + logarithm;
        sum.k0 += power * term;
        if (k > 0) sum.t_k1 += power * (1 - 2 * k * term);
        sum.integral += power * t * (term + 1.0 / (2 * k + 1)) / (2 * k + 1);
    }
    return sum;
}

// Integrals of exp(-t cosh u) times 1, cosh u and 1 / cosh u over u (9.6.24, 11.1.8). The trapezoidal rule converges
// exponentially: the integrands are analytic up to pi/2 from the real axis.
Macdonald trapezoidal(double t) {
    const double step = std::min(0.2, 0.7 / std::sqrt(t));
    const double first = std::exp(-t);
    Macdonald sum{first / 2, first / 2, first / 2};
    for (int i = 1;; ++i) {
        const double cosine = std::cosh(i * step), value = std::exp(-t * cosine);
        sum.k0 += value;
        sum.t_k1 += value * cosine;
        sum.integral += value / cosine;
        if (t * (cosine - 1) > 40) break;
    }
    return {step * sum.k0, step * t * sum.t_k1 - 1, std::numbers::pi / 2 - step * sum.integral};
}

}  // namespace

Macdonald macdonald(double t) {
    if (t == 0) return {std::numeric_limits<double>::infinity(), 0, 0};
    if (t > 700) return {0, -1, std::numbers::pi / 2};
    return t < 2 ? series(t) : trapezoidal(t);
}

}  // namespace contactd

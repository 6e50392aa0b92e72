#include "influence/rotated/screened_half_space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "influence/gauss_rules.hpp"
#include "influence/rotated/macdonald.hpp"

namespace contactd {
namespace {

void add(KernelIntegrals& sum, double factor, const KernelIntegrals& term) {
    sum.xx += factor * term.xx;
    sum.yy += factor * term.yy;
    sum.xy += factor * term.xy;
    sum.x += factor * term.x;
    sum.y += factor * term.y;
}

// Screened kernels less those of the half-space: bounded, and small where xi0 r is.
KernelIntegrals difference(double x, double s, double xi0) {
    const double r = std::hypot(x, s), t = xi0 * r;
    const double potential = std::expm1(-t);            // r Y - 1
    const double slope = potential + t * std::exp(-t);  // -r^2 dY/dr - 1
    const double coupling = macdonald(t).t_k1;
    KernelIntegrals value;
    value.yy = s * s * slope / (r * r * r);
    value.xx = potential / r - value.yy;
    value.xy = x * s * slope / (r * r * r);
    value.x = x * coupling / (r * r);
    value.y = s * coupling / (r * r);
    return value;
}

// A rectangle by its middle and half its sides. Differences are smooth but at the origin: rectangles near it are
// divided until what remains there is too small to matter.
void integrate(double x, double s, double half_x, double half_s, double xi0, int divisions, KernelIntegrals& sum) {
    const double size = std::max(half_x, half_s), far = std::hypot(x, s) / size;
    if (far < 3 && divisions > 0) {
        const bool along_x = half_x >= half_s;
        const double quarter_x = along_x ? half_x / 2 : 0, quarter_s = along_x ? 0 : half_s / 2;
        for (const int side : {-1, 1})
            integrate(x + side * quarter_x, s + side * quarter_s, half_x - quarter_x, half_s - quarter_s, xi0,
                      divisions - 1, sum);
        return;
    }
    const auto gauss = [&](const auto& rule) {
        for (const auto& along_x : rule)
            for (const auto& along_s : rule)
                add(sum, 4 * half_x * half_s * along_x.weight * along_s.weight,
                    difference(x + along_x.node * half_x, s + along_s.node * half_s, xi0));
    };
    if (far < 12)
        gauss(legendre6);
    else
        gauss(legendre3);
}

// Antiderivatives along s of the transforms, up to constants.
KernelIntegrals antiderivatives(double xi, double s, double kappa) {
    const double t = kappa * std::abs(s), sign = s < 0 ? -1 : s > 0 ? 1 : 0;
    const Macdonald k = macdonald(t);
    const double t_k0 = t > 0 ? t * k.k0 : 0;
    KernelIntegrals value;
    value.yy = 2 * sign * (k.integral - t_k0) / kappa;                         // of 2 t K1(t)
    value.xx = 2 * sign * k.integral / kappa - value.yy;                       // of 2 K0(t) - 2 t K1(t)
    value.xy = -2 * xi / kappa * k.t_k1 / kappa;                               // of 2 xi s K0(t)
    value.x = -std::numbers::pi * xi / kappa * sign * std::expm1(-t) / kappa;  // of pi xi / kappa exp(-t)
    value.y = -std::numbers::pi * std::expm1(-t) / kappa;                      // of pi sign(s) exp(-t)
    return value;
}

}  // namespace

KernelIntegrals screened_integrals(double x, double s, double dx, double ds, double xi0) {
    constexpr int divisions = 16;
    KernelIntegrals sum = constant_load_integrals(x, s, dx, ds);
    if (xi0 > 0) {
        KernelIntegrals change;
        integrate(std::abs(x), std::abs(s), dx / 2, ds / 2, xi0, divisions, change);
        const double sign_x = x < 0 ? -1 : x > 0 ? 1 : 0, sign_s = s < 0 ? -1 : s > 0 ? 1 : 0;
        change.xy *= sign_x * sign_s;
        change.x *= sign_x;
        change.y *= sign_s;
        add(sum, 1, change);
    }
    return sum;
}

KernelIntegrals screened_transform(double xi, double s, double ds, double xi0) {
    const double kappa = std::hypot(xi, xi0);
    KernelIntegrals value = antiderivatives(xi, s + ds / 2, kappa);
    add(value, -1, antiderivatives(xi, s - ds / 2, kappa));
    return value;
}

}  // namespace contactd

#include "influence/strips/screened_half_space.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "influence/layered/gauss_legendre.hpp"

namespace contactd {
namespace {

using std::numbers::pi;

/// Beyond this argument, the functions are below rounding errors, even of near values.
constexpr double far = 45;

KernelIntegrals transforms(double xi, double xi0, double s) {
    const double kappa = std::hypot(xi, xi0), argument = kappa * std::abs(s);
    if (argument > far) return {};
    const double k0 = 2 * std::cyl_bessel_k(0, argument), k1 = 2 * argument * std::cyl_bessel_k(1, argument),
                 fading = pi * std::exp(-argument);
    return {k0 - k1, k1, xi * s * k0, fading * xi / kappa, s < 0 ? -fading : fading};
}

void add(KernelIntegrals& sum, double weight, const KernelIntegrals& term) {
    sum.xx += weight * term.xx;
    sum.yy += weight * term.yy;
    sum.xy += weight * term.xy;
    sum.x += weight * term.x;
    sum.y += weight * term.y;
}

KernelIntegrals screening_at(double xi0, double x, double s) {
    const double r = std::hypot(x, s), a = xi0 * r;
    if (a > far) return {-x * x / (r * r * r), -s * s / (r * r * r), -x * s / (r * r * r), -x / (r * r), -s / (r * r)};
    if (r == 0) return {-xi0, 0, 0, 0, 0};
    const double first = std::expm1(-a) / r;                                 // of 1/r
    const double third = (a * std::exp(-a) + std::expm1(-a)) / (r * r * r);  // of 1/r^3
    const double second = (a * std::cyl_bessel_k(1, a) - 1) / (r * r);       // of 1/r^2
    return {first - s * s * third, s * s * third, x * s * third, x * second, s * second};
}

}  // namespace

KernelIntegrals screened_transforms(double xi, double xi0, int l) {
    // The functions are smoother the farther their singularity is.
    static const auto around = gauss_legendre(20), beside = gauss_legendre(12), away = gauss_legendre(8);
    KernelIntegrals sum;
    for (const auto& [node, weight] : l == 0 ? around : std::abs(l) == 1 ? beside : away) {
        if (l != 0) {
            add(sum, weight, transforms(xi, xi0, l - 0.5 + node));
            continue;
        }
        // Points are denser near the logarithm in the middle; odd functions of s cancel.
        const double s = 0.5 * node * node * node;
        KernelIntegrals both = transforms(xi, xi0, s);
        both.xy = both.y = 0;
        add(sum, weight * 3 * node * node, both);
    }
    return sum;
}

KernelIntegrals screening(double xi0, double x, double s, double dx) {
    constexpr double near = 3;  // elements, within which the kernels are not linear over one
    if (std::abs(x) > near * dx || std::abs(s) > near) {
        KernelIntegrals sum;
        add(sum, dx, screening_at(xi0, x, s));
        return sum;
    }
    KernelIntegrals sum;
    const double gauss = 0.5 / std::sqrt(3.0);
    for (const double a : {-gauss, gauss})
        for (const double b : {-gauss, gauss}) add(sum, dx / 4, screening_at(xi0, x - a * dx, s - b));
    return sum;
}

}  // namespace contactd

// Computes integrals of the functions that make up the surface displacements of the half-space, over a load of either
// shape.
#pragma once

#include <cmath>

namespace contactd {

/// Holds integrals of the kernel at (x, y) - (point of the load), times the traction there; that of 1/rho is xx + yy.
struct KernelIntegrals {
    double xx = 0;  ///< x^2/rho^3
    double yy = 0;  ///< y^2/rho^3
    double xy = 0;  ///< x y/rho^3
    double x = 0;   ///< x/rho^2
    double y = 0;   ///< y/rho^2
};

/// Returns the integrals for a constant load, 1 on the rectangle dx x dy centred at the origin.
KernelIntegrals constant_load_integrals(double x, double y, double dx, double dy);
/// Returns antiderivatives in x and y; `x` and `y` of the result, which only coupling needs, are omitted unless
/// `coupled`.
KernelIntegrals corner_antiderivatives(double x, double y, bool coupled);
/// Returns the integrals for a bilinear load, (1 - |x|/dx)(1 - |y|/dy).
KernelIntegrals bilinear_load_integrals(double x, double y, double dx, double dy);

/// Return the integrals for loads from -infinity to infinity along y, at x; logarithms are those of lengths over
/// `datum`. With yy = -2 ln, x = pi sign and zeros, the coefficients of a half-space are those of plane and anti-plane
/// strain (Johnson, chapter 2): (1-nu)/(pi G) ln(datum/|x|) for xx and zz, 1/(pi G) ln(datum/|x|) for yy.
KernelIntegrals constant_line_integrals(double x, double dx, double datum);
KernelIntegrals bilinear_line_integrals(double x, double dx, double datum);

/// Returns the mean over the product of two Gauss rules on (x +- half_x) x (y +- half_y).
template <class RuleX, class RuleY>
KernelIntegrals gauss_mean(const RuleX& rule_x, const RuleY& rule_y, double x, double y, double half_x, double half_y) {
    KernelIntegrals sum;
    for (const auto& along_x : rule_x)
        for (const auto& along_y : rule_y) {
            const double X = x + along_x.node * half_x, Y = y + along_y.node * half_y;
            const double per_rho2 = 1 / (X * X + Y * Y);
            const double weighted2 = along_x.weight * along_y.weight * per_rho2;
            const double weighted3 = weighted2 * std::sqrt(per_rho2);
            sum.xx += weighted3 * X * X;
            sum.yy += weighted3 * Y * Y;
            sum.xy += weighted3 * X * Y;
            sum.x += weighted2 * X;
            sum.y += weighted2 * Y;
        }
    return sum;
}

/// Uses that the integrals are homogeneous of degree one and even or odd: `at(|x|, |y|, dx, dy)` is called with lengths
/// over sqrt(dx dy) and must return them for a unit force (dx dy = 1). Odd ones are exactly zero on the axes.
template <class Function>
KernelIntegrals by_symmetry(const Function& at, double x, double y, double dx, double dy) {
    const double scale = std::sqrt(dx) * std::sqrt(dy);
    KernelIntegrals result = at(std::abs(x) / scale, std::abs(y) / scale, dx / scale, dy / scale);
    const double sign_x = x < 0 ? -1 : x > 0 ? 1 : 0, sign_y = y < 0 ? -1 : y > 0 ? 1 : 0;
    result.xx *= scale;
    result.yy *= scale;
    result.xy *= scale * sign_x * sign_y;
    result.x *= scale * sign_x;
    result.y *= scale * sign_y;
    return result;
}

}  // namespace contactd

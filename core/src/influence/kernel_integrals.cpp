#include "kernel_integrals.hpp"

#include <algorithm>

#include "gauss_rules.hpp"

namespace contactd {
namespace {

// Returns y ln(x + rho) up to y ln|y|, which cancels in differences in x; asinh loses no digits for x < 0.
double y_log(double x, double y) {
    if (std::abs(y) <= 1e-200 * std::abs(x)) return 0;
    return y * std::asinh(x / std::abs(y));
}

double product_with_log(double y, double rho) {
    return rho > 0 ? y * std::log(rho) : 0;
}
double product_with_atan(double x, double y) {
    return x == 0 ? 0 : x * std::atan(y / x);
}

// Returns differences of the antiderivatives between the four corners.
KernelIntegrals by_antiderivatives(double x, double y, double dx, double dy) {
    KernelIntegrals sum;
    for (const int sx : {-1, 1})
        for (const int sy : {-1, 1}) {
            const double sign = sx * sy;
            const KernelIntegrals corner = corner_antiderivatives(x + 0.5 * sx * dx, y + 0.5 * sy * dy, true);
            sum.xx += sign * corner.xx;
            sum.yy += sign * corner.yy;
            sum.xy += sign * corner.xy;
            sum.x += sign * corner.x;
            sum.y += sign * corner.y;
        }
    return sum;
}

// The differences of antiderivatives lose digits as (rho/size)^2. Far away, where the kernels are smooth over the
// rectangle, Gauss's rule is better. Its error decreases as (4 rho/size)^(-2n), and is below rounding errors for the
// chosen limits.
KernelIntegrals unit_force(double x, double y, double dx, double dy) {
    const double distance = std::hypot(x, y) / std::max(dx, dy);
    return distance > 100 ? gauss_mean(legendre3, legendre3, x, y, 0.5 * dx, 0.5 * dy)
           : distance > 8 ? gauss_mean(legendre6, legendre6, x, y, 0.5 * dx, 0.5 * dy)
                          : by_antiderivatives(x, y, dx, dy);
}

}  // namespace

KernelIntegrals corner_antiderivatives(double x, double y, bool coupled) {
    const double rho = std::hypot(x, y);
    KernelIntegrals k{y_log(x, y), y_log(y, x), -rho, 0, 0};
    if (!coupled) return k;
    k.x = product_with_log(y, rho) + product_with_atan(x, y);
    k.y = product_with_log(x, rho) + product_with_atan(y, x);
    return k;
}

KernelIntegrals constant_load_integrals(double x, double y, double dx, double dy) {
    return by_symmetry(unit_force, x, y, dx, dy);
}

}  // namespace contactd

// This is the derivation. With the depth d as third axis, rho^2 = x^2 + y^2 + d^2, and the potentials of a point force
//   W = d ln(rho + d) - rho,  I = W_d = ln(rho + d),  N = I_d = 1/rho,
// all harmonic, Boussinesq's and Cerruti's displacements (Johnson (3.4)) and Hooke's law give, 2 pi times,
//   pressure p:    xx 2 nu N_d - (1-2nu) I_xx - d N_xx,  zz N_d - d N_dd,  xy -(1-2nu) I_xy - d N_xy,  xd -d N_xd
//   traction q_x:  xx 2(1+nu) N_x + 2 nu W_xxx - d I_xxx,  yy 2 nu (N_x + W_xyy) - d I_xyy,  zz -d N_xd,
//                  xy N_y + 2 nu W_xxy - d I_xxy,  xd N_d - d N_xx,  yd -d N_xy
// and so on by symmetry. Their integrals over x and y are
//   N_x: ln(rho+y)   N_d: -atan(xy/(d rho))   N_xx: x/(rho(rho+y))   N_xy: 1/rho   N_xd: d/(rho(rho+y))
//   I_xx: atan(xy(rho-d)/(x^2 rho + d y^2))   I_xy: ln(rho+d)   I_xyy: y/(rho(rho+d))   W_xyy: -y/(rho+d)
// and the others follow from Laplace's equation. With z = -d, and the traction along z = -p, xz = -xd and yz = -yd.
//
// An infinite row of elements along y is in plane strain (Johnson, section 2.2 and 2.3; McEwen for Hertz's pressure).
// Line forces cause radial stresses, 2 cos(t)/(pi r) with the angle t from the direction of the force, and along y
// shear stresses 1/(pi r). Their integrals over x, with r^2 = x^2 + d^2 and A = atan(x/d), are, pi times,
//   traction q_z:  xx A - x d/r^2          zz A + x d/r^2     xz d^2/r^2
//   traction q_x:  xx -2 ln r - d^2/r^2    zz d^2/r^2         xz A - x d/r^2
//   traction q_y:  xy -ln r                yz A
// with yy = nu (xx + zz).
#include "patch_stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "patch_corner.hpp"

namespace contactd {
namespace {

constexpr double per_two_pi = 0.5 / std::numbers::pi;

using Corner = PatchCorner;

StressComponents normal_load(const Corner& c, double nu) {
    const double of_x = c.d / (c.rho * c.rho_and_y()), of_y = c.d / (c.rho * c.rho_and_x());
    const double solid = c.solid_angle(), angle = c.angle_xx(), rest = 1 - 2 * nu;
    return {2 * nu * solid + rest * angle + of_x * c.x,
            2 * nu * solid + rest * (solid - angle) + of_y * c.y,
            solid - of_x * c.x - of_y * c.y,
            rest * std::log(c.rho + c.d) + c.d / c.rho,
            -c.d * of_x,
            -c.d * of_y};
}

StressComponents load_along_x(const Corner& c, double nu) {
    const double ln_x = std::log(c.rho_and_x()), ln_y = std::log(c.rho_and_y());
    const double below = 1 / (c.rho + c.d), factor = 2 * nu * below + c.d * below / c.rho;
    const double of_x = c.d / (c.rho * c.rho_and_y());
    return {2 * ln_y + factor * c.y + c.d * of_x,
            2 * nu * ln_y - factor * c.y,
            -c.d * of_x,
            ln_x - factor * c.x,
            c.solid_angle() + of_x * c.x,
            c.d / c.rho};
}

constexpr double per_pi = 1 / std::numbers::pi;

StressComponents plane_strain(double xx, double zz, double xz, double nu) {
    return {per_pi * xx, per_pi * nu * (xx + zz), per_pi * zz, 0, per_pi * xz, 0};
}

}  // namespace

StressComponents edge_stress(Axis load, double x, double d, double nu, double smallest) {
    if (std::abs(x) < 1e-6 * smallest) x = 0;
    d = std::abs(d);
    const double r = std::max(std::hypot(x, d), smallest), angle = std::atan2(x, d);
    const double sine = x / r, cosine = d / r;  // for the angle from the depth
    if (load == Axis::y) return {0, 0, 0, -per_pi * std::log(r), 0, per_pi * angle};
    if (load == Axis::x)
        return plane_strain(-2 * std::log(r) - cosine * cosine, cosine * cosine, angle - sine * cosine, nu);
    return plane_strain(angle - sine * cosine, angle + sine * cosine, cosine * cosine, nu);
}

StressComponents corner_stress(Axis load, double x, double y, double d, double nu, double smallest) {
    if (std::isinf(y)) {  // Each end of an infinite row contributes half of its edge.
        StressComponents half = edge_stress(load, x, d, nu, smallest);
        for (double& component : half) component *= std::copysign(0.5, y);
        return half;
    }
    const double rounding = 1e-6 * smallest;  // A point on an edge must not count as on one of its sides.
    if (std::abs(x) < rounding) x = 0;
    if (std::abs(y) < rounding) y = 0;
    d = std::abs(d);  // -0 would reverse the angles.
    StressComponents stress = load == Axis::z   ? normal_load({x, y, d, smallest}, nu)
                              : load == Axis::x ? load_along_x({x, y, d, smallest}, nu)
                                                : load_along_x({y, x, d, smallest}, nu);
    if (load == Axis::y) {
        std::swap(stress[0], stress[1]);
        std::swap(stress[4], stress[5]);
    }
    for (double& component : stress) component *= per_two_pi;
    return stress;
}

Parity stress_parity(Axis load, std::size_t component) {
    const bool odd_x = component == 3 || component == 4, odd_y = component == 3 || component == 5;
    return {odd_x != (load == Axis::x) ? -1 : 1, odd_y != (load == Axis::y) ? -1 : 1};
}

}  // namespace contactd

// This is the derivation. With rho^2 = x^2 + y^2 + d^2, Boussinesq's and Cerruti's displacements (Johnson, sections 3.2
// and 3.6, with the z axis reversed), times 4 pi G at the depth d below a unit force along z, out of the body, and
// along x, are
//   traction q_z:  along x  x (1-2nu)/(rho (rho+d)) - x d/rho^3,  likewise along y,
//                  along z  d^2/rho^3 + 2 (1-nu)/rho;
//   traction q_x:  along x  1/rho + x^2/rho^3 + (1-2nu) (1/(rho+d) - x^2/(rho (rho+d)^2)),
//                  along y  x y/rho^3 - (1-2nu) x y/(rho (rho+d)^2),
//                  along z  -x d/rho^3 - (1-2nu) x/(rho (rho+d));
// and their integrals over x and y, with S = atan(xy/(d rho)) and A = atan(y/x) - atan(y d/(x rho)), are
//   1/rho: x ln(rho+y) + y ln(rho+x) - d S             d^2/rho^3: d S
//   x^2/rho^3: y ln(rho+x) - d S                       x d/rho^3: -d ln(rho+y)
//   x/(rho (rho+d)): y ln(rho+d) + x A + d ln(rho+y)   x y/rho^3: -rho
//   1/(rho+d) - x^2/(rho (rho+d)^2): x ln(rho+y) - d A
//   x y/(rho (rho+d)^2): d ln(rho+d) - rho
#include "patch_displacement.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "patch_corner.hpp"

namespace contactd {
namespace {

Displacement under_normal_load(const PatchCorner& c, double nu) {
    const double ln_x = std::log(c.rho_and_x()), ln_y = std::log(c.rho_and_y()), ln_d = std::log(c.rho + c.d);
    const double solid = c.solid_angle(), angle = c.angle_xx(), rest = 1 - 2 * nu;
    return {rest * (c.y * ln_d + c.x * angle + c.d * ln_y) + c.d * ln_y,
            rest * (c.x * ln_d + c.y * (solid - angle) + c.d * ln_x) + c.d * ln_x,
            c.d * solid + 2 * (1 - nu) * (c.x * ln_y + c.y * ln_x - c.d * solid)};
}

Displacement under_load_along_x(const PatchCorner& c, double nu) {
    const double ln_x = std::log(c.rho_and_x()), ln_y = std::log(c.rho_and_y()), ln_d = std::log(c.rho + c.d);
    const double solid = c.solid_angle(), angle = c.angle_xx(), rest = 1 - 2 * nu;
    return {c.x * ln_y + 2 * (c.y * ln_x - c.d * solid) + rest * (c.x * ln_y - c.d * angle),
            -c.rho - rest * (c.d * ln_d - c.rho), c.d * ln_y - rest * (c.y * ln_d + c.x * angle + c.d * ln_y)};
}

}  // namespace

Displacement corner_displacement(Axis load, double x, double y, double d, double nu, double smallest) {
    d = std::abs(d);  // -0 would reverse the angles.
    Displacement at = load == Axis::z   ? under_normal_load({x, y, d, smallest}, nu)
                      : load == Axis::x ? under_load_along_x({x, y, d, smallest}, nu)
                                        : under_load_along_x({y, x, d, smallest}, nu);
    if (load == Axis::y) std::swap(at[0], at[1]);
    for (double& component : at) component *= 0.25 / std::numbers::pi;
    return at;
}

Parity displacement_parity(Axis load, std::size_t component) {
    const bool odd_x = component == 0, odd_y = component == 1;
    return {odd_x != (load == Axis::x) ? -1 : 1, odd_y != (load == Axis::y) ? -1 : 1};
}

}  // namespace contactd

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "influence/gauss_rules.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using Vector = std::array<double, 3>;

// Returns Boussinesq's displacements times 4 pi G at (x, y) and depth d below a unit force along +z, out of the body
// (Johnson, section 3.2, with z axis and force reversed).
Vector normal_force(double x, double y, double d, double nu) {
    const double r = std::hypot(x, y, d);
    const double lateral = (1 - 2 * nu) / (r * (r + d)) - d / (r * r * r);
    return {x * lateral, y * lateral, (d * d / (r * r) + 2 * (1 - nu)) / r};
}

// Returns Cerruti's displacements for a unit force along +x in the same form (Johnson, section 3.6, with the z axis
// reversed).
Vector tangential_force(double x, double y, double d, double nu) {
    const double r = std::hypot(x, y, d), r3 = r * r * r;
    const double ratio = (1 - 2 * nu) / (r + d), quadratic = 1 / r3 - ratio / (r * (r + d));
    return {1 / r + ratio + x * x * quadratic, x * y * quadratic, -x * (d / r3 + ratio / r)};
}

Vector point_force(Axis load, double x, double y, double d, double nu) {
    if (load == Axis::z) return normal_force(x, y, d, nu);
    if (load == Axis::x) return tangential_force(x, y, d, nu);
    const auto [uy, ux, uz] = tangential_force(y, x, d, nu);
    return {ux, uy, uz};
}

template <class Rule>
Vector mean_over(const Rule& rule, double half_x, double half_y, Axis load, const Vector& point, double nu) {
    Vector sum{};
    const double depth = std::max(-point[2], 0.0);
    for (const auto& along_x : rule)
        for (const auto& along_y : rule) {
            const Vector u =
                point_force(load, point[0] - along_x.node * half_x, point[1] - along_y.node * half_y, depth, nu);
            for (std::size_t i = 0; i < 3; ++i) sum[i] += along_x.weight * along_y.weight * u[i];
        }
    return sum;
}

}  // namespace

std::array<double, 3> half_space_displacement(const IcSpec& spec, Axis load, const std::array<double, 3>& point) {
    const auto [x, y, z] = point;
    const double distance = std::hypot(x, y, z), size = std::max(spec.dx, spec.dy);
    if (!(z <= 1e-9 * std::max(distance, size)))  // Rounding errors of a mesh may exceed the surface.
        throw InvalidArgument("point", "has z = " + number_text(z) + "; it must be <= 0, inside the half-space");
    // An n-point rule has an error of about (2 distance/half)^(-2n), with `half` that of the load's support.
    const double nu = spec.material.nu;
    const bool far = distance > 100 * size;
    Vector mean;
    if (spec.load_shape == LoadShape::bilinear)
        mean = far ? mean_over(hat3, spec.dx, spec.dy, load, point, nu)
                   : mean_over(hat10, spec.dx, spec.dy, load, point, nu);
    else
        mean = far ? mean_over(legendre3, 0.5 * spec.dx, 0.5 * spec.dy, load, point, nu)
                   : mean_over(legendre6, 0.5 * spec.dx, 0.5 * spec.dy, load, point, nu);
    const double factor = spec.dx * spec.dy / (4 * std::numbers::pi * spec.material.G);
    for (double& u : mean) u *= factor;
    return mean;
}

}  // namespace contactd

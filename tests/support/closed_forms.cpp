#include "support/closed_forms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "closed_forms/elliptic_contact.hpp"
#include "closed_forms/kalker_coefficients.hpp"

namespace contactd::reference {

// Johnson (4.22)-(4.24); 1/E* = (1-nu1)/(2 G1) + (1-nu2)/(2 G2).
Hertz hertz(const MaterialPair& bodies, double R, double approach) {
    const auto compliance = [](const Material& body) { return (1 - body.nu) / (2 * body.G); };
    const double modulus = 1 / (compliance(bodies.upper) + compliance(bodies.lower));
    if (!(approach > 0)) return {0, 0, 0};
    const double radius = std::sqrt(R * approach);
    const double Fn = 4 * modulus * radius * approach / 3;
    return {radius, Fn, 1.5 * Fn / (std::numbers::pi * radius * radius)};
}

// Johnson (7.31), (7.40), (7.42): with c the adhesion radius, Fx = mu Fn (1 - c^3/a^3) and the shift is
// 3 mu Fn/(16 a) (1 - c^2/a^2) ((2-nu1)/G1 + (2-nu2)/G2).
Cattaneo cattaneo(const MaterialPair& bodies, const Hertz& hertz, double mu, double Fx) {
    const auto compliance = [](const Material& body) { return (2 - body.nu) / body.G; };
    const double ratio = std::cbrt(1 - Fx / (mu * hertz.Fn));
    const double shift = 3 * mu * hertz.Fn / (16 * hertz.radius) * (1 - ratio * ratio) *
                         (compliance(bodies.upper) + compliance(bodies.lower));
    return {ratio * hertz.radius, shift};
}

double unloading_shift(const MaterialPair& bodies, const Hertz& hertz, double mu, double highest, double Fx) {
    const double loaded = cattaneo(bodies, hertz, mu, highest).rigid_shift;
    return loaded - 2 * cattaneo(bodies, hertz, mu, 0.5 * (highest - Fx)).rigid_shift;
}

// Integral of mu p0 sqrt(1 - r^2/a^2) r over the circle.
double full_spin_moment(const Hertz& hertz, double mu) {
    return 3 * std::numbers::pi / 16 * mu * hertz.Fn * hertz.radius;
}

RollingForces linear_rolling(const MaterialPair& bodies, const SemiAxes& axes, double xi, double eta, double phi) {
    const Material material = combined_material(bodies);
    const KalkerCoefficients C = kalker_coefficients(axes.a / axes.b, material.nu);
    const double c = std::sqrt(axes.a * axes.b), unit = -material.G * c * c;
    return {unit * C.C11 * xi, unit * (C.C22 * eta + C.C23 * c * phi), unit * c * (-C.C23 * eta + C.C33 * c * phi)};
}

// Johnson (4.43), (4.45): a^2 = 4 P R/(pi E*), p0 = 2 P/(pi a).
LineContact line_contact(const MaterialPair& bodies, double R, double force) {
    if (!(force > 0)) return {0, 0, 0};
    const double half_width = std::sqrt(4 * force * R * bodies.normal_compliance() / std::numbers::pi);
    return {half_width, 2 * force / (std::numbers::pi * half_width), force};
}

namespace {

// An elliptic traction q0 sqrt(1 - x^2/a^2) stretches the surface by du/dx = -(1-nu)/G q0 x/a (Johnson, section 2.5).
// The creepage at the onset of full slip is mu p0 times the sum of both bodies' (1-nu)/G.
double full_creepage(const MaterialPair& bodies, const LineContact& contact, double mu) {
    return 2 * mu * contact.pmax * bodies.normal_compliance();
}

}  // namespace

// Johnson (8.21)-(8.27): xi = xi_full (1 - c/a), force = mu P (1 - c^2/a^2), c half the adhesion area.
Carter carter_of_creepage(const MaterialPair& bodies, const LineContact& contact, double mu, double xi) {
    const double full = full_creepage(bodies, contact, mu), size = std::abs(xi);
    const double ratio = size < full ? 1 - size / full : (size > 0 ? 0 : 1);
    const double force = -std::copysign(mu * contact.force * (1 - ratio * ratio), xi);
    return {xi, force, ratio * contact.half_width, (1 - ratio) * contact.half_width};
}

Carter carter_of_force(const MaterialPair& bodies, const LineContact& contact, double mu, double force) {
    const double ratio = std::sqrt(1 - std::abs(force) / (mu * contact.force));
    const double xi = -std::copysign(full_creepage(bodies, contact, mu) * (1 - ratio), force);
    return {xi, force, ratio * contact.half_width, (1 - ratio) * contact.half_width};
}

double carter_traction(const LineContact& contact, const Carter& carter, double mu, double x) {
    const double a = contact.half_width, c = carter.adhesion_half, from_centre = x - carter.adhesion_centre;
    const double slip = std::sqrt(std::max(0.0, a * a - x * x));
    const double adhesion = std::sqrt(std::max(0.0, c * c - from_centre * from_centre));
    return std::copysign(mu * contact.pmax / a * (slip - adhesion), carter.force);
}

// With q = highest/(mu Fn): 24/5 mu Fn K (1 - (1-q)^(5/3) - 5 q/6 (1 + (1-q)^(2/3))), K the shift of full slip.
double dissipated_work(const MaterialPair& bodies, const Hertz& hertz, double mu, double highest) {
    const double largest = mu * hertz.Fn, q = highest / largest;
    const double full = cattaneo(bodies, hertz, mu, largest).rigid_shift;
    const double left = std::cbrt(1 - q);
    return 4.8 * largest * full * (1 - std::pow(left, 5) - 5 * q / 6 * (1 + left * left));
}

}  // namespace contactd::reference

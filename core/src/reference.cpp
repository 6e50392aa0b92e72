#include "contactd/reference.hpp"

#include <cmath>
#include <numbers>

namespace contactd::reference {

// Johnson (4.22)-(4.24); 1/E* = (1-nu1)/(2 G1) + (1-nu2)/(2 G2).
Hertz hertz(const BodyPair& bodies, double R, double approach) {
    const auto compliance = [](const Material& body) { return (1 - body.nu) / (2 * body.G); };
    const double modulus = 1 / (compliance(bodies.upper) + compliance(bodies.lower));
    if (!(approach > 0)) return {0, 0, 0};
    const double radius = std::sqrt(R * approach);
    const double Fn = 4 * modulus * radius * approach / 3;
    return {radius, Fn, 1.5 * Fn / (std::numbers::pi * radius * radius)};
}

// Johnson (7.31), (7.40), (7.42): with c the adhesion radius, Fx = mu Fn (1 - c^3/a^3) and the shift is
// 3 mu Fn/(16 a) (1 - c^2/a^2) ((2-nu1)/G1 + (2-nu2)/G2).
Cattaneo cattaneo(const BodyPair& bodies, const Hertz& hertz, double mu, double Fx) {
    const auto compliance = [](const Material& body) { return (2 - body.nu) / body.G; };
    const double ratio = std::cbrt(1 - Fx / (mu * hertz.Fn));
    const double shift = 3 * mu * hertz.Fn / (16 * hertz.radius) * (1 - ratio * ratio) *
                         (compliance(bodies.upper) + compliance(bodies.lower));
    return {ratio * hertz.radius, shift};
}

}  // namespace contactd::reference

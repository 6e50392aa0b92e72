#include "ellipse_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace contactd {

// Along the straight line through a point at the angle t, the kernel's 1/rho cancels, and sqrt(1 - x^2/a^2 - y^2/b^2)
// integrates to a half-circle (as in Galin's theorem, Kalker 1990, section 5.A). With D = cos^2 t/a^2 + sin^2 t/b^2 and
// K_xx = 1 - nu + nu cos^2 t, K_yy = 1 - nu + nu sin^2 t, the displacement is
//     u_i = 3F/(4 pi G ab) I_0^pi K_ii D^-1/2 (1 - x^2 sin^2 t/(a^2 b^2 D) - ...) dt.
// The substitution tan t = tan s/sqrt(a/b) keeps the integrand smooth for slender ellipses: equally spaced s converge
// exponentially. A circle gives (2-nu)/4, (4-3nu)/32 and (4-nu)/32 of Johnson (3.91).
EllipseCompliance ellipse_compliance(const SemiAxes& axes, const Material& combined) {
    const double a = axes.a, b = axes.b, nu = combined.nu, ratio = a / b;
    const double slender = std::sqrt(std::min(ratio, 1 / ratio));
    const int points = static_cast<int>(std::min(8 + 12 / slender, 4096.0));
    EllipseCompliance sums{};
    for (int i = 0; i < points; ++i) {
        const double s = (i + 0.5) * 0.5 * std::numbers::pi / points;
        const double c2 = std::cos(s) * std::cos(s), s2 = 1 - c2;
        const double stretched = ratio * c2 + s2;
        const double cos2 = ratio * c2 / stretched, sin2 = s2 / stretched;  // of t
        const double D = cos2 / (a * a) + sin2 / (b * b);
        const double weight = std::sqrt(ratio / D) / stretched;  // dt/ds D^-1/2
        const double bend = weight * sin2 / (a * a * b * b * D);
        const double Kx = 1 - nu + nu * cos2, Ky = 1 - nu + nu * sin2;
        sums.centre_x += Kx * weight;
        sums.centre_y += Ky * weight;
        sums.along_x += Kx * bend;
        sums.along_y += Ky * bend;
    }
    const double unit = 3 / (4 * std::numbers::pi * combined.G * a * b) * std::numbers::pi / points;
    return {unit * sums.centre_x, unit * sums.centre_y, unit * sums.along_x, unit * sums.along_y};
}

// Each body's line forces displace the surface by (1-nu)/(pi G) ln(datum/|x|), and along the strip by 1/(pi G)
// ln(datum/|x|). The sum of both bodies is twice that of the combined material. Its integral over an elliptic traction
// is a parabola inside.
EllipseCompliance compliance_of(const EllipticContact& contact, const SemiAxes& axes) {
    if (!contact.is_strip()) return ellipse_compliance(axes, contact.combined);
    const double a = contact.axes.a, logarithm = std::log(2 * contact.datum / a) + 0.5;
    const double y = 2 / (std::numbers::pi * contact.combined.G * contact.length), x = (1 - contact.combined.nu) * y;
    return {x * logarithm, y * logarithm, x / (a * a), y / (a * a), 1 / logarithm};
}

}  // namespace contactd

// Computes Polach's forces of rolling (Polach 1999; Polach 2005), in closed form.
#pragma once

#include "rolling_theory.hpp"

namespace contactd {

template <class Number>
struct RollingForces {
    Number Fx{}, Fy{};
};

/// Returns the force 2 mu Fn/pi (kA eps/(1 + (kA eps)^2) + atan(kS eps)) against (xi, e), with e of lateral_with_spin,
/// eps = G pi a b C sqrt(xi^2 + e^2)/(4 mu Fn), and C11 and C22 blended by the direction of the creepage. The creepage
/// eta has its share of the lateral part, and spin adds the counterpart of the moment. Small creepages and a small spin
/// give Kalker's forces, full slip gives mu Fn.
template <class Number>
RollingForces<Number> polach(const RollingTheory& theory, const FastsimCreepages<Number>& w, double mu) {
    using std::abs, std::atan, std::sqrt;
    constexpr double pi = std::numbers::pi;
    RollingForces<Number> forces;
    const Number none{};
    if (!(mu > 0)) return forces;
    const auto [a, b] = theory.axes;
    const double bound = mu * theory.Fn;
    const Number e = lateral_with_spin(w, a);
    const Number size = sqrt(w.xi * w.xi + w.eta * w.eta), all = sqrt(w.xi * w.xi + e * e);
    if (!(all > none)) return forces;
    const Number longitudinal = theory.C.C11 * w.xi, lateral = theory.C.C22 * w.eta;
    const Number C =
        size > none ? Number(sqrt(longitudinal * longitudinal + lateral * lateral) / size) : Number(theory.C.C22);
    const Number eps = theory.G * pi * a * b / (4 * bound) * (C * all);
    const Number kA = theory.settings.k_adhesion * eps, kS = theory.settings.k_slip * eps;
    const Number force = -2 * bound / pi * (kA / (1 + kA * kA) + atan(kS));
    const double g = 1 + 6.3 * (1 - std::exp(-a / b));
    const Number eps_spin = 8.0 / 3 * theory.G * b * std::sqrt(a * b) * theory.C.C23 / (bound * g) * abs(e);
    const Number square = eps_spin * eps_spin, D = (square - 1) / (square + 1), rest = 1 - D * D;
    const Number KM = eps_spin * (D * D * D / 3.0 - 0.5 * (D * D) + 1.0 / 6) - rest * sqrt(rest) / 3.0;
    forces.Fx = force * w.xi / all;
    forces.Fy = force * w.eta / all + 9.0 / 16 * a * bound * g * (KM * w.phi / all);
    return forces;
}

}  // namespace contactd
